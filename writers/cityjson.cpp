#include "writers/cityjson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "scene/drawing_colour.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 14> kSemantics = {
    "RoofSurface",          "GroundSurface",     "WallSurface",  "ClosureSurface",
    "OuterCeilingSurface",  "OuterFloorSurface", "Window",       "Door",
    "InteriorWallSurface",  "CeilingSurface",    "FloorSurface", "TrafficArea",
    "AuxiliaryTrafficArea", "WaterSurface"};

bool is_semantic(std::string_view name) { return std::ranges::find(kSemantics, name) != kSemantics.end(); }

/// Vertices as whole numbers n: position = origin + pitch n.
struct Grid {
  double pitch = 1;
  geom::dvec3 origin{0, 0, 0};

  [[nodiscard]] std::int64_t index(double coordinate, int axis) const {
    return std::llround((coordinate - origin[axis]) / pitch);
  }
};

// Without a lattice the grid is that of the last bit of the largest coordinate: 2^53 steps reach it.
Grid grid_of(const Output& output) {
  if (output.lattice) return {output.lattice->lattice.pitch, output.lattice->lattice.origin};
  double largest = 0;
  for (const geom::dvec3& at : output.scene.vertices) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(at[axis]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return {largest > 0 ? std::ldexp(1.0, exponent - 53) : 1.0, {0, 0, 0}};
}

class CityWriter {
 public:
  explicit CityWriter(const Output& output) : output_(output), scene_(output.scene), grid_(grid_of(output)) {}

  std::string text() {
    std::string body = "{\n\"type\": \"CityJSON\",\n\"version\": \"2.0\",\n";
    body += "\"transform\": " + transform().dump() + ",\n";
    body += "\"metadata\": {\"title\": " + ordered_json("written by " + program_name()).dump() + "},\n";
    body += "\"+radfix\": " + record().dump() + ",\n";
    body += "\"appearance\": " + appearance().dump() + ",\n";
    append_objects(body);
    append_vertices(body);
    return body + "}\n";
  }

 private:
  [[nodiscard]] bool turned() const { return scene_.up == scene::UpAxis::Y; }
  [[nodiscard]] double metres() const { return scene_.metres_per_unit.value_or(1); }

  // (x, y, z) with Y up is (x, -z, y) with Z up.
  [[nodiscard]] ordered_json transform() const {
    const double scale = grid_.pitch * metres();
    const geom::dvec3& from = grid_.origin;
    const geom::dvec3 origin = turned() ? geom::dvec3(from.x, -from.z, from.y) : from;
    return {{"scale", {scale, scale, scale}},
            {"translate", {origin.x * metres(), origin.y * metres(), origin.z * metres()}}};
  }

  [[nodiscard]] ordered_json record() const {
    ordered_json lines = ordered_json::array();
    Output output = output_;
    // In other coordinates the lattice is another one.
    if (turned() || metres() != 1) output.lattice.reset();
    for (const std::string& comment : head_comments(output)) lines.push_back(comment);
    return lines;
  }

  [[nodiscard]] ordered_json appearance() const {
    ordered_json materials = ordered_json::array();
    for (const scene::Material& material : scene_.materials) {
      ordered_json json{{"name", material.name.empty() ? "unnamed" : one_line(material.name)}};
      if (material.reflectance_stated) {
        const geom::dvec3 colour = scene::srgb_of_reflectance(material.reflectance);
        json["diffuseColor"] = {colour.x, colour.y, colour.z};
      }
      materials.push_back(std::move(json));
    }
    return {{"materials", std::move(materials)}};
  }

  void append_objects(std::string& body) {
    body += "\"CityObjects\": {";
    std::vector<std::vector<scene::FaceId>> faces(scene_.objects.size());
    for (scene::FaceId id = 0; id < scene_.faces.size(); ++id) faces[scene_.faces[id].object].push_back(id);
    bool first = true;
    for (std::size_t object = 0; object < faces.size(); ++object) {
      if (faces[object].empty()) continue;
      body += first ? "\n" : ",\n";
      first = false;
      const std::string& name = scene_.objects[object];
      body += ordered_json(name.empty() ? "unnamed" : one_line(name)).dump() + ": ";
      append_object(body, faces[object]);
    }
    body += "\n},\n";
  }

  void append_object(std::string& body, const std::vector<scene::FaceId>& faces) {
    const bool building = std::ranges::any_of(
        faces, [&](scene::FaceId id) { return is_semantic(scene_.groups[scene_.faces[id].group]); });
    body += std::string("{\"type\": \"") + (building ? "Building" : "GenericCityObject") +
            "\", \"geometry\": [{\"type\": \"MultiSurface\", \"lod\": \"2\",\n\"boundaries\": [";
    for (std::size_t i = 0; i < faces.size(); ++i) {
      body += i == 0 ? "\n" : ",\n";
      append_surface(body, scene_.faces[faces[i]]);
    }
    body += "],\n\"material\": {\"radfix\": {\"values\": [";
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (i > 0) body += ',';
      append_number(body, scene_.faces[faces[i]].material);
    }
    body += "]}}";
    if (building) append_semantics(body, faces);
    body += "}]}";
  }

  void append_surface(std::string& body, const scene::Face& face) const {
    body += '[';
    bool first_loop = true;
    for (const scene::Loop& loop : scene_.loops_of(face)) {
      body += first_loop ? "[" : ",[";
      first_loop = false;
      bool first = true;
      for (const scene::VertexId id : scene_.corners_of(loop)) {
        if (!first) body += ',';
        first = false;
        append_number(body, id);
      }
      body += ']';
    }
    body += ']';
  }

  void append_semantics(std::string& body, const std::vector<scene::FaceId>& faces) const {
    std::vector<std::string_view> names;
    std::string values;
    for (const scene::FaceId id : faces) {
      if (!values.empty()) values += ',';
      const std::string& name = scene_.groups[scene_.faces[id].group];
      if (!is_semantic(name)) {
        values += "null";
        continue;
      }
      auto found = std::ranges::find(names, std::string_view(name));
      if (found == names.end()) found = names.insert(names.end(), name);
      append_number(values, static_cast<std::size_t>(found - names.begin()));
    }
    body += ",\n\"semantics\": {\"surfaces\": [";
    for (std::size_t i = 0; i < names.size(); ++i) {
      body += (i > 0 ? ",{\"type\": \"" : "{\"type\": \"") + std::string(names[i]) + "\"}";
    }
    body += "], \"values\": [" + values + "]}";
  }

  void append_vertices(std::string& body) const {
    body += "\"vertices\": [";
    for (std::size_t i = 0; i < scene_.vertices.size(); ++i) {
      body += i == 0 ? "\n[" : ",\n[";
      const geom::dvec3& at = scene_.vertices[i];
      const std::int64_t x = grid_.index(at.x, 0), y = grid_.index(at.y, 1), z = grid_.index(at.z, 2);
      append_number(body, x);
      body += ',';
      append_number(body, turned() ? -z : y);
      body += ',';
      append_number(body, turned() ? y : z);
      body += ']';
    }
    body += "\n]\n";
  }

  const Output& output_;
  const scene::Scene& scene_;
  Grid grid_;
};

}  // namespace

WriteResult write_cityjson(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  return {write_whole_file(path, CityWriter(output).text())};
}

}  // namespace rad::writers
