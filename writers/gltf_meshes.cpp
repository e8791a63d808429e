#include "writers/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "writers/face_triangles.h"
#include "writers/little_endian.h"

namespace rad::writers::gltf {
namespace {

using scene::FaceId;
using scene::MaterialId;
using scene::ObjectId;
using scene::VertexId;

// Fewer vertices than this are counted in 16 bits; the largest such number ends strips on some machines.
constexpr std::size_t kShortIndices = 65535;

using CornersByMaterial = std::map<MaterialId, std::vector<VertexId>>;

class MeshBuilder {
 public:
  MeshBuilder(const Output& output, const Frame& frame)
      : output_(output), scene_(output.scene), frame_(frame), local_(output.scene.vertices.size()) {}

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
    std::vector<bool> used(scene_.materials.size(), false);
    for (const scene::Face& face : scene_.faces) used[face.material] = true;
    index_of_material_.resize(used.size());
    for (MaterialId id = 0; id < used.size(); ++id) {
      index_of_material_[id] = result_.materials.size();
      if (used[id]) result_.materials.push_back(id);
    }
  }

  void add_mesh(ObjectId object, const std::vector<FaceId>& faces) {
    CornersByMaterial corners;
    for (const FaceId id : faces) {
      const auto triangles = triangles_of(scene_, scene_.faces[id]);
      if (!triangles) return fail(unsplit_face(id));
      std::vector<VertexId>& list = corners[scene_.faces[id].material];
      for (const Triangle& triangle : *triangles) list.insert(list.end(), triangle.begin(), triangle.end());
    }
    const std::vector<VertexId> vertices = vertices_of(corners);
    for (std::size_t i = 0; i < vertices.size(); ++i) local_[vertices[i]] = static_cast<std::uint32_t>(i);
    const Json attributes = add_attributes(vertices);
    Json primitives = Json::array();
    for (const auto& [material, list] : corners) {
      primitives.push_back({{"attributes", attributes},
                            {"indices", add_indices(list, vertices.size() < kShortIndices)},
                            {"material", index_of_material_[material]}});
    }
    Json mesh = Json::object();
    if (!scene_.objects[object].empty()) mesh["name"] = scene_.objects[object];
    mesh["primitives"] = std::move(primitives);
    result_.meshes.push_back(std::move(mesh));
    result_.objects.push_back(object);
  }

  static std::vector<VertexId> vertices_of(const CornersByMaterial& corners) {
    std::vector<VertexId> vertices;
    for (const auto& [material, list] : corners) vertices.insert(vertices.end(), list.begin(), list.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  Json add_attributes(const std::vector<VertexId>& vertices) {
    Json attributes{{"POSITION", add_positions(vertices)}};
    if (output_.light == nullptr) return attributes;
    attributes["COLOR_0"] = add_colours(vertices);
    attributes["_RADIOSITY"] = add_radiosity(vertices);
    return attributes;
  }

  std::size_t add_positions(const std::vector<VertexId>& vertices) {
    std::string& bytes = result_.buffer.bytes_of(Kind::Position);
    geom::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const VertexId id : vertices) {
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

  std::size_t add_colours(const std::vector<VertexId>& vertices) {
    constexpr double kOpaque = std::numeric_limits<std::uint16_t>::max();
    std::string& bytes = result_.buffer.bytes_of(Kind::Colour);
    for (const VertexId id : vertices) {
      for (int channel = 0; channel < 3; ++channel) {
        const double shown = std::clamp(output_.light->colour[id][channel], 0.0, 1.0);
        append_bytes(bytes, static_cast<std::uint16_t>(std::lround(shown * kOpaque)));
      }
      append_bytes(bytes, static_cast<std::uint16_t>(kOpaque));
    }
    return result_.buffer.add_accessor(Kind::Colour, vertices.size(), {{"normalized", true}});
  }

  std::size_t add_radiosity(const std::vector<VertexId>& vertices) {
    std::string& bytes = result_.buffer.bytes_of(Kind::Radiosity);
    for (const VertexId id : vertices) {
      for (int channel = 0; channel < 3; ++channel) {
        const auto stored = static_cast<float>(output_.light->radiosity[id][channel]);
        if (!std::isfinite(stored))
          fail("the radiosity of vertex " + std::to_string(id) + " is beyond single precision");
        append_bytes(bytes, stored);
      }
    }
    return result_.buffer.add_accessor(Kind::Radiosity, vertices.size());
  }

  std::size_t add_indices(const std::vector<VertexId>& corners, bool are_short) {
    const Kind kind = are_short ? Kind::ShortIndex : Kind::LongIndex;
    std::string& bytes = result_.buffer.bytes_of(kind);
    for (const VertexId id : corners) {
      if (are_short) {
        append_bytes(bytes, static_cast<std::uint16_t>(local_[id]));
      } else {
        append_bytes(bytes, local_[id]);
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
  std::vector<std::uint32_t> local_;  ///< of vertices that the current mesh uses: their place in it
  std::vector<std::size_t> index_of_material_;
  Meshes result_;
};

}  // namespace

Meshes build_meshes(const Output& output, const Frame& frame) { return MeshBuilder(output, frame).run(); }

}  // namespace rad::writers::gltf
