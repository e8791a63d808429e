#include "writers/dxf.h"

#include <array>
#include <optional>
#include <vector>

#include "scene/drawing_colour.h"
#include "scene/index_colour.h"
#include "writers/face_triangles.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

struct Unit {
  double metres;
  int code;  ///< of $INSUNITS
};
constexpr std::array<Unit, 8> kUnits = {
    {{0.0254, 1}, {0.3048, 2}, {0.001, 4}, {0.01, 5}, {1, 6}, {1000, 7}, {0.9144, 10}, {0.1, 14}}};

template <typename Value>
void append_group(std::string& text, int code, const Value& value) {
  append_number(text, code);
  text += '\n';
  if constexpr (std::is_arithmetic_v<Value>) {
    append_number(text, value);
  } else {
    text += value;
  }
  text += '\n';
}

// Names of layers hold no control characters and none of the characters that DXF keeps for itself.
std::string layer_name(const std::string& object) {
  std::string name = one_line(object).substr(0, 255);
  for (char& c : name) {
    if (std::string_view("<>/\\\":;?*|=`,").find(c) != std::string_view::npos) c = '_';
  }
  return name.empty() ? "0" : name;
}

void append_header(std::string& text, const Output& output) {
  append_group(text, 0, "SECTION");
  append_group(text, 2, "HEADER");
  append_group(text, 9, "$ACADVER");
  append_group(text, 1, "AC1009");
  for (const Unit& unit : kUnits) {
    if (output.scene.metres_per_unit != unit.metres) continue;
    append_group(text, 9, "$INSUNITS");
    append_group(text, 70, unit.code);
  }
  append_group(text, 0, "ENDSEC");
}

void append_layers(std::string& text, const std::vector<std::string>& layers) {
  append_group(text, 0, "SECTION");
  append_group(text, 2, "TABLES");
  append_group(text, 0, "TABLE");
  append_group(text, 2, "LAYER");
  append_group(text, 70, layers.size());
  for (const std::string& layer : layers) {
    append_group(text, 0, "LAYER");
    append_group(text, 2, layer);
    append_group(text, 70, 0);
    append_group(text, 62, 7);
    append_group(text, 6, "CONTINUOUS");
  }
  append_group(text, 0, "ENDTAB");
  append_group(text, 0, "ENDSEC");
}

void append_face(std::string& text, const scene::Scene& scene, std::span<const std::uint32_t> corners,
                 const std::string& layer, int colour) {
  append_group(text, 0, "3DFACE");
  append_group(text, 8, layer);
  append_group(text, 62, colour);
  for (int i = 0; i < 4; ++i) {
    // A triangle repeats its last corner.
    const std::size_t corner = std::min<std::size_t>(static_cast<std::size_t>(i), corners.size() - 1);
    const geom::dvec3& at = scene.vertices[scene.corners[corners[corner]]];
    append_group(text, 10 + i, at.x);
    append_group(text, 20 + i, at.y);
    append_group(text, 30 + i, at.z);
  }
}

// A quad stays one where its fourth corner is not its third.
bool is_quad(const scene::Scene& scene, const scene::Face& face) {
  const auto corners = scene.corners_of(scene.loops[face.first_loop]);
  return face.loop_count == 1 && corners.size() == 4 && scene.vertices[corners[2]] != scene.vertices[corners[3]];
}

}  // namespace

WriteResult write_dxf(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  const scene::Scene& scene = output.scene;
  std::vector<std::string> layers;
  for (const std::string& object : scene.objects) layers.push_back(layer_name(object));
  std::vector<int> colours;
  for (const scene::Material& material : scene.materials) {
    colours.push_back(scene::nearest_index(scene::colour_of_reflectance(material.reflectance)));
  }
  std::string text;
  for (const std::string& comment : head_comments(output)) append_group(text, 999, comment);
  append_header(text, output);
  append_layers(text, layers);
  append_group(text, 0, "SECTION");
  append_group(text, 2, "ENTITIES");
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const scene::Face& face = scene.faces[id];
    const auto triangles = triangles_of(scene, face);
    if (!triangles) return {unsplit_face(id)};
    const std::uint32_t first = scene.loops[face.first_loop].first;
    if (is_quad(scene, face)) {
      append_face(text, scene, std::array{first, first + 1, first + 2, first + 3}, layers[face.object],
                  colours[face.material]);
      continue;
    }
    for (const Triangle& triangle : *triangles)
      append_face(text, scene, triangle, layers[face.object], colours[face.material]);
  }
  append_group(text, 0, "ENDSEC");
  append_group(text, 0, "EOF");
  return {write_whole_file(path, text)};
}

}  // namespace rad::writers
