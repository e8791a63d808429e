// HBJSON, the models of Honeybee: rooms of planar faces with apertures and doors, and shades.
#include <algorithm>
#include <array>
#include <limits>

#include "readers/hbjson_modifiers.h"
#include "readers/hbjson_subfaces.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader hbjson_reader;

namespace hbjson {
namespace {

using geom::dvec3;
using scene::ReadIssueKind;
using scene::VertexId;
using Ring = std::vector<dvec3>;

constexpr std::array<std::string_view, 1> kSuffixes = {".hbjson"};

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits = {
    {{"Meters", 1}, {"Millimeters", 0.001}, {"Centimeters", 0.01}, {"Feet", 0.3048}, {"Inches", 0.0254}}};

FaceSort sort_of_face(const std::string& type, bool interior) {
  const std::string_view member = interior ? "interior_modifier" : "exterior_modifier";
  if (type == "Floor") return {"floor_set", member};
  if (type == "RoofCeiling") return {"roof_ceiling_set", member};
  return {"wall_set", member};
}

struct Outline {
  Ring boundary;
  std::vector<Ring> holes;
};

class HbjsonReader {
 public:
  explicit HbjsonReader(const Input& input) : input_(input), builder_(input.path, "hbjson") {
    builder_.scene().up = scene::UpAxis::Z;
    builder_.scene().splits_vertices = true;
  }

  ReadResult run() {
    auto json = parse_json_object(input_.bytes, 0, "HBJSON", issues_);
    if (json) {
      json_ = std::move(*json);
      read_model();
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void refuse(std::string what, std::string pointer, ReadIssueKind kind = ReadIssueKind::ParseError) {
    scene::ReadIssue issue;
    issue.kind = kind;
    issue.what = std::move(what);
    issue.place.pointer = std::move(pointer);
    issues_.add(std::move(issue));
  }

  void count(std::string what, const std::string& pointer) {
    scene::IssuePlace place;
    place.pointer = pointer;
    issues_.add_unsupported(std::move(what), std::move(place));
  }

  void read_model() {
    const JsonView model(json_, "", issues_);
    if (model.text("type") != "Model") return refuse("\"type\" is not \"Model\"", "/type");
    read_units(model);
    Modifiers modifiers(model, builder_, issues_);
    modifiers_ = &modifiers;
    for_each(model, "rooms", [&](const JsonView& room) { read_room(room); });
    room_ = JsonView();
    in_room_ = false;
    builder_.use_object(0);
    for_each(model, "orphaned_faces", [&](const JsonView& face) { read_face(face); });
    for_each(model, "orphaned_apertures", [&](const JsonView& part) { read_part(part, "Aperture"); });
    for_each(model, "orphaned_doors", [&](const JsonView& part) { read_part(part, "Door"); });
    for_each(model, "orphaned_shades", [&](const JsonView& shade) { read_shade(shade); });
    for_each(model, "shade_meshes", [&](const JsonView& mesh) { read_mesh(mesh); });
  }

  template <typename Read>
  void for_each(const JsonView& parent, std::string_view key, Read read) {
    if (!parent.has(key) || parent.json().at(std::string(key)).is_null()) return;
    const std::size_t length = parent.length(key);
    for (std::size_t i = 0; i < length && !full_; ++i) {
      if (const JsonView item = parent.item(key, i)) read(item);
    }
  }

  void read_units(const JsonView& model) {
    const std::string name = model.has("units") ? model.text("units") : "Meters";
    const auto* const unit = std::ranges::find(kUnits, name, &Unit::name);
    if (unit != kUnits.end()) {
      builder_.scene().metres_per_unit = unit->metres;
    } else {
      refuse(in_quotes(name) + " is not a unit of HBJSON", "/units");
    }
    const double tolerance = model.number("tolerance").value_or(0);
    if (tolerance > 0 && tolerance < std::numeric_limits<double>::infinity()) {
      tolerance_ = tolerance;
      builder_.scene().declared_tolerance = tolerance;
    }
  }

  void read_room(const JsonView& room) {
    room_ = room;
    in_room_ = true;
    builder_.use_object(builder_.object(room.text("identifier")));
    for_each(room, "faces", [&](const JsonView& face) { read_face(face); });
    read_shades_of(room);
  }

  void read_shades_of(const JsonView& object) {
    for_each(object, "indoor_shades", [&](const JsonView& shade) { read_shade(shade); });
    for_each(object, "outdoor_shades", [&](const JsonView& shade) { read_shade(shade); });
  }

  [[nodiscard]] bool is_interior(const JsonView& face) {
    if (!face.has("boundary_condition") || !face.json().at("boundary_condition").is_object()) return false;
    const std::string type = face.object("boundary_condition").text("type");
    return type == "Surface" || type == "Adiabatic";
  }

  void read_face(const JsonView& face) {
    const std::string type = face.text("face_type");
    if (type == "AirBoundary") {
      count("air boundaries, which are openings", face.pointer());
      return;
    }
    auto outline = outline_of(face);
    if (!outline) return;
    Ring boundary = std::move(outline->boundary);
    std::vector<OutlineCorner> corners;
    for (const dvec3& point : boundary) corners.push_back({point, std::nullopt});
    std::vector<std::pair<JsonView, Ring>> parts;
    for (const char* key : {"apertures", "doors"}) {
      for_each(face, key, [&](const JsonView& part) {
        if (auto ring = outline_of(part)) parts.emplace_back(part, std::move(ring->boundary));
      });
    }
    for (const auto& [part, ring] : parts) cut(corners, outline->holes, ring, part.pointer());
    outline->boundary.clear();
    for (const OutlineCorner& corner : corners) outline->boundary.push_back(corner.at);
    begin(face, type, sort_of_face(type, is_interior(face)));
    add(*outline, face.pointer());
    for_each(face, "apertures", [&](const JsonView& part) { read_part(part, "Aperture"); });
    for_each(face, "doors", [&](const JsonView& part) { read_part(part, "Door"); });
    read_shades_of(face);
  }

  void cut(std::vector<OutlineCorner>& outline, std::vector<Ring>& holes, const Ring& part,
           const std::string& pointer) {
    if (part.size() < 3) return;
    switch (lie_of(outline, part, tolerance_)) {
      case Lie::Inside:
        holes.emplace_back(part.rbegin(), part.rend());
        break;
      case Lie::Notch:
        break;
      case Lie::Touching:
        count("openings of faces for apertures that meet their outline: both overlap", pointer);
        break;
    }
  }

  void read_part(const JsonView& part, std::string_view kind) {
    const auto outline = outline_of(part);
    if (!outline) return;
    const bool glass = kind == "Aperture" || (part.has("is_glass") && part.flag("is_glass").value_or(false));
    const bool interior = is_interior(part);
    FaceSort sort{kind == "Aperture" ? "aperture_set" : "door_set", "exterior_modifier"};
    if (interior) sort.member = kind == "Door" && glass ? "interior_glass_modifier" : "interior_modifier";
    if (!interior && kind == "Aperture") sort.member = "window_modifier";
    if (!interior && kind == "Door" && glass) sort.member = "exterior_glass_modifier";
    begin(part, kind, sort);
    add(*outline, part.pointer());
    read_shades_of(part);
  }

  void read_shade(const JsonView& shade) {
    const auto outline = outline_of(shade);
    if (!outline) return;
    begin(shade, "Shade", {"shade_set", "exterior_modifier"});
    const bool in_room = in_room_;
    in_room_ = false;  // a shade has no inside
    add(*outline, shade.pointer());
    in_room_ = in_room;
  }

  void begin(const JsonView& item, std::string_view kind, const FaceSort& sort) {
    builder_.use_group(builder_.group(kind));
    builder_.use_material(modifiers_->material_of(item, room_, sort, kind));
    const std::string identifier = item.text("identifier");
    builder_.use_entity(builder_.add_entity(identifier.empty() ? std::string() : std::string(kind) + " " + identifier));
  }

  std::optional<Outline> outline_of(const JsonView& item) {
    const JsonView geometry = item.object("geometry");
    const std::string pointer = item.pointer() + "/geometry/boundary";
    if (!geometry) {
      refuse("there is no geometry; it is left out", item.pointer());
      return std::nullopt;
    }
    Outline outline;
    const auto boundary = geometry.json().find("boundary");
    if (boundary == geometry.json().end() || !boundary->is_array() || boundary->size() > input_.limits.face_corners) {
      refuse("there is no boundary; it is left out", pointer);
      return std::nullopt;
    }
    outline.boundary = ring_of(*boundary, pointer, input_.limits.face_corners);
    const auto holes = geometry.json().find("holes");
    if (holes == geometry.json().end() || !holes->is_array()) return outline;
    for (std::size_t i = 0; i < holes->size(); ++i) {
      outline.holes.push_back(
          ring_of((*holes)[i], item.pointer() + "/geometry/holes/" + std::to_string(i), input_.limits.face_corners));
    }
    return outline;
  }

  // Points that cannot be read are NaN.
  Ring ring_of(const Json& json, const std::string& pointer, std::uint64_t most) {
    Ring ring;
    if (!json.is_array() || json.size() > most) {
      refuse("not an array of points", pointer);
      return ring;
    }
    for (std::size_t i = 0; i < json.size(); ++i) ring.push_back(point_of(json[i], pointer));
    return ring;
  }

  dvec3 point_of(const Json& json, const std::string& pointer) {
    dvec3 point(std::numeric_limits<double>::quiet_NaN());
    const bool sound =
        json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() && json[2].is_number();
    if (!sound) {
      refuse("a point is not an array of three numbers", pointer);
      return point;
    }
    for (int axis = 0; axis < 3; ++axis) point[axis] = json[static_cast<std::size_t>(axis)].get<double>();
    return point;
  }

  // Faces of rooms look outwards in the file; what is seen of them is their inside.
  void add(const Outline& outline, const std::string& pointer) {
    std::uint64_t corners = outline.boundary.size();
    for (const Ring& hole : outline.holes) corners += hole.size();
    std::string full = limit_before_face(builder_.scene(), corners, input_.limits);
    if (full.empty()) full = limit_before_vertices(builder_.scene(), corners, input_.limits);
    if (!full.empty()) {
      full_ = true;
      return refuse(std::move(full), pointer);
    }
    const std::size_t last = pointer.rfind('/');
    builder_.add_section({input_.path, pointer.substr(0, last), scene::RecordKind::Item});
    builder_.add_face(placed(outline.boundary), std::stoull(pointer.substr(last + 1)));
    for (const Ring& hole : outline.holes) builder_.add_hole(placed(hole));
  }

  std::vector<VertexId> placed(const Ring& ring) {
    std::vector<VertexId> corners;
    for (const dvec3& point : ring) corners.push_back(builder_.add_vertex(point));
    if (in_room_) std::ranges::reverse(corners);
    return corners;
  }

  void read_mesh(const JsonView& mesh) {
    const JsonView geometry = mesh.object("geometry");
    if (!geometry) return;
    const std::string pointer = mesh.pointer() + "/geometry";
    const auto vertices = geometry.json().find("vertices");
    if (vertices == geometry.json().end()) return refuse("a mesh has no vertices", pointer);
    const auto first = static_cast<VertexId>(builder_.vertex_count());
    const Ring points = ring_of(*vertices, pointer + "/vertices", input_.limits.vertices);
    if (std::string full = limit_before_vertices(builder_.scene(), points.size(), input_.limits); !full.empty()) {
      full_ = true;
      return refuse(std::move(full), pointer);
    }
    for (const dvec3& point : points) builder_.add_vertex(point);
    begin(mesh, "Shade", {"shade_set", "exterior_modifier"});
    builder_.add_section({input_.path, pointer + "/faces", scene::RecordKind::Item});
    const std::size_t faces = geometry.length("faces");
    for (std::size_t i = 0; i < faces && !full_; ++i) {
      read_mesh_face(geometry.json()["faces"][i], i, first, points.size(), pointer + "/faces/" + std::to_string(i));
    }
  }

  void read_mesh_face(const Json& json, std::size_t index, VertexId first, std::size_t points,
                      const std::string& pointer) {
    std::vector<VertexId> corners;
    if (!json.is_array() || json.size() > 4)
      return refuse("a face of a mesh is not an array of three or four numbers", pointer);
    for (const Json& corner : json) {
      const bool whole = corner.is_number_integer();
      const std::int64_t number = whole ? corner.get<std::int64_t>() : 0;
      if (!whole || number < 0 || static_cast<std::uint64_t>(number) >= points) {
        return refuse(whole ? index_outside(number, points) : "a corner is not a vertex number", pointer,
                      whole ? ReadIssueKind::IndexOutOfRange : ReadIssueKind::ParseError);
      }
      corners.push_back(first + static_cast<VertexId>(number));
    }
    if (std::string full = limit_before_face(builder_.scene(), corners.size(), input_.limits); !full.empty()) {
      full_ = true;
      return refuse(std::move(full), pointer);
    }
    builder_.add_face(corners, index);
  }

  const Input& input_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Json json_;
  Modifiers* modifiers_ = nullptr;
  JsonView room_;
  bool in_room_ = false;
  double tolerance_ = 0;  ///< file units; distances up to it are none to Honeybee
  bool full_ = false;
};

bool sniff(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '{') return false;
  const auto holds = [&](std::string_view mark) { return head.find(mark) != std::string_view::npos; };
  return holds("\"Model\"") && (holds("\"rooms\"") || holds("\"ModelRadianceProperties\"") || holds("\"Face3D\""));
}

ReadResult read(const Input& input) { return HbjsonReader(input).run(); }

}  // namespace
}  // namespace hbjson

const Reader hbjson_reader{"hbjson", hbjson::kSuffixes, hbjson::sniff, hbjson::read};

}  // namespace rad::readers
