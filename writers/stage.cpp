#include "writers/stage.h"

#include <array>
#include <nlohmann/json.hpp>

#include "scene/stage_record.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

using nlohmann::ordered_json;
using scene::Material;
using scene::StageFace;
using scene::StagePlane;

ordered_json triple(const geom::dvec3& v) { return {v.x, v.y, v.z}; }

std::string text_of(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json material_json(const Material& material) {
  return {{"name", material.name},
          {"reflectance", triple(material.reflectance)},
          {"reflectanceStated", material.reflectance_stated},
          {"emission", triple(material.emission)},
          {"emissionUnit", material.emission_unit == Material::EmissionUnit::Luminance ? "luminance" : "exitance"},
          {"doubleSided", material.double_sided}};
}

const char* name(scene::RecordKind kind) {
  switch (kind) {
    case scene::RecordKind::Element:
      return "element";
    case scene::RecordKind::Item:
      return "item";
    case scene::RecordKind::ByteOffset:
      return "byte";
    case scene::RecordKind::Line:
      break;
  }
  return "line";
}

ordered_json ledger_entry_json(const scene::LedgerEntry& entry) {
  return {{"stage", entry.stage},
          {"operation", entry.operation},
          {"rules", entry.rules},
          {"count", entry.count},
          {"largestMovement", entry.largest_movement},
          {"areaChange", entry.area_change ? ordered_json(*entry.area_change) : ordered_json(nullptr)}};
}

/// Writes the members one after the other; long lists get a line for each item.
class StageWriter {
 public:
  StageWriter(const Output& output, std::string& text)
      : output_(output), scene_(output.scene), record_(*output.scene.stage), text_(text) {}

  void run() {
    text_ = "{";
    member("format", "radfix-stage");
    member("version", 1);
    member("generator", program_name());
    member("stage", record_.stage);
    member("incomplete", output_.marked_incomplete);
    const geom::Lattice& lattice = output_.lattice->lattice;
    member("lattice", {{"pitch", lattice.pitch}, {"origin", triple(lattice.origin)}});
    member("tolerance", output_.lattice->tolerance);
    member("workTolerance", record_.work_tolerance);
    member("overlaps", record_.overlaps_resolved ? "resolved" : "kept");
    member("metresPerUnit", scene_.metres_per_unit ? ordered_json(*scene_.metres_per_unit) : ordered_json(nullptr));
    member("up", scene_.up == scene::UpAxis::Unknown ? ordered_json(nullptr)
                                                     : ordered_json(scene_.up == scene::UpAxis::Y ? "y" : "z"));
    list("materials", scene_.materials, [&](const Material& material) { text_ += text_of(material_json(material)); });
    member("objects", scene_.objects);
    member("groups", scene_.groups);
    list("sources", scene_.sections, [&](const scene::SourceSection& section) {
      text_ += text_of({{"file", section.file}, {"pointer", section.pointer}, {"record", name(section.kind)}});
    });
    list("vertices", record_.vertices, [&](const geom::dvec3& v) { append_all(std::array{v.x, v.y, v.z}); });
    list("points", record_.points, [&](const geom::LatticePoint& point) {
      append_all(std::array{point.x, point.y, point.z});
    });
    list("planes", record_.planes, [&](const StagePlane& plane) { append_plane(plane); });
    list("faces", record_.faces, [&](const StageFace& face) { append_face(face); });
    list("ledger", record_.ledger,
         [&](const scene::LedgerEntry& entry) { text_ += text_of(ledger_entry_json(entry)); });
    text_ += "\n}\n";
  }

 private:
  void open(std::string_view key) {
    text_ += text_.size() > 1 ? ",\n  \"" : "\n  \"";
    text_ += key;
    text_ += "\": ";
  }

  void member(std::string_view key, const ordered_json& value) {
    open(key);
    text_ += text_of(value);
  }

  template <typename Items, typename Append>
  void list(std::string_view key, const Items& items, Append&& append) {
    open(key);
    text_ += '[';
    bool first = true;
    for (const auto& item : items) {
      text_ += first ? "\n    " : ",\n    ";
      first = false;
      append(item);
    }
    text_ += first ? "]" : "\n  ]";
  }

  template <typename Numbers>
  void append_all(const Numbers& numbers) {
    text_ += '[';
    bool first = true;
    for (const auto number : numbers) {
      if (!first) text_ += ',';
      first = false;
      append_number(text_, number);
    }
    text_ += ']';
  }

  template <typename Items, typename Append>
  void append_list(const Items& items, Append&& append) {
    text_ += '[';
    bool first = true;
    for (const auto& item : items) {
      if (!first) text_ += ',';
      first = false;
      append(item);
    }
    text_ += ']';
  }

  void append_plane(const StagePlane& plane) {
    text_ += "{\"normal\":" + text_of(triple(plane.normal)) + ",\"offset\":" + text_of(plane.offset) +
             ",\"area\":" + text_of(plane.area) + ",\"slits\":";
    append_list(plane.slits, [&](const auto& slit) { append_all(slit); });
    text_ += ",\"points\":";
    append_all(plane.points);
    text_ += '}';
  }

  void append_field(std::string_view key, std::uint64_t value) {
    text_ += ",\"";
    text_ += key;
    text_ += "\":";
    append_number(text_, value);
  }

  void append_face(const StageFace& face) {
    text_ += "{\"loops\":";
    append_list(record_.loops_of(face), [&](const scene::Loop& loop) { append_all(record_.corners_of(loop)); });
    append_field("material", face.material);
    append_field("object", face.object);
    append_field("group", face.group);
    text_ += ",\"sources\":";
    append_list(face.sources, [&](const scene::SourceRef& source) {
      append_all(std::array<std::uint64_t, 2>{source.section, source.record});
    });
    if (!record_.planes.empty()) {
      append_field("plane", face.plane);
      text_ += face.along ? ",\"along\":true" : ",\"along\":false";
      append_field("surfaceRank", face.surface_rank);
      text_ += ",\"triangles\":";
      append_list(face.triangles, [&](const auto& triangle) { append_all(triangle); });
    }
    text_ += '}';
  }

  const Output& output_;
  const scene::Scene& scene_;
  const scene::StageRecord& record_;
  std::string& text_;
};

}  // namespace

std::string stage_text(const Output& output, std::string& text) {
  if (std::string problem = problem_of(output); !problem.empty()) return problem;
  const scene::StageRecord* const record = output.scene.stage.get();
  if (record == nullptr || !output.lattice || record->face_of.size() != output.scene.faces.size()) {
    return "this is no model between two filters, so there is no stage file of it";
  }
  StageWriter(output, text).run();
  return {};
}

WriteResult write_stage(const Output& output, const std::filesystem::path& path) {
  std::string text;
  if (std::string problem = stage_text(output, text); !problem.empty()) return {std::move(problem)};
  return {write_whole_file(path, text)};
}

}  // namespace rad::writers
