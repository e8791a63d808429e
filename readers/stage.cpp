// Stage files: models between two filters of radfix, as JSON (docs/stage-format.md).
#include <array>
#include <cmath>

#include "readers/gltf_json.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/stage_planes.h"
#include "scene/scene_builder.h"
#include "scene/stage_record.h"

namespace rad::readers {

extern const Reader stage_reader;

namespace {

using gltf::Json;
using gltf::JsonView;
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
  explicit StageReader(const Input& input) : input_(input), builder_(input.path, "stage") {}

  ReadResult run() {
    if (parse()) read_members();
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void report(std::string what, std::string pointer) {
    gltf::add_parse_error(issues_, std::move(what), std::move(pointer));
  }

  bool parse() {
    try {
      json_ = Json::parse(input_.bytes.begin(), input_.bytes.end());
    } catch (const Json::parse_error& error) {
      issues_.add(issue_at_byte(ReadIssueKind::ParseError, "not well-formed JSON", error.byte > 0 ? error.byte - 1 : 0));
      return false;
    } catch (const Json::exception&) {
      issues_.add(issue_at_byte(ReadIssueKind::ParseError, "the JSON holds a number that no double can", 0));
      return false;
    }
    const JsonView root = this->root();
    if (!json_.is_object() || root.text("format") != "radfix-stage") {
      report("this is not a stage file of radfix", "/format");
      return false;
    }
    if (root.whole("version") == kVersion) return true;
    report("only version " + std::to_string(kVersion) + " of stage files is read", "/version");
    return false;
  }

  [[nodiscard]] JsonView root() { return JsonView(json_, "", issues_); }

  void read_members() {
    record_ = std::make_shared<StageRecord>();
    record_->stage = root().text("stage");
    record_->work_tolerance = root().number("workTolerance").value_or(0);
    read_lattice();
    if (!lattice_) return report("without its lattice a stage file has no geometry", "/lattice");
    read_names();
    if (!read_points()) return;
    read_planes();
    read_faces();
    read_ledger();
    keep_record();
  }

  void read_lattice() {
    const JsonView lattice = root().object("lattice");
    const auto pitch = lattice.number("pitch"), tolerance = root().number("tolerance");
    const auto origin = lattice.numbers("origin", 3);
    if (!pitch || !origin || !tolerance) return;
    lattice_ = geom::Lattice{*pitch, {(*origin)[0], (*origin)[1], (*origin)[2]}};
    builder_.scene().recorded = scene::RecordedLattice{*lattice_, *tolerance};
    if (const auto metres = root().has("metresPerUnit") && !json_["metresPerUnit"].is_null()
                                ? root().number("metresPerUnit")
                                : std::nullopt;
        metres && std::isfinite(*metres) && *metres > 0) {
      builder_.scene().metres_per_unit = metres;
    }
    const std::string up = root().has("up") && !json_["up"].is_null() ? root().text("up") : std::string();
    if (up == "y") builder_.scene().up = scene::UpAxis::Y;
    if (up == "z") builder_.scene().up = scene::UpAxis::Z;
  }

  void read_names() {
    scene::Scene& scene = builder_.scene();
    if (auto names = root().texts("objects"); !names.empty()) scene.objects = std::move(names);
    if (auto names = root().texts("groups"); !names.empty()) scene.groups = std::move(names);
    const std::size_t materials = root().length("materials");
    if (materials > 0) scene.materials.clear();
    for (std::size_t i = 0; i < materials; ++i) read_material(root().item("materials", i));
    for (std::size_t i = 0; i < root().length("sources"); ++i) {
      const JsonView source = root().item("sources", i);
      const std::string record = source.text("record");
      const auto kind = record == "element" ? scene::RecordKind::Element
                        : record == "byte"  ? scene::RecordKind::ByteOffset
                                            : scene::RecordKind::Line;
      builder_.add_section({source.text("file"), source.text("pointer"), kind});
    }
    own_section_ = builder_.add_section({input_.path, "/faces", scene::RecordKind::Element});
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
    builder_.scene().materials.push_back(std::move(material));
  }

  // A point that cannot be read keeps its place, so that later indices do not shift.
  bool read_points() {
    const auto points = json_.find("points");
    if (points == json_.end() || !points->is_array()) {
      report("there is no array of points", "/points");
      return false;
    }
    if (std::string full = limit_before_vertices(builder_.scene(), points->size(), input_.limits); !full.empty()) {
      report(std::move(full), "/points");
      return false;
    }
    for (std::size_t i = 0; i < points->size(); ++i) {
      const auto point = lattice_point((*points)[i]);
      if (!point) {
        report("a point is not three whole numbers below 2^23 in magnitude", "/points/" + std::to_string(i));
        sound_ = false;
      }
      record_->points.push_back(point.value_or(geom::LatticePoint{0, 0, 0}));
      builder_.add_vertex(point ? lattice_->position(*point) : geom::dvec3(std::nan("")));
    }
    return true;
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
      record_->planes.push_back(std::move(plane));
    }
  }

  void read_drawn(const Json& json, scene::StagePlane& plane) {
    const auto slits = json.find("slits"), points = json.find("points");
    if (slits != json.end() && slits->is_array()) {
      for (const Json& slit : *slits) {
        const auto ends = indices(slit, record_->points.size());
        const bool good = ends && ends->size() == 2 && (*ends)[0] != (*ends)[1];
        sound_ = sound_ && good;
        if (good) plane.slits.push_back({(*ends)[0], (*ends)[1]});
      }
    }
    if (points == json.end()) return;
    const auto drawn = indices(*points, record_->points.size());
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
    std::uint64_t corners = 0;
    for (const auto& loop : *loops) corners += loop.size();
    std::string full = limit_before_face(builder_.scene(), corners, input_.limits);
    if (!full.empty()) {
      report(std::move(full), pointer);
      sound_ = false;
      return false;
    }
    builder_.add_face(loops->front(), number);
    for (std::size_t i = 1; i < loops->size(); ++i) builder_.add_hole((*loops)[i]);
    scene::Face& face = builder_.scene().faces.back();
    const scene::Scene& scene = builder_.scene();
    face.material = name_index(json, "material", scene.materials.size(), pointer);
    face.object = name_index(json, "object", scene.objects.size(), pointer);
    face.group = name_index(json, "group", scene.groups.size(), pointer);
    read_sources(json, pointer, face, number);
    read_stage_face(json);
    return true;
  }

  std::optional<std::vector<std::vector<std::uint32_t>>> loops_of(const Json& json, const std::string& pointer) {
    const auto member = json.find("loops");
    if (member == json.end() || !member->is_array() || member->empty()) {
      report("a face has no loops; it is left out", pointer);
      return std::nullopt;
    }
    std::vector<std::vector<std::uint32_t>> loops;
    for (const Json& item : *member) {
      auto loop = indices(item, record_->points.size());
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

  void read_sources(const Json& json, const std::string& pointer, scene::Face& face, std::size_t number) {
    std::vector<scene::SourceRef> sources;
    const auto member = json.find("sources");
    if (member != json.end() && member->is_array()) {
      for (const Json& item : *member) {
        const bool pair = item.is_array() && item.size() == 2 && item[1].is_number_unsigned();
        const auto section = pair ? index(item[0], own_section_) : std::nullopt;
        if (section) {
          sources.push_back({*section, item[1].get<std::uint64_t>()});
        } else {
          report("a source is not a section and a record", pointer + "/sources");
        }
      }
    }
    if (sources.empty()) sources.push_back({own_section_, number});
    face.source = sources.front();
    record_->sources.push_back(std::move(sources));
  }

  void read_stage_face(const Json& json) {
    if (record_->planes.empty()) return;
    const auto plane = json.find("plane"), along = json.find("along"), rank = json.find("surfaceRank");
    scene::StageFace face;
    const auto found = plane == json.end() ? std::nullopt : index(*plane, record_->planes.size());
    sound_ = sound_ && found && along != json.end() && along->is_boolean();
    face.plane = found.value_or(0);
    face.along = along == json.end() || !along->is_boolean() || along->get<bool>();
    if (rank != json.end()) face.surface_rank = index(*rank, 0xffffffffu).value_or(0);
    record_->faces.push_back(face);
    const auto triangles = json.find("triangles");
    if (triangles != json.end()) read_triangles(*triangles);
  }

  void read_triangles(const Json& json) {
    auto& list = record_->triangles.emplace_back();
    sound_ = sound_ && json.is_array();
    if (!json.is_array()) return;
    for (const Json& item : json) {
      const auto corners = indices(item, record_->points.size());
      const bool good = corners && corners->size() == 3;
      sound_ = sound_ && good;
      if (good) list.push_back({(*corners)[0], (*corners)[1], (*corners)[2]});
    }
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
      record_->ledger.push_back(std::move(entry));
    }
  }

  // Planes that do not fit the faces would lead the filters astray: then the model is its faces alone.
  void keep_record() {
    if (!record_->planes.empty()) {
      const double tolerance = builder_.scene().recorded->tolerance / lattice_->pitch;
      if (!sound_ || !planes_fit(builder_.scene(), *record_, tolerance)) {
        report("the planes do not fit the faces; they are left out", "/planes");
        record_->planes.clear();
        record_->faces.clear();
        record_->triangles.clear();
      }
    }
    builder_.scene().triangles_only = record_->triangles.empty() && !record_->planes.empty();
    builder_.scene().stage = std::move(record_);
  }

  const Input& input_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Json json_;
  std::shared_ptr<StageRecord> record_;
  std::optional<geom::Lattice> lattice_;
  std::uint32_t own_section_ = 0;  ///< the file itself; sections before it are those that it names
  bool sound_ = true;              ///< nothing was left out that planes, faces or triangles count on
};

ReadResult read(const Input& input) { return StageReader(input).run(); }

}  // namespace

const Reader stage_reader{"stage", kSuffixes, sniff, read};

}  // namespace rad::readers
