// A rule: one constant in one file under rules/, listed once in rules.def. Its text is the only source of
// `radlint rule`, of docs/rules/ and of every report's rule table.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/finding.h"
#include "scene/read_issue.h"
#include "validate/parameter.h"
#include "validate/violation.h"

namespace rad::validate {

struct Context;

/// What a check appends to.
struct Violations {
  std::vector<Violation> items;
  std::deque<std::string> words;

  void add(const Violation& violation) { items.push_back(violation); }
  /// Keeps a text for the {detail} of a violation, where no fixed set of literals can say it.
  std::string_view keep(std::string text) { return words.emplace_back(std::move(text)); }
};

/// Cluster key of rules that judge face by face: one finding for all faces of the same object and material.
inline constexpr std::uint64_t kPerParticipants = 1;

/// Cluster key of rules that judge the model as a whole: one finding, whatever the objects and materials.
inline constexpr std::uint64_t kWholeModel = ~std::uint64_t{0} >> 1;

/// The paper's requirement that a rule belongs to (Tables 1 and 2), or the area outside the paper.
enum class Requirement : std::uint8_t {
  SolidModel,               ///< 1a
  NormalConsistency,        ///< 1b
  MaximalPlanarFaces,       ///< 1c
  NoTVertices,              ///< 2a
  NoImplicitIntersections,  ///< 2b
  NoOverlappingFaces,       ///< 2c
  SimpleFaces,              ///< 2d
  WellShapedFaces,          ///< 2e
  RadiatorDensity,          ///< 2f
  ReceiverDensity,          ///< 2g
  Ziplocking,               ///< 3a
  Input,
  Materials,
  Units,
};

enum class MeasureUnit : std::uint8_t { None, Length, Area, Volume, Ratio, Count };

/// What the measure of a violation is. Length, Area and Volume are in file units and their powers.
struct MeasureText {
  std::string_view name;  ///< empty where the rule has no measure
  MeasureUnit unit = MeasureUnit::None;
  bool smaller_is_worse = false;
};

/// The text of a rule, in plain sentences. All fields are filled; a test asserts it.
struct Doc {
  std::string_view what;      ///< what is wrong
  std::string_view why;       ///< what it does to a radiosity solution; the paper's section
  std::string_view how;       ///< the test and its tolerance
  std::string_view fix;       ///< what to do: radfix, and by hand
  std::string_view modeller;  ///< the same in the vocabulary of SketchUp, Revit, Rhino, Blender
  std::string_view limits;    ///< known false alarms and misses
};

struct Rule {
  std::string_view id;     ///< "RL201"
  std::string_view alias;  ///< "t-vertex": the fault, never the remedy
  std::string_view title;  ///< one line for tables
  /// Message of a finding. Placeholders: {n} violations, {s} plural s, {one|many} by number, {measure} with unit,
  /// {limit} threshold with unit, {segment} of the worst violation, {object} participants, {material} their materials,
  /// {detail}; {area} and {advice}, which --tolerance keeps it, where violations have them.
  std::string_view message;
  Requirement requirement = Requirement::Input;
  /// Severity outside the paper's tables; for 1a…3a the stage decides and this is the highest it may reach.
  scene::Severity severity = scene::Severity::Error;
  scene::FindingKind kind = scene::FindingKind::Fail;
  /// Severity at stage solve of violations that are `grave`: outside the tables, what no solution can be had with.
  std::optional<scene::Severity> grave_at_solve{};
  /// The fault lies in the format where it can hold triangles only: then it is a note.
  bool note_where_triangles_only = false;
  MeasureText measure;
  scene::FixClass fix = scene::FixClass::None;
  std::string_view fix_operation;  ///< of radfix
  std::string_view citation;       ///< "baum91 2.2"
  Doc doc;
  std::span<const Parameter> parameters{};  ///< thresholds that configuration may set
  /// Exactly one of the three is set.
  void (*check)(const Context& context, Violations& out) = nullptr;
  std::optional<scene::ReadIssueKind> reports;  ///< findings come straight from the reader
  bool of_tool = false;                         ///< about the run and not the model; findings by tool_finding()
  /// Threshold the measure is held against, in file units (or 1); null where there is none.
  double (*threshold)(const Context& context) = nullptr;
};

std::string_view code(Requirement requirement);   ///< "1a", "input"
std::string_view title(Requirement requirement);  ///< "no T-vertices"

}  // namespace rad::validate
