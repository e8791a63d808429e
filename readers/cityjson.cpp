// CityJSON 1.0, 1.1 and 2.0: city objects with surfaces that may have holes.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <map>

#include "readers/cityjson_appearance.h"
#include "readers/cityjson_geometry.h"
#include "readers/reader.h"
#include "readers/recorded_comment.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader cityjson_reader;

namespace cityjson {
namespace {

using geom::dvec3;
using scene::ReadIssueKind;
using scene::VertexId;

constexpr std::array<std::string_view, 2> kSuffixes = {".city.json", ".cityjson"};

/// A stretch of the scene's vertices that boundaries count in.
struct VertexRange {
  VertexId first = 0;
  std::size_t count = 0;
};

/// What goes with the surfaces of one geometry.
struct SurfaceWords {
  SurfaceValues semantics, material, texture;

  [[nodiscard]] SurfaceWords at(std::size_t index) const {
    return {semantics.at(index), material.at(index), texture.at(index)};
  }
};

class CityJsonReader {
 public:
  explicit CityJsonReader(const Input& input) : input_(input), builder_(input.path, "cityjson") {
    scene::Scene& scene = builder_.scene();
    scene.up = scene::UpAxis::Z;
    scene.metres_per_unit = 1;
  }

  ReadResult run() {
    auto json = parse_json_object(input_.bytes, 0, "CityJSON", issues_);
    if (json) {
      json_ = std::move(*json);
      read_city();
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  [[nodiscard]] JsonView root() { return JsonView(json_, "", issues_); }

  void refuse(std::string what, std::string pointer, ReadIssueKind kind = ReadIssueKind::ParseError) {
    scene::ReadIssue issue;
    issue.kind = kind;
    issue.what = std::move(what);
    issue.place.pointer = std::move(pointer);
    issues_.add(std::move(issue));
  }

  void count(std::string what, std::string pointer) {
    scene::IssuePlace place;
    place.pointer = std::move(pointer);
    issues_.add_unsupported(std::move(what), std::move(place));
  }

  void read_city() {
    if (root().text("type") != "CityJSON") return refuse("\"type\" is not \"CityJSON\"", "/type");
    const std::string version = root().text("version");
    if (!version.starts_with("1.") && !version.starts_with("2.")) {
      refuse("version " + in_quotes(version) + " of CityJSON is not read, only 1.0, 1.1 and 2.0", "/version");
      return;
    }
    read_transform();
    read_record();
    if (!read_vertices()) return;
    appearance_ = read_appearance(root(), builder_, issues_);
    read_objects();
  }

  void read_transform() {
    const JsonView transform = root().object("transform");
    if (!transform) return;
    if (const auto scale = transform.numbers("scale", 3)) scale_ = glm::make_vec3(scale->data());
    if (const auto translate = transform.numbers("translate", 3)) translate_ = glm::make_vec3(translate->data());
  }

  // What radfix says of itself in a member of its own.
  void read_record() {
    const auto lines = json_.find("+radfix");
    if (lines == json_.end() || !lines->is_array()) return;
    for (const Json& line : *lines) {
      if (!line.is_string()) continue;
      if (const auto record = record_of_comment(line.get_ref<const std::string&>())) builder_.scene().recorded = record;
    }
  }

  bool read_vertices() {
    const std::size_t count = root().length("vertices");
    const std::string full = limit_before_vertices(builder_.scene(), count, input_.limits);
    if (!full.empty()) {
      refuse(full, "/vertices");
      return false;
    }
    builder_.scene().vertex_section = builder_.add_section({input_.path, "/vertices", scene::RecordKind::Item});
    const Json& vertices = json_["vertices"];
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 at = point_of(vertices, i, "/vertices");
      builder_.add_vertex(at * scale_ + translate_, i);
    }
    own_ = {0, count};
    return true;
  }

  // Coordinates that are no numbers are NaN.
  dvec3 point_of(const Json& points, std::size_t index, std::string_view pointer) {
    dvec3 point(std::numeric_limits<double>::quiet_NaN());
    const Json& json = points[index];
    const auto place = [&] { return std::string(pointer) + "/" + std::to_string(index); };
    if (!json.is_array() || json.size() != 3) {
      refuse("a vertex is not an array of three numbers", place());
      return point;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Json& value = json[static_cast<std::size_t>(axis)];
      if (value.is_number()) {
        point[axis] = value.get<double>();
      } else {
        refuse("a coordinate is not a number", place());
      }
    }
    return point;
  }

  void read_objects() {
    const JsonView objects = root().object("CityObjects");
    if (!objects) return;
    for (const auto& [id, json] : json_["CityObjects"].items()) {
      const std::string pointer = "/CityObjects" + pointer_step(id);
      if (!json.is_object()) {
        refuse("not an object", pointer);
        continue;
      }
      builder_.use_object(builder_.object(id));
      read_geometries(JsonView(json, pointer, issues_));
      if (full_) return;
    }
  }

  // Levels of detail show the same thing more than once: the finest is read.
  void read_geometries(const JsonView& object) {
    const std::size_t count_of_all = object.length("geometry");
    const auto& chosen = input_.choices.level_of_detail;
    double finest = -1;
    for (std::size_t i = 0; i < count_of_all; ++i) {
      const Json& json = object.json()["geometry"][i];
      if (json.is_object()) finest = std::max(finest, level_of_detail(json));
    }
    for (std::size_t i = 0; i < count_of_all && !full_; ++i) {
      const JsonView geometry = object.item("geometry", i);
      if (!geometry) continue;
      if (chosen && !is_level(level_of_detail(geometry.json()), *chosen)) {
        count("geometries of another level of detail than the one chosen", geometry.pointer());
      } else if (!chosen && level_of_detail(geometry.json()) < finest) {
        count("geometries of a coarser level of detail than another of their object", geometry.pointer());
      } else if (geometry.text("type") == "GeometryInstance") {
        read_instance(geometry);
      } else {
        read_geometry(geometry, own_, false);
      }
    }
  }

  // A template is placed by a matrix and a reference point (specification, 3.4).
  void read_instance(const JsonView& geometry) {
    const auto index = geometry.whole("template");
    const auto matrix = geometry.numbers("transformationMatrix", 16);
    const auto reference = geometry.wholes("boundaries");
    const JsonView templates = root().object("geometry-templates");
    if (!index || !matrix || reference.size() != 1 || !templates) {
      return refuse("an instance lacks its template, matrix or reference point; it is left out", geometry.pointer());
    }
    if (reference[0] >= own_.count) {
      return refuse(
          index_outside(static_cast<std::int64_t>(std::min<std::uint64_t>(reference[0], INT64_MAX)), own_.count),
          geometry.pointer(), ReadIssueKind::IndexOutOfRange);
    }
    const JsonView shape = templates.item("templates", *index);
    if (!shape) return;
    const glm::dmat4 place = glm::transpose(glm::make_mat4(matrix->data()));
    const auto range = place_template(place, builder_.scene().vertices[reference[0]], geometry.pointer());
    if (range) read_geometry(shape, *range, glm::determinant(glm::dmat3(place)) < 0);
  }

  std::optional<VertexRange> place_template(const glm::dmat4& place, const dvec3& origin, const std::string& pointer) {
    const Json& all = json_["geometry-templates"];
    const auto found = all.find("vertices-templates");
    if (found == all.end() || !found->is_array()) {
      refuse("the file has no vertices of templates", "/geometry-templates");
      return std::nullopt;
    }
    std::string full = limit_before_vertices(builder_.scene(), found->size(), input_.limits);
    if (full.empty() && ++instances_ > input_.limits.instances)
      full = "templates are placed too often; the rest is left out";
    if (!full.empty()) {
      full_ = true;
      refuse(std::move(full), pointer);
      return std::nullopt;
    }
    const VertexRange range{static_cast<VertexId>(builder_.vertex_count()), found->size()};
    for (std::size_t i = 0; i < found->size(); ++i) {
      const dvec3 at = point_of(*found, i, "/geometry-templates/vertices-templates");
      // Not the vertex itself but the point that it is placed by can be named.
      builder_.add_vertex(dvec3(place * glm::dvec4(at, 1.0)) + origin, 0);
    }
    return range;
  }

  void read_geometry(const JsonView& geometry, const VertexRange& range, bool mirrored) {
    const std::string type = geometry.text("type");
    const auto levels = levels_above_surfaces(type);
    if (!levels)
      return count(type.empty() ? "geometries without a type" : type.substr(0, 40) + " geometries", geometry.pointer());
    const auto boundaries = geometry.json().find("boundaries");
    if (boundaries == geometry.json().end()) return refuse("a geometry has no boundaries", geometry.pointer());
    range_ = range;
    mirrored_ = mirrored;
    types_ = surface_types(geometry);
    read_level(*boundaries, *levels, words_of(geometry), geometry.pointer() + "/boundaries");
  }

  // The names of the semantic surfaces, by number.
  std::vector<scene::GroupId> surface_types(const JsonView& geometry) {
    std::vector<scene::GroupId> types;
    if (!geometry.has("semantics") || geometry.json()["semantics"].is_null()) return types;
    const JsonView semantics = geometry.object("semantics");
    for (std::size_t i = 0; i < semantics.length("surfaces"); ++i) {
      const JsonView surface = semantics.item("surfaces", i);
      types.push_back(builder_.group(surface ? surface.text("type") : std::string()));
    }
    return types;
  }

  SurfaceWords words_of(const JsonView& geometry) {
    SurfaceWords words;
    single_material_.reset();
    const auto member = [](const Json& json, const char* key) -> const Json* {
      if (!json.is_object()) return nullptr;
      const auto found = json.find(key);
      return found == json.end() ? nullptr : &*found;
    };
    if (const Json* semantics = member(geometry.json(), "semantics"))
      words.semantics = SurfaceValues(member(*semantics, "values"));
    if (const Json* theme = theme_of(geometry, "material", appearance_.material_theme)) {
      words.material = SurfaceValues(member(*theme, "values"));
      single_material_ = SurfaceValues(member(*theme, "value")).whole();
    }
    if (const Json* theme = theme_of(geometry, "texture", appearance_.texture_theme)) {
      words.texture = SurfaceValues(member(*theme, "values"));
    }
    return words;
  }

  // The default theme, else the first by name.
  const Json* theme_of(const JsonView& geometry, const char* key, const std::string& preferred) {
    const auto themes = geometry.json().find(key);
    if (themes == geometry.json().end() || !themes->is_object() || themes->empty()) return nullptr;
    if (themes->size() > 1) count(std::string("further themes of ") + key + "s", geometry.pointer());
    const auto named = themes->find(preferred);
    return named != themes->end() ? &*named : &themes->begin().value();
  }

  void read_level(const Json& json, int levels, const SurfaceWords& words, const std::string& pointer) {
    if (!json.is_array()) return refuse("boundaries are not nested as the type of the geometry says", pointer);
    if (levels == 1) builder_.add_section({input_.path, pointer, scene::RecordKind::Item});
    for (std::size_t i = 0; i < json.size() && !full_; ++i) {
      if (levels == 1) {
        read_surface(json[i], i, words.at(i), pointer);
      } else {
        read_level(json[i], levels - 1, words.at(i), pointer + "/" + std::to_string(i));
      }
    }
  }

  void read_surface(const Json& rings, std::size_t index, const SurfaceWords& words, const std::string& pointer) {
    if (!rings.is_array() || rings.empty()) {
      return refuse("a surface is not an array of rings; it is left out", pointer + "/" + std::to_string(index));
    }
    loops_.resize(rings.size());
    std::uint64_t corners = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (!read_ring(rings[i], loops_[i], pointer + "/" + std::to_string(index) + "/" + std::to_string(i))) return;
      corners += loops_[i].size();
    }
    if (std::string full = limit_before_face(builder_.scene(), corners, input_.limits); !full.empty()) {
      full_ = true;
      return refuse(std::move(full), pointer);
    }
    const auto type = words.semantics.whole();
    builder_.use_group(type && *type < types_.size() ? types_[*type] : 0);
    builder_.use_material(material_of(words));
    builder_.add_face(loops_[0], index);
    set_texture(words, 0);
    for (std::size_t i = 1; i < loops_.size(); ++i) {
      builder_.add_hole(loops_[i]);
      set_texture(words, i);
    }
  }

  bool read_ring(const Json& ring, std::vector<VertexId>& loop, const std::string& pointer) {
    loop.clear();
    if (!ring.is_array() || ring.size() > input_.limits.face_corners) {
      refuse("a ring is not an array of vertex numbers; its surface is left out", pointer);
      return false;
    }
    for (const Json& corner : ring) {
      const bool whole = corner.is_number_integer();
      if (whole && corner.get<std::int64_t>() >= 0 && corner.get<std::uint64_t>() < range_.count) {
        loop.push_back(range_.first + corner.get<VertexId>());
        continue;
      }
      refuse(whole ? index_outside(corner.get<std::int64_t>(), range_.count) : "a corner is not a vertex number",
             pointer, whole ? ReadIssueKind::IndexOutOfRange : ReadIssueKind::ParseError);
      return false;
    }
    if (mirrored_) std::ranges::reverse(loop);
    return true;
  }

  // A material comes before an image.
  scene::MaterialId material_of(const SurfaceWords& words) const {
    const auto own = words.material.whole();
    const auto number = own ? own : single_material_;
    if (number && *number < appearance_.materials.size()) return appearance_.materials[*number];
    const auto image = words.texture.at(0).at(0).whole();
    if (image && *image < appearance_.textures.size()) return appearance_.textures[*image];
    return 0;
  }

  // Of a ring: the number of its image, then one row for each corner.
  void set_texture(const SurfaceWords& words, std::size_t ring) {
    const SurfaceValues values = words.texture.at(ring);
    const std::size_t corners = loops_[ring].size();
    if (!values.at(0).whole() || values.json()->size() != corners + 1) return;
    rows_.clear();
    for (std::size_t i = 0; i < corners; ++i) {
      const auto row = values.at(i + 1).whole();
      rows_.push_back(row && *row < appearance_.texture_rows ? static_cast<scene::RowId>(*row) : scene::kNoRow);
    }
    if (mirrored_) std::ranges::reverse(rows_);
    builder_.set_texture_coordinates(rows_);
  }

  const Input& input_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Json json_;
  dvec3 scale_{1, 1, 1};
  dvec3 translate_{0, 0, 0};
  VertexRange own_;
  Appearance appearance_;
  // Of the geometry being read.
  VertexRange range_;
  bool mirrored_ = false;
  std::vector<scene::GroupId> types_;
  std::optional<std::uint64_t> single_material_;
  std::vector<std::vector<VertexId>> loops_;
  std::vector<scene::RowId> rows_;
  std::uint64_t instances_ = 0;
  bool full_ = false;
};

bool sniff(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '{') return false;
  return head.find("\"CityJSON\"") != std::string_view::npos || head.find("\"CityObjects\"") != std::string_view::npos;
}

ReadResult read(const Input& input) { return CityJsonReader(input).run(); }

}  // namespace
}  // namespace cityjson

const Reader cityjson_reader{"cityjson", cityjson::kSuffixes, cityjson::sniff, cityjson::read};

}  // namespace rad::readers
