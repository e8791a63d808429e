// Stage files: models between two filters of radfix, as JSON (docs/stage-format.md).
#include <array>
#include <cmath>

#include "readers/json_view.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/stage_planes.h"
#include "scene/stage_record.h"

namespace rad::readers {

extern const Reader stage_reader;

namespace {

using scene::ReadIssueKind;
using scene::StageRecord;

constexpr std::array<std::string_view, 1> kSuffixes = {".stage.json"};
constexpr std::string_view kMark = "\"radfix-stage\"";
constexpr std::uint64_t kVersion = 1;

bool sniff(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && head[first] == '{' && head.find(kMark) != std::string_view::npos;
}

class StageReader {
 public:
  explicit StageReader(const Input& input) : input_(input), names_(scene::empty_scene(input.path, "stage")) {}

  ReadResult run() {
    if (!parse() || !read_members()) return {std::move(names_), std::move(issues_)};
    keep_planes();
    return {scene::scene_of_stage(names_, std::move(record_), *recorded_), std::move(issues_)};
  }

 private:
  void report(std::string what, std::string pointer) { add_parse_error(issues_, std::move(what), std::move(pointer)); }

  bool parse() {
    auto json = parse_json_object(input_.bytes, 0, "a stage file", issues_);
    if (!json) return false;
    json_ = std::move(*json);
    const JsonView root = this->root();
    if (root.text("format") != "radfix-stage") {
      report("this is not a stage file of radfix", "/format");
      return false;
    }
    if (root.whole("version") == kVersion) return true;
    report("only version " + std::to_string(kVersion) + " of stage files is read", "/version");
    return false;
  }

  [[nodiscard]] JsonView root() { return JsonView(json_, "", issues_); }

  // False where nothing can be made of it.
  bool read_members() {
    record_.stage = root().text("stage");
    record_.work_tolerance = root().number("workTolerance").value_or(0);
    record_.overlaps_resolved = root().text("overlaps") == "resolved";
    read_frame();
    if (!recorded_) {
      report("without its lattice and tolerance a stage file has no geometry", "/lattice");
      return false;
    }
    read_names();
    if (!read_vertices()) return false;
    read_planes();
    read_faces();
    read_ledger();
    return true;
  }

  void read_frame() {
    const JsonView lattice = root().object("lattice");
    const auto pitch = lattice.number("pitch"), tolerance = root().number("tolerance");
    const auto origin = lattice.numbers("origin", 3);
    if (!pitch || !origin || !tolerance) return;
    recorded_ = scene::RecordedLattice{{*pitch, {(*origin)[0], (*origin)[1], (*origin)[2]}}, *tolerance};
    const auto metres = is_null("metresPerUnit") ? std::nullopt : root().number("metresPerUnit");
    if (metres && std::isfinite(*metres) && *metres > 0) names_.metres_per_unit = metres;
    const std::string up = is_null("up") ? std::string() : root().text("up");
    if (up == "y") names_.up = scene::UpAxis::Y;
    if (up == "z") names_.up = scene::UpAxis::Z;
  }

  [[nodiscard]] bool is_null(const char* key) const {
    const auto member = json_.find(key);
    return member == json_.end() || member->is_null();
  }

  void read_names() {
    scene::Scene& scene = names_;
    if (auto names = root().texts("objects"); !names.empty()) scene.objects = std::move(names);
    if (auto names = root().texts("groups"); !names.empty()) scene.groups = std::move(names);
    const std::size_t materials = root().length("materials");
    if (materials > 0) scene.materials.clear();
    for (std::size_t i = 0; i < materials; ++i) read_material(root().item("materials", i));
    for (std::size_t i = 0; i < root().length("sources"); ++i) {
      const JsonView source = root().item("sources", i);
      const std::string record = source.text("record");
      const auto kind = record == "element" ? scene::RecordKind::Element
                        : record == "item"  ? scene::RecordKind::Item
                        : record == "byte"  ? scene::RecordKind::ByteOffset
                                            : scene::RecordKind::Line;
      scene.sections.push_back({source.text("file"), source.text("pointer"), kind});
    }
    own_section_ = static_cast<std::uint32_t>(scene.sections.size());
    scene.sections.push_back({input_.path, "/faces", scene::RecordKind::Element});
  }

  void read_material(const JsonView& view) {
    scene::Material material;
    material.name = view.text("name");
    const auto triple = [&](const char* key, geom::dvec3& into) {
      if (const auto numbers = view.numbers(key, 3)) into = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    };
    triple("reflectance", material.reflectance);
    triple("emission", material.emission);
    material.reflectance_stated = view.flag("reflectanceStated").value_or(false);
    material.double_sided = view.flag("doubleSided").value_or(false);
    if (view.text("emissionUnit") == "luminance") material.emission_unit = scene::Material::EmissionUnit::Luminance;
    names_.materials.push_back(std::move(material));
  }

  // Points on the lattice, or vertices of a model that nothing was done to. One that cannot be read keeps its place, so
  // that later indices do not shift.
  bool read_vertices() {
    const bool places = json_.contains("vertices") && json_["vertices"].is_array() && !json_["vertices"].empty();
    const std::string key = places ? "vertices" : "points";
    const auto list = json_.find(key);
    if (list == json_.end() || !list->is_array()) {
      report("there is no array of points", "/points");
      return false;
    }
    if (std::string full = limit_before_vertices(names_, list->size(), input_.limits); !full.empty()) {
      report(std::move(full), "/" + key);
      return false;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Json& item = (*list)[i];
      const auto point = places ? std::nullopt : lattice_point(item);
      const auto place = places ? place_of(item) : std::nullopt;
      if (!point && !place) {
        const char* const what = places ? "three numbers" : "three whole numbers below 2^23 in magnitude";
        report(std::string("a point is not ") + what, "/" + key + "/" + std::to_string(i));
        sound_ = false;
      }
      vertices_.push_back(point ? recorded_->lattice.position(*point) : place.value_or(geom::dvec3(std::nan(""))));
      if (!places) record_.points.push_back(point.value_or(geom::LatticePoint{0, 0, 0}));
    }
    sound_ = sound_ && !places;
    return true;
  }

  static std::optional<geom::dvec3> place_of(const Json& json) {
    if (!json.is_array() || json.size() != 3) return std::nullopt;
    geom::dvec3 place;
    for (int axis = 0; axis < 3; ++axis) {
      const Json& number = json[static_cast<std::size_t>(axis)];
      if (!number.is_number()) return std::nullopt;
      place[axis] = number.get<double>();
    }
    return place;
  }

  static std::optional<geom::LatticePoint> lattice_point(const Json& json) {
    if (!json.is_array() || json.size() != 3) return std::nullopt;
    std::array<std::int32_t, 3> axes{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!json[k].is_number_integer()) return std::nullopt;
      const bool fits = json[k].is_number_unsigned() ? json[k].get<std::uint64_t>() < geom::kLatticeLimit
                                                     : json[k].get<std::int64_t>() > -geom::kLatticeLimit;
      if (!fits) return std::nullopt;
      axes[k] = json[k].get<std::int32_t>();
    }
    return geom::LatticePoint{axes[0], axes[1], axes[2]};
  }

  // A whole number below `limit`.
  static std::optional<std::uint32_t> index(const Json& json, std::size_t limit) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= limit) return std::nullopt;
    return json.get<std::uint32_t>();
  }

  // Whole numbers below `limit`; nothing where one is none.
  static std::optional<std::vector<std::uint32_t>> indices(const Json& json, std::size_t limit) {
    if (!json.is_array()) return std::nullopt;
    std::vector<std::uint32_t> found;
    for (const Json& item : json) {
      const auto value = index(item, limit);
      if (!value) return std::nullopt;
      found.push_back(*value);
    }
    return found;
  }

  void read_planes() {
    for (std::size_t i = 0; i < root().length("planes"); ++i) {
      const JsonView view = root().item("planes", i);
      scene::StagePlane plane;
      const auto normal = view.numbers("normal", 3);
      const auto offset = view.number("offset"), area = view.number("area");
      sound_ = sound_ && normal && offset && area;
      if (normal) plane.normal = {(*normal)[0], (*normal)[1], (*normal)[2]};
      plane.offset = offset.value_or(0);
      plane.area = area.value_or(0);
      if (view) read_drawn(json_["planes"][i], plane);
      record_.planes.push_back(std::move(plane));
    }
  }

  void read_drawn(const Json& json, scene::StagePlane& plane) {
    const auto slits = json.find("slits"), points = json.find("points");
    if (slits != json.end() && slits->is_array()) {
      for (const Json& slit : *slits) {
        const auto ends = indices(slit, vertices_.size());
        const bool good = ends && ends->size() == 2 && (*ends)[0] != (*ends)[1];
        sound_ = sound_ && good;
        if (good) plane.slits.push_back({(*ends)[0], (*ends)[1]});
      }
    }
    if (points == json.end()) return;
    const auto drawn = indices(*points, vertices_.size());
    sound_ = sound_ && drawn;
    if (drawn) plane.points = *drawn;
  }

  void read_faces() {
    const auto faces = json_.find("faces");
    if (faces == json_.end() || !faces->is_array()) return report("there is no array of faces", "/faces");
    for (std::size_t i = 0; i < faces->size(); ++i) {
      if (!(*faces)[i].is_object()) {
        report("a face is not an object; it is left out", "/faces/" + std::to_string(i));
        sound_ = false;
      } else if (!read_face((*faces)[i], i)) {
        break;
      }
    }
  }

  // Whether there was room for it.
  bool read_face(const Json& json, std::size_t number) {
    const std::string pointer = "/faces/" + std::to_string(number);
    const auto loops = loops_of(json, pointer);
    if (!loops) {
      sound_ = false;
      return true;
    }
    if (!has_room(*loops)) {
      report("the limit of faces or of their corners is reached; the rest is left out", pointer);
      sound_ = false;
      return false;
    }
    scene::StageFace& face = record_.faces.emplace_back();
    face.first_loop = static_cast<std::uint32_t>(record_.loops.size());
    for (const auto& loop : *loops) record_.add_loop(loop);
    face.material = name_index(json, "material", names_.materials.size(), pointer);
    face.object = name_index(json, "object", names_.objects.size(), pointer);
    face.group = name_index(json, "group", names_.groups.size(), pointer);
    read_sources(json, pointer, face, number);
    if (!record_.planes.empty()) read_place_in_plane(json, face);
    return true;
  }

  [[nodiscard]] bool has_room(const std::vector<std::vector<std::uint32_t>>& loops) const {
    std::uint64_t corners = record_.corners.size() + triangle_corners_;
    for (const auto& loop : loops) corners += loop.size();
    return record_.faces.size() + triangle_corners_ / 3 < input_.limits.faces && corners <= input_.limits.corners;
  }

  std::optional<std::vector<std::vector<std::uint32_t>>> loops_of(const Json& json, const std::string& pointer) {
    const auto member = json.find("loops");
    if (member == json.end() || !member->is_array() || member->empty()) {
      report("a face has no loops; it is left out", pointer);
      return std::nullopt;
    }
    std::vector<std::vector<std::uint32_t>> loops;
    for (const Json& item : *member) {
      auto loop = indices(item, vertices_.size());
      if (!loop || loop->size() > input_.limits.face_corners) {
        scene::ReadIssue issue{ReadIssueKind::IndexOutOfRange, "a loop is not a list of points of the file", {}, 1};
        issue.place.pointer = pointer + "/loops";
        issues_.add(std::move(issue));
        return std::nullopt;
      }
      loops.push_back(std::move(*loop));
    }
    return loops;
  }

  std::uint32_t name_index(const Json& json, const char* key, std::size_t limit, const std::string& pointer) {
    const auto member = json.find(key);
    if (member == json.end()) return 0;
    const auto found = index(*member, limit);
    if (!found) report("\"" + std::string(key) + "\" is not an index of its table", pointer + "/" + key);
    return found.value_or(0);
  }

  void read_sources(const Json& json, const std::string& pointer, scene::StageFace& face, std::size_t number) {
    const auto member = json.find("sources");
    if (member != json.end() && member->is_array()) {
      for (const Json& item : *member) {
        const bool pair = item.is_array() && item.size() == 2 && item[1].is_number_unsigned();
        const auto section = pair ? index(item[0], own_section_) : std::nullopt;
        if (section) {
          face.sources.push_back({*section, item[1].get<std::uint64_t>()});
        } else {
          report("a source is not a section and a record", pointer + "/sources");
        }
      }
    }
    if (face.sources.empty()) face.sources.push_back({own_section_, number});
  }

  void read_place_in_plane(const Json& json, scene::StageFace& face) {
    const auto plane = json.find("plane"), along = json.find("along"), rank = json.find("surfaceRank");
    const auto found = plane == json.end() ? std::nullopt : index(*plane, record_.planes.size());
    sound_ = sound_ && found && along != json.end() && along->is_boolean();
    face.plane = found.value_or(0);
    face.along = along == json.end() || !along->is_boolean() || along->get<bool>();
    if (rank != json.end()) face.surface_rank = index(*rank, 0xffffffffu).value_or(0);
    const auto triangles = json.find("triangles");
    sound_ = sound_ && triangles != json.end() && triangles->is_array();
    if (!sound_) return;
    for (const Json& item : *triangles) {
      const auto corners = indices(item, vertices_.size());
      const bool good = corners && corners->size() == 3;
      sound_ = sound_ && good;
      if (good) face.triangles.push_back({(*corners)[0], (*corners)[1], (*corners)[2]});
    }
    triangle_corners_ += 3 * face.triangles.size();
  }

  void read_ledger() {
    for (std::size_t i = 0; i < root().length("ledger"); ++i) {
      const JsonView view = root().item("ledger", i);
      scene::LedgerEntry entry;
      entry.stage = view.text("stage");
      entry.operation = view.text("operation");
      entry.rules = view.texts("rules");
      entry.count = view.whole("count").value_or(0);
      entry.largest_movement = view.number("largestMovement").value_or(0);
      if (const auto change = json_["ledger"][i].find("areaChange");
          view && change != json_["ledger"][i].end() && change->is_number()) {
        entry.area_change = change->get<double>();
      }
      record_.ledger.push_back(std::move(entry));
    }
  }

  // Planes that do not fit the faces would lead the filters astray: then the model is its faces alone.
  void keep_planes() {
    if (!record_.planes.empty()) {
      if (sound_ && planes_fit(record_, recorded_->tolerance / recorded_->lattice.pitch)) return;
      report("the planes do not fit the faces; they are left out", "/planes");
    }
    record_.planes.clear();
    record_.points.clear();
    record_.overlaps_resolved = false;
    record_.vertices = std::move(vertices_);
    for (scene::StageFace& face : record_.faces) face.triangles.clear();
  }

  const Input& input_;
  scene::Scene names_;  ///< materials, names, sections, unit and axis
  scene::ReadIssues issues_;
  Json json_;
  StageRecord record_;
  std::vector<geom::dvec3> vertices_;  ///< of the points or vertices, file units
  std::optional<scene::RecordedLattice> recorded_;
  std::uint64_t triangle_corners_ = 0;
  std::uint32_t own_section_ = 0;  ///< the file itself; sections before it are those that it names
  bool sound_ = true;              ///< nothing was left out that planes, faces or triangles count on
};

ReadResult read(const Input& input) { return StageReader(input).run(); }

}  // namespace

const Reader stage_reader{"stage", kSuffixes, sniff, read};

}  // namespace rad::readers
