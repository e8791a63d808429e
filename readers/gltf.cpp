// glTF 2.0 and GLB.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "readers/gltf_accessors.h"
#include "readers/gltf_buffers.h"
#include "readers/gltf_container.h"
#include "readers/gltf_materials.h"
#include "readers/gltf_nodes.h"
#include "readers/gltf_primitives.h"
#include "readers/gltf_record.h"
#include "readers/gltf_waivers.h"
#include "readers/reader.h"
#include "readers/unique_names.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader gltf_reader;

namespace gltf {
namespace {

constexpr std::array<std::string_view, 2> kSuffixes = {".gltf", ".glb"};
constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool sniff(std::string_view head) {
  if (head.starts_with(kGlbMagic)) return true;
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  const std::size_t first = head.find_first_not_of(kBlanks);
  if (first == std::string_view::npos || head[first] != '{') return false;
  const std::size_t asset = head.find("\"asset\"");
  return asset != std::string_view::npos && head.find("\"version\"", asset) != std::string_view::npos;
}

std::string format_of(const Input& input) { return input.bytes.starts_with(kGlbMagic) ? "glb" : "gltf"; }

bool is_finite(const geom::dvec3& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// Places meshes into a scene, instance by instance, within the limits.
class Assembly {
 public:
  explicit Assembly(const Document& document)
      : document_(document),
        buffers_(document),
        accessors_(document, buffers_),
        builder_(document.input.path, format_of(document.input)) {}

  scene::Scene run() {
    add_materials();
    const std::vector<MeshInstance> instances = mesh_instances(document_, accessors_);
    meshes_.resize(document_.root().length("meshes"));
    for (const MeshInstance& instance : instances) {
      if (instance.mesh < meshes_.size()) ++meshes_[instance.mesh].awaited;
    }
    for (const MeshInstance& instance : instances) {
      if (!add_instance(instance)) break;
    }
    return finished_scene();
  }

  [[nodiscard]] std::vector<scene::Waiver> waivers() const {
    return read_waivers(document_, objects_of_nodes_, material_ids_);
  }

 private:
  /// A mesh that is kept as long as further instances will ask for it.
  struct Mesh {
    std::vector<Primitive> primitives;
    std::uint64_t awaited = 0;
    bool is_read = false;
  };

  void add_materials() {
    for (ReadMaterial& read : read_materials(document_, buffers_)) {
      const scene::MaterialId id = builder_.material(read.material.name);
      builder_.material_at(id) = std::move(read.material);
      material_ids_.push_back(id);
      texture_sets_.push_back(read.texture_set);
    }
  }

  // Whether there was room for it.
  bool add_instance(const MeshInstance& instance) {
    if (instance.mesh >= meshes_.size()) {
      add_parse_error(document_.issues, "mesh " + std::to_string(instance.mesh) + " does not exist",
                      instance.node ? "/nodes/" + std::to_string(*instance.node) : "/meshes");
      return true;
    }
    Mesh& mesh = meshes_[instance.mesh];
    if (!mesh.is_read) {
      mesh.primitives = read_mesh(document_, buffers_, accessors_, texture_sets_, instance.mesh);
      mesh.is_read = true;
    }
    if (!mesh.primitives.empty()) use_names(instance);
    first_of_accessor_.clear();
    first_normal_row_.clear();
    for (const Primitive& primitive : mesh.primitives) {
      if (!add_primitive(primitive, instance.world)) return false;
    }
    if (--mesh.awaited == 0) mesh.primitives = {};
    return true;
  }

  void use_names(const MeshInstance& instance) {
    const JsonView root = document_.root();
    const JsonView mesh = root.item("meshes", instance.mesh);
    group_of_mesh_ = builder_.group(mesh.text("name"));
    const std::string number =
        instance.node ? "node " + std::to_string(*instance.node) : "mesh " + std::to_string(instance.mesh);
    std::string name = instance.node ? root.item("nodes", *instance.node).text("name") : std::string();
    // What radfix wrote without a name had none; the mesh bears the name of its group.
    if (name.empty() && !recorded_) name = mesh.text("name");
    if (name.empty() && !recorded_) name = number;
    if (instance.copy) name += " copy " + std::to_string(*instance.copy);
    const scene::ObjectId object = builder_.object(object_names_.claim(name));
    if (instance.node) objects_of_nodes_.emplace(*instance.node, object);
    builder_.use_object(object);
  }

  bool add_primitive(const Primitive& primitive, const glm::dmat4& world) {
    const Limits& limits = document_.input.limits;
    const std::uint64_t faces = builder_.scene().faces.size() + primitive.triangles.size();
    const auto shared =
        primitive.position_accessor ? first_of_accessor_.find(*primitive.position_accessor) : first_of_accessor_.end();
    const bool is_new = shared == first_of_accessor_.end();
    const std::uint64_t vertices = builder_.vertex_count() + (is_new ? primitive.positions.size() : 0);
    if (vertices > limits.vertices || faces > limits.faces || 3 * faces > limits.corners) {
      add_parse_error(document_.issues, "the scene passes the limit of vertices or faces; the rest is left out",
                      primitive.pointer);
      return false;
    }
    builder_.add_section({document_.input.path, primitive.pointer, scene::RecordKind::Element});
    builder_.use_material(material_of(primitive));
    builder_.use_group(primitive.group.empty() ? group_of_mesh_ : builder_.group(primitive.group));
    const auto first = is_new ? static_cast<scene::VertexId>(builder_.vertex_count()) : shared->second;
    if (is_new) add_vertices(primitive, world);
    if (is_new && primitive.position_accessor) first_of_accessor_.emplace(*primitive.position_accessor, first);
    const Rows rows{add_texture_coordinates(primitive), add_normals(primitive, world)};
    add_triangles(primitive, first, rows, glm::determinant(glm::dmat3(world)) < 0);
    return true;
  }

  /// First rows of what a primitive has at its vertices.
  struct Rows {
    std::optional<scene::RowId> texture_coordinates;
    std::optional<scene::RowId> normals;
  };

  // Texture coordinates do not hang on the placement: all instances share their rows.
  std::optional<scene::RowId> add_texture_coordinates(const Primitive& primitive) {
    if (primitive.texture_coordinates.empty()) return std::nullopt;
    const auto first = static_cast<scene::RowId>(builder_.scene().attributes.texture_coordinates.table.size());
    const auto known = row_of(primitive.texture_accessor, first_texture_row_, first);
    if (known != first) return known;
    for (const scene::dvec2& value : primitive.texture_coordinates) builder_.add_texture_coordinates(value);
    return first;
  }

  // A normal is turned as its plane is; what a placement only moves stays bit for bit.
  std::optional<scene::RowId> add_normals(const Primitive& primitive, const glm::dmat4& world) {
    if (primitive.normals.empty()) return std::nullopt;
    const auto first = static_cast<scene::RowId>(builder_.scene().attributes.normals.table.size());
    const auto known = row_of(primitive.normal_accessor, first_normal_row_, first);
    if (known != first) return known;
    const glm::dmat3 linear(world);
    const bool is_moved_only = linear == glm::dmat3(1.0);
    const glm::dmat3 of_planes = is_moved_only ? linear : glm::transpose(glm::inverse(linear));
    for (const geom::dvec3& normal : primitive.normals) {
      builder_.add_normal(is_moved_only ? normal : glm::normalize(of_planes * normal));
    }
    return first;
  }

  // The first row of an accessor that is in the table already, else `next`, which it then gets.
  static scene::RowId row_of(const std::optional<std::uint64_t>& accessor,
                             std::map<std::uint64_t, scene::RowId>& first_rows, scene::RowId next) {
    return accessor ? first_rows.try_emplace(*accessor, next).first->second : next;
  }

  scene::MaterialId material_of(const Primitive& primitive) const {
    if (!primitive.material) return 0;
    if (*primitive.material < material_ids_.size()) return material_ids_[*primitive.material];
    add_parse_error(document_.issues, "material " + std::to_string(*primitive.material) + " does not exist",
                    primitive.pointer);
    return 0;
  }

  // A position that is not finite stays as it is: a matrix would smear its infinity over the finite coordinates.
  void add_vertices(const Primitive& primitive, const glm::dmat4& world) {
    for (const geom::dvec3& point : primitive.positions) {
      builder_.add_vertex(is_finite(point) ? geom::dvec3(world * glm::dvec4(point, 1.0)) : point);
    }
  }

  void add_triangles(const Primitive& primitive, scene::VertexId first, const Rows& rows, bool mirrored) {
    for (const Triangle& triangle : primitive.triangles) {
      std::array<std::uint32_t, 3> corners = triangle.corners;
      if (mirrored) std::swap(corners[1], corners[2]);
      const auto counted_from = [&](std::uint32_t start) {
        return std::array{start + corners[0], start + corners[1], start + corners[2]};
      };
      builder_.add_face(counted_from(first), triangle.record);
      if (rows.texture_coordinates) builder_.set_texture_coordinates(counted_from(*rows.texture_coordinates));
      if (rows.normals) builder_.set_normals(counted_from(*rows.normals));
    }
  }

  scene::Scene finished_scene() {
    scene::Scene scene = builder_.take();
    scene.attributes.texture_origin = scene::TextureOrigin::UpperLeft;
    scene.single_precision = true;
    scene.triangles_only = true;
    scene.splits_vertices = true;
    scene.metres_per_unit = 1.0;
    scene.recorded = recorded_;
    scene.up = scene::UpAxis::Y;
    return scene;
  }

  const Document& document_;
  std::optional<scene::RecordedLattice> recorded_ = read_recorded_lattice(document_);
  Buffers buffers_;
  Accessors accessors_;
  scene::SceneBuilder builder_;
  std::vector<Mesh> meshes_;
  scene::GroupId group_of_mesh_ = 0;                            ///< of the instance that is being added
  std::map<std::uint64_t, scene::VertexId> first_of_accessor_;  ///< of the instance that is being added
  std::map<std::uint64_t, scene::RowId> first_normal_row_;      ///< likewise, by accessor
  std::map<std::uint64_t, scene::RowId> first_texture_row_;     ///< by accessor
  std::vector<scene::MaterialId> material_ids_;
  std::vector<std::uint64_t> texture_sets_;  ///< per material
  UniqueNames object_names_;
  ObjectsOfNodes objects_of_nodes_;
};

// What a document holds beside its meshes and this reader leaves out, each entry counted.
void report_unsupported(const Document& document) {
  const JsonView root = document.root();
  const auto count = [&](const JsonView& parent, std::string_view key, std::string_view what) {
    const std::size_t length = parent.length(key);
    for (std::size_t i = 0; i < length; ++i) {
      scene::IssuePlace place;
      place.pointer = parent.pointer() + "/" + std::string(key);
      document.issues.add_unsupported(std::string(what), std::move(place));
    }
  };
  count(root, "skins", "skins");
  count(root, "animations", "animations");
  count(root, "cameras", "cameras");
  count(root.extension("KHR_lights_punctual"), "lights", "punctual lights");
}

ReadResult read(const Input& input) {
  ReadResult result;
  const auto document = open_document(input, result.issues);
  if (!document) {
    result.scene = scene::empty_scene(input.path, format_of(input));
    return result;
  }
  report_unsupported(*document);
  Assembly assembly(*document);
  result.scene = assembly.run();
  result.waivers = assembly.waivers();
  return result;
}

}  // namespace
}  // namespace gltf

const Reader gltf_reader{"gltf", gltf::kSuffixes, gltf::sniff, gltf::read};

}  // namespace rad::readers
