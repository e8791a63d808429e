// Judging a scene: runs rules over it and groups what they report.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/tolerance.h"
#include "scene/finding.h"
#include "scene/read_issue.h"
#include "scene/waiver.h"
#include "validate/parameter.h"
#include "validate/registry.h"
#include "validate/stage.h"

namespace rad::validate {

/// What findings of a rule weigh where faces of these names take part.
struct NamedSeverity {
  scene::NamePatterns names;
  const Rule* rule = nullptr;  ///< never null
  scene::Severity severity = scene::Severity::Error;
};

/// A threshold of a rule where faces of these names take part. Faults without a face know no names.
struct NamedThreshold {
  scene::NamePatterns names;
  const Rule* rule = nullptr;  ///< never null
  std::string_view parameter;  ///< one of the rule's
  double value = 0;            ///< within its limits
};

struct LintOptions {
  Stage stage = Stage::Model;
  std::vector<const Rule*> rules{all_rules().begin(), all_rules().end()};
  std::optional<geom::ToleranceRequest> tolerance;  ///< nothing: default_tolerance
  bool group = true;                                ///< false: one finding per violation
  bool light = true;                                ///< stage solve asks for light that a solution exists for
  ParameterValues parameters;                       ///< thresholds of rules that differ from the standard ones
  /// Severities in place of those of the stage; such a rule is checked at every stage.
  std::map<const Rule*, scene::Severity> severities{};
  std::vector<NamedSeverity> named_severities{};   ///< of several that fit the last counts
  std::vector<NamedThreshold> named_thresholds{};  ///< likewise, for each parameter
  std::vector<scene::Waiver> waivers{};            ///< what is not to be reported, and where
};

/// Seconds per named step, in order; for --timings only, never part of a default report.
using Timings = std::vector<std::pair<std::string, double>>;

struct ModelFigures {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;
  std::size_t objects = 0;  ///< connected components
  std::size_t materials = 0;
  std::size_t emitters = 0;  ///< faces of emitting materials
};

/// A waiver that silenced something.
struct SuppressionUse {
  scene::WaiverOrigin origin = scene::WaiverOrigin::Model;
  std::vector<std::string> rules;  ///< as written
  std::string reason;
  scene::IssuePlace place;     ///< with its file
  std::uint64_t findings = 0;  ///< clusters of violations that it silenced
  std::uint64_t places = 0;    ///< violations
};

struct SuppressedFinding {
  scene::Finding finding;
  std::size_t by = 0;  ///< into LintResult::suppressions
};

struct LintResult {
  std::vector<scene::Finding> findings;      ///< canonical order: severity, rule, place
  std::optional<geom::Tolerance> tolerance;  ///< nothing where no surface could be read
  double pitch = 0;                          ///< of the lattice, file units
  geom::dvec3 lattice_origin{0, 0, 0};
  ModelFigures figures;
  std::vector<const Rule*> checked;  ///< rules that ran
  std::vector<SuppressionUse> suppressions;
  std::vector<SuppressedFinding> suppressed;  ///< not among the findings; grouped like them, in the order of waivers
  std::string incomplete;                     ///< what was not judged to the end, and why; empty where all was
  std::string refusal;                        ///< why the tolerance asked for cannot be used; then nothing was judged
  Timings timings;
};

/// The severity of a finding of a rule about the run.
scene::Severity severity_of_tool_rule(const Rule& rule, const LintOptions& options);

/// Judges `scene` by the rules chosen. `issues` are what the reader reported. Uses the calling thread's task arena;
/// the result does not depend on the number of threads, nor (but for face references) on the order of faces.
LintResult lint(const scene::Scene& scene, const scene::ReadIssues& issues, const LintOptions& options);

}  // namespace rad::validate
