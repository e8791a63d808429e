// DXF as text: sections, blocks and what INSERT places.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numbers>

#include "readers/dxf_polyline.h"
#include "readers/reader.h"
#include "readers/recorded_comment.h"
#include "readers/refusals.h"
#include "scene/index_colour.h"

namespace rad::readers {

extern const Reader dxf_reader;

namespace dxf {
namespace {

using scene::ReadIssueKind;

constexpr std::array<std::string_view, 1> kSuffixes = {".dxf"};
constexpr std::string_view kBinaryMark = "AutoCAD Binary DXF";
constexpr std::int64_t kExternalReference = 4;
constexpr std::size_t kLongestPath = 255;  ///< of nested block names
// Bodies whose surfaces are written for the ACIS modeller alone.
constexpr std::array<std::string_view, 10> kBodies = {
    "3DSOLID",         "BODY",         "REGION",       "SURFACE",    "EXTRUDEDSURFACE", "LOFTEDSURFACE",
    "REVOLVEDSURFACE", "SWEPTSURFACE", "PLANESURFACE", "NURBSURFACE"};

struct Block {
  Groups entities;  ///< stands before the first
  dvec3 base{0, 0, 0};
  bool is_external = false;
  bool is_open = false;  ///< being placed: its own inserts may not name it
};

class DxfReader {
 public:
  explicit DxfReader(const Input& input)
      : input_(input),
        groups_(input.bytes, input.limits.line_bytes),
        builder_(input.path, "dxf"),
        surfaces_(input, layers_, builder_, issues_) {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
    scene::Scene& scene = builder_.scene();
    scene.up = scene::UpAxis::Z;
    scene.splits_vertices = true;
  }

  ReadResult run() {
    if (input_.bytes.starts_with(kBinaryMark)) {
      refuse("binary DXF is not read; save as ASCII DXF", 1);
    } else {
      read_record();
      read_sections();
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void refuse(std::string what, std::uint64_t line) {
    issues_.add(issue_at_line(ReadIssueKind::ParseError, std::move(what), line));
  }

  // In the comments (code 999) at the head.
  void read_record() {
    TextCursor cursor(input_.bytes, input_.limits.line_bytes);
    while (cursor.next_line() && cursor.rest() == "999" && cursor.next_line()) {
      if (const auto record = record_of_comment(cursor.rest())) builder_.scene().recorded = record;
    }
  }

  void read_sections() {
    bool ended = false, any = false;
    while (!ended && groups_.next()) {
      ended = groups_.group().starts("EOF");
      if (!groups_.group().starts("SECTION") || !groups_.next()) continue;
      any = true;
      read_section(groups_.group().value);
    }
    if (!groups_.problem().empty()) return refuse(groups_.problem(), groups_.line());
    if (!any) return refuse("the file holds no section of DXF", 1);
    if (!ended) refuse("the file ends without EOF", groups_.line());
  }

  void read_section(std::string_view name) {
    if (name == "HEADER") {
      builder_.scene().metres_per_unit = read_header_unit(groups_);
    } else if (name == "TABLES") {
      read_layers(groups_, layers_, issues_);
    } else if (name == "BLOCKS") {
      read_blocks();
    } else if (name == "ENTITIES") {
      read_entities(groups_, Placement());
    } else {
      while (groups_.next() && !groups_.group().starts("ENDSEC")) continue;
    }
  }

  void read_blocks() {
    while (groups_.next() && !groups_.group().starts("ENDSEC")) {
      if (!groups_.group().starts("BLOCK")) continue;
      const Entity head(groups_, issues_);
      Block block{groups_, head.point(10), (head.integer(70) & kExternalReference) != 0, false};
      blocks_.insert_or_assign(folded(head.text(2)), std::move(block));
      while (groups_.next() && !groups_.group().starts("ENDBLK")) {
        if (groups_.group().starts("ENDSEC")) return groups_.step_back();
      }
    }
  }

  // Up to ENDSEC or ENDBLK.
  void read_entities(Groups& groups, const Placement& placement) {
    if (!groups.next()) return;
    Entity entity(groups, issues_);
    while (entity.type() != "ENDSEC" && entity.type() != "ENDBLK" && entity.type() != "EOF" && !surfaces_.full()) {
      read_entity(entity, groups, placement);
      if (!groups.next()) return;
      if (groups.group().code == 0) entity.read(groups);
    }
    if (entity.type() == "EOF") groups.step_back();
  }

  void read_entity(const Entity& entity, Groups& groups, const Placement& placement) {
    if (entity.type() == "POLYLINE") {
      const bool visible = surfaces_.begin(entity, placement);
      return read_polyline(entity, groups, visible, surfaces_, issues_);
    }
    if (entity.type() == "INSERT") return insert(entity, placement);
    if (entity.type() == "ATTRIB" || entity.type() == "SEQEND") return;
    if (!surfaces_.begin(entity, placement)) return;
    if (entity.type() == "MESH") return add_mesh(entity, surfaces_);
    if (add_simple_entity(entity, surfaces_)) return;
    const bool body = std::ranges::find(kBodies, entity.type()) != kBodies.end();
    surfaces_.count_unsupported(
        std::string(entity.type()) + (body ? " entities (ACIS bodies: convert them to meshes)" : " entities"),
        entity.line());
  }

  void insert(const Entity& entity, const Placement& outer) {
    if (entity.integer(60) == 1 || entity.integer(67) == 1) {
      return surfaces_.count_unsupported("entities that are hidden or on layers that are off or frozen", entity.line());
    }
    const auto found = blocks_.find(folded(entity.text(2)));
    if (found == blocks_.end()) {
      return refuse("INSERT of block " + in_quotes(entity.text(2)) + ", which does not exist", entity.line());
    }
    Block& block = found->second;
    if (block.is_external) return surfaces_.count_unsupported("external references (XREF)", entity.line());
    if (block.is_open || outer.depth >= input_.limits.node_depth) {
      return refuse("block " + in_quotes(entity.text(2)) + " is placed within itself, or too deep", entity.line());
    }
    block.is_open = true;
    place_array(entity, block, outer);
    block.is_open = false;
  }

  void place_array(const Entity& entity, const Block& block, const Placement& outer) {
    const auto count = [&](int code) { return std::clamp<std::int64_t>(entity.integer(code, 1), 1, 32767); };
    Placement inner = inherited(entity, outer);
    const glm::dmat4 frame = outer.world * frame_of(entity);
    const dvec3 step(entity.number(44), entity.number(45), 0);
    const dvec3 scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
    const std::int64_t columns = count(70), rows = count(71);
    for (std::int64_t row = 0; row < rows; ++row) {
      for (std::int64_t column = 0; column < columns; ++column) {
        const dvec3 offset(step.x * static_cast<double>(column), step.y * static_cast<double>(row), 0);
        inner.world = glm::translate(glm::scale(glm::translate(frame, offset), scale), -block.base);
        if (!place(block, inner, entity.line())) return;
      }
    }
  }

  // Inserts may describe far more than the file holds: both their number and the text read for them are limited.
  bool place(const Block& block, const Placement& placement, std::uint64_t line) {
    if (surfaces_.full() || placing_stopped_) return false;
    Groups groups = block.entities;
    const std::uint64_t from = groups.offset();
    if (++inserts_ <= input_.limits.instances && replayed_ <= input_.limits.file_bytes) {
      read_entities(groups, placement);
      replayed_ += groups.offset() - from;
      return true;
    }
    placing_stopped_ = true;
    refuse("blocks are placed too often; the rest is left out", line);
    return false;
  }

  Placement inherited(const Entity& entity, const Placement& outer) {
    const Colour colour = surfaces_.colour_of(entity, outer);
    Placement inner;
    inner.layer = surfaces_.layer_of(entity, outer).name;
    inner.colour = colour.index;
    inner.true_colour = colour.true_colour;
    inner.block = outer.block.empty() ? std::string(entity.text(2)) : outer.block + "/" + std::string(entity.text(2));
    inner.block.resize(std::min(inner.block.size(), kLongestPath));
    inner.insert = outer.insert.empty() ? std::string(entity.text(5)) : outer.insert;
    inner.depth = outer.depth + 1;
    return inner;
  }

  // Of the place and the rotation; scaling comes after the step of an array.
  static glm::dmat4 frame_of(const Entity& entity) {
    const glm::dmat4 frame = object_frame(entity.point(210, {0, 0, 1}));
    const double angle = entity.number(50) * std::numbers::pi / 180;
    return glm::rotate(glm::translate(frame, entity.point(10)), angle, dvec3(0, 0, 1));
  }

  const Input& input_;
  Groups groups_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Layers layers_;
  Surfaces surfaces_;
  std::map<std::string, Block> blocks_;
  std::uint64_t inserts_ = 0;
  std::uint64_t replayed_ = 0;
  bool placing_stopped_ = false;
};

bool sniff(std::string_view head) {
  if (head.starts_with(kBinaryMark)) return true;
  Groups groups(head, kSniffBytes);
  if (!groups.next() || !groups.group().starts("SECTION") || !groups.next()) return false;
  return groups.group().code == 2;
}

ReadResult read(const Input& input) { return DxfReader(input).run(); }

}  // namespace
}  // namespace dxf

const Reader dxf_reader{"dxf", dxf::kSuffixes, dxf::sniff, dxf::read};

}  // namespace rad::readers
