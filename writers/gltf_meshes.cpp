#include "writers/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "writers/face_triangles.h"
#include "writers/gltf_manifold.h"
#include "writers/gltf_vertices.h"
#include "writers/little_endian.h"

namespace rad::writers::gltf {
namespace {

using scene::FaceId;
using scene::MaterialId;
using scene::ObjectId;

// Fewer vertices than this are counted in 16 bits; the largest such number ends strips on some machines.
constexpr std::size_t kShortIndices = 65535;

/// What the triangles of one primitive have in common.
struct Part {
  MaterialUse use;
  VertexKind kind;
  scene::GroupId group = 0;  ///< 0 where the whole mesh is of one group
  friend constexpr auto operator<=>(const Part&, const Part&) = default;
};
using CornersOfParts = std::map<Part, std::vector<CornerId>>;

class MeshBuilder {
 public:
  MeshBuilder(const Output& output, const Frame& frame) : output_(output), scene_(output.scene), frame_(frame) {}

  Meshes run() {
    number_materials();
    std::vector<std::vector<FaceId>> faces(scene_.objects.size());
    for (FaceId id = 0; id < scene_.faces.size(); ++id) faces[scene_.faces[id].object].push_back(id);
    for (ObjectId object = 0; object < faces.size() && result_.problem.empty(); ++object) {
      if (!faces[object].empty()) add_mesh(object, faces[object]);
    }
    return std::move(result_);
  }

 private:
  void number_materials() {
    std::map<MaterialUse, bool> mapped;
    for (FaceId id = 0; id < scene_.faces.size(); ++id) {
      bool& has_coordinates = mapped[material_of(id)];
      has_coordinates = has_coordinates || scene::has_texture_coordinates(scene_, scene_.faces[id]);
    }
    for (const auto& [use, has_coordinates] : mapped) {
      index_of_material_[use] = result_.materials.size();
      const bool shows = has_coordinates && output_.light == nullptr && scene_.materials[use.material].texture;
      result_.materials.push_back({use, shows});
    }
  }

  [[nodiscard]] MaterialUse material_of(FaceId face) const {
    const MaterialId material = scene_.faces[face].material;
    if (output_.light_map == nullptr) return {material};
    return {material, output_.light_map->page_of_face[face], output_.light_map->white_luminance[face]};
  }

  void add_mesh(ObjectId object, const std::vector<FaceId>& faces) {
    const bool one_group = std::ranges::all_of(
        faces, [&](FaceId id) { return scene_.faces[id].group == scene_.faces[faces.front()].group; });
    CornersOfParts parts;
    for (const FaceId id : faces) {
      const scene::Face& face = scene_.faces[id];
      const auto triangles = triangles_of(scene_, face);
      if (!triangles) return fail(unsplit_face(id));
      const MaterialUse use = material_of(id);
      const bool textured = result_.materials[index_of_material_.at(use)].shows_texture;
      std::vector<CornerId>& list = parts[{use, kind_of(output_, face, textured), one_group ? 0 : face.group}];
      for (const Triangle& triangle : *triangles) list.insert(list.end(), triangle.begin(), triangle.end());
    }
    Json mesh = Json::object();
    const std::string& group = scene_.groups[one_group ? scene_.faces[faces.front()].group : 0];
    const std::string& name = group.empty() ? scene_.objects[object] : group;
    if (!name.empty()) mesh["name"] = name;
    mesh["primitives"] = add_primitives(parts, mesh);
    result_.meshes.push_back(std::move(mesh));
    result_.objects.push_back(object);
  }

  Json add_primitives(const CornersOfParts& parts, Json& mesh) {
    std::map<VertexKind, VertexTable> tables = tables_of(parts);
    std::map<VertexKind, Json> attributes;
    for (const auto& [kind, table] : tables) attributes[kind] = add_attributes(kind, table.vertices());
    Json primitives = Json::array();
    std::vector<std::uint32_t> indices;
    for (const auto& [part, list] : parts) {
      Json primitive{{"attributes", attributes[part.kind]},
                     {"indices", add_indices(list, tables.at(part.kind), indices)},
                     {"material", index_of_material_.at(part.use)}};
      if (const std::string& group = scene_.groups[part.group]; !group.empty()) {
        primitive["extras"]["radfix"]["group"] = group;
      }
      primitives.push_back(std::move(primitive));
    }
    if (tables.size() == 1 && is_closed_manifold(indices)) {
      name_manifold(tables.begin()->second, indices.size(), primitives, mesh);
    }
    return primitives;
  }

  // The indices of the primitives lie one after another: together they are those of the solid.
  void name_manifold(const VertexTable& table, std::size_t count, const Json& primitives, Json& mesh) {
    const std::size_t indices = primitives.size() == 1 ? primitives[0]["indices"].get<std::size_t>()
                                                       : result_.buffer.add_accessor(index_kind(table), count);
    mesh["extensions"][kManifold]["manifoldPrimitive"] = {
        {"attributes", {{"POSITION", primitives[0]["attributes"]["POSITION"]}}}, {"indices", indices}};
  }

  static Kind index_kind(const VertexTable& table) {
    return table.vertices().size() < kShortIndices ? Kind::ShortIndex : Kind::LongIndex;
  }

  // The primitives of a mesh share their vertices as far as these are of one kind.
  std::map<VertexKind, VertexTable> tables_of(const CornersOfParts& parts) const {
    std::map<VertexKind, std::vector<CornerId>> corners;
    for (const auto& [part, list] : parts) {
      std::vector<CornerId>& all = corners[part.kind];
      all.insert(all.end(), list.begin(), list.end());
    }
    std::map<VertexKind, VertexTable> tables;
    for (const auto& [kind, list] : corners) tables.emplace(kind, VertexTable(output_, kind, list));
    return tables;
  }

  Json add_attributes(VertexKind kind, const std::vector<Vertex>& vertices) {
    Json attributes{{"POSITION", add_positions(vertices)}};
    if (kind.normal) attributes["NORMAL"] = add_floats(Kind::Normal, vertices, &Vertex::normal);
    if (kind.texture) attributes["TEXCOORD_0"] = add_floats(Kind::Texture, vertices, &Vertex::texture);
    if (kind.light_map) {
      attributes["TEXCOORD_1"] = add_floats(Kind::Texture, vertices, &Vertex::light_map);
      // Sets are numbered from 0 without a gap.
      if (!kind.texture) attributes["TEXCOORD_0"] = attributes["TEXCOORD_1"];
    }
    if (output_.light == nullptr) return attributes;
    if (!kind.light_map) attributes["COLOR_0"] = add_colours(vertices);
    attributes["_RADIOSITY"] = add_radiosity(vertices);
    return attributes;
  }

  template <typename Values>
  std::size_t add_floats(Kind kind, const std::vector<Vertex>& vertices, Values Vertex::*member) {
    std::string& bytes = result_.buffer.bytes_of(kind);
    for (const Vertex& vertex : vertices) {
      for (const float value : vertex.*member) {
        if (!std::isfinite(value)) fail("a texture coordinate is beyond single precision");
        append_bytes(bytes, value);
      }
    }
    return result_.buffer.add_accessor(kind, vertices.size());
  }

  std::size_t add_positions(const std::vector<Vertex>& vertices) {
    std::string& bytes = result_.buffer.bytes_of(Kind::Position);
    geom::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& [id, normal, texture, light_map] : vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        const float offset = frame_.offset(scene_.vertices[id][axis], axis);
        if (!std::isfinite(offset)) fail("vertex " + std::to_string(id) + " is beyond single precision");
        append_bytes(bytes, offset);
        low[axis] = std::min(low[axis], static_cast<double>(offset));
        high[axis] = std::max(high[axis], static_cast<double>(offset));
      }
    }
    return result_.buffer.add_accessor(Kind::Position, vertices.size(),
                                       {{"min", triple_json(low)}, {"max", triple_json(high)}});
  }

  std::size_t add_colours(const std::vector<Vertex>& vertices) {
    constexpr double kOpaque = std::numeric_limits<std::uint16_t>::max();
    std::string& bytes = result_.buffer.bytes_of(Kind::Colour);
    for (const auto& [id, normal, texture, light_map] : vertices) {
      for (int channel = 0; channel < 3; ++channel) {
        const double shown = std::clamp(output_.light->colour[id][channel], 0.0, 1.0);
        append_bytes(bytes, static_cast<std::uint16_t>(std::lround(shown * kOpaque)));
      }
      append_bytes(bytes, static_cast<std::uint16_t>(kOpaque));
    }
    return result_.buffer.add_accessor(Kind::Colour, vertices.size(), {{"normalized", true}});
  }

  std::size_t add_radiosity(const std::vector<Vertex>& vertices) {
    std::string& bytes = result_.buffer.bytes_of(Kind::Radiosity);
    for (const auto& [id, normal, texture, light_map] : vertices) {
      for (int channel = 0; channel < 3; ++channel) {
        const auto stored = static_cast<float>(output_.light->radiosity[id][channel]);
        if (!std::isfinite(stored))
          fail("the radiosity of vertex " + std::to_string(id) + " is beyond single precision");
        append_bytes(bytes, stored);
      }
    }
    return result_.buffer.add_accessor(Kind::Radiosity, vertices.size());
  }

  // Adds them to `all` as well.
  std::size_t add_indices(const std::vector<CornerId>& corners, const VertexTable& table,
                          std::vector<std::uint32_t>& all) {
    const Kind kind = index_kind(table);
    const bool are_short = kind == Kind::ShortIndex;
    std::string& bytes = result_.buffer.bytes_of(kind);
    for (const CornerId corner : corners) {
      const std::uint32_t index = all.emplace_back(table.index_of(corner));
      if (are_short) {
        append_bytes(bytes, static_cast<std::uint16_t>(index));
      } else {
        append_bytes(bytes, index);
      }
    }
    return result_.buffer.add_accessor(kind, corners.size());
  }

  void fail(std::string problem) {
    if (result_.problem.empty()) result_.problem = std::move(problem);
  }

  const Output& output_;
  const scene::Scene& scene_;
  const Frame& frame_;
  std::map<MaterialUse, std::size_t> index_of_material_;
  Meshes result_;
};

}  // namespace

Meshes build_meshes(const Output& output, const Frame& frame) { return MeshBuilder(output, frame).run(); }

}  // namespace rad::writers::gltf
