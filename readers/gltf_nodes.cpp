#include "readers/gltf_nodes.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace rad::readers::gltf {

namespace {

glm::dmat4 placement(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  glm::dmat4 matrix = glm::mat4_cast(rotation);
  for (int column = 0; column < 3; ++column) matrix[column] *= scale[column];
  matrix[3] = glm::dvec4(translation, 1.0);
  return matrix;
}

glm::dquat quaternion(const double* xyzw) { return glm::dquat(xyzw[3], xyzw[0], xyzw[1], xyzw[2]); }

glm::dmat4 local_transform(const JsonView& node) {
  if (const auto matrix = node.numbers("matrix", 16)) return glm::make_mat4(matrix->data());
  const auto translation = node.numbers("translation", 3);
  const auto rotation = node.numbers("rotation", 4);
  const auto scale = node.numbers("scale", 3);
  return placement(translation ? glm::make_vec3(translation->data()) : glm::dvec3(0.0),
                   rotation ? quaternion(rotation->data()) : glm::dquat(1.0, 0.0, 0.0, 0.0),
                   scale ? glm::make_vec3(scale->data()) : glm::dvec3(1.0));
}

/// The columns of EXT_mesh_gpu_instancing; absent ones are empty.
struct CopyColumns {
  std::vector<double> translations;
  std::vector<double> rotations;
  std::vector<double> scales;
  std::uint64_t count = 0;

  [[nodiscard]] glm::dmat4 at(std::uint64_t copy) const {
    return placement(translations.empty() ? glm::dvec3(0.0) : glm::make_vec3(&translations[3 * copy]),
                     rotations.empty() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : quaternion(&rotations[4 * copy]),
                     scales.empty() ? glm::dvec3(1.0) : glm::make_vec3(&scales[3 * copy]));
  }
};

class Walk {
 public:
  Walk(const Document& document, const Accessors& accessors)
      : document_(document),
        accessors_(accessors),
        root_(document.root()),
        on_path_(root_.length("nodes"), false),
        reached_(on_path_) {}

  std::vector<MeshInstance> run() {
    if (on_path_.empty()) {
      place_every_mesh();
    } else if (const auto scene = default_scene()) {
      walk_from(scene->wholes("nodes"), scene->pointer());
    } else {
      walk_all_roots();
    }
    return std::move(instances_);
  }

 private:
  struct Pending {
    std::uint64_t node = 0;
    std::uint64_t depth = 0;  ///< 1 for a root
    bool leaving = false;     ///< everything below the node is done
  };

  void report(std::string what, std::string pointer) const {
    add_parse_error(document_.issues, std::move(what), std::move(pointer));
  }

  std::optional<JsonView> default_scene() const {
    const auto index = root_.whole("scene");
    if (!index) return std::nullopt;
    if (const JsonView scene = root_.item("scenes", *index)) return scene;
    return std::nullopt;
  }

  void place_every_mesh() {
    // The default scene is read only for what is wrong with it: there is nothing that it could place.
    static_cast<void>(default_scene());
    const std::size_t count = root_.length("meshes");
    for (std::uint64_t mesh = 0; mesh < count; ++mesh) {
      if (!add({mesh, std::nullopt, std::nullopt, glm::dmat4(1.0)}, "/meshes")) return;
    }
  }

  void walk_all_roots() {
    std::vector<bool> is_child(on_path_.size(), false);
    for (std::size_t i = 0; i < on_path_.size(); ++i) {
      const JsonView node = root_.item("nodes", i);
      if (!node) continue;
      for (const std::uint64_t child : node.wholes("children")) {
        if (child < is_child.size()) is_child[child] = true;
      }
    }
    std::vector<std::uint64_t> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(i);
    }
    walk_from(roots, "");
    const auto unreached = std::find(reached_.begin(), reached_.end(), false);
    if (unreached == reached_.end() || document_.issues.any(scene::ReadIssueKind::ParseError)) return;
    const auto index = static_cast<std::uint64_t>(unreached - reached_.begin());
    report("the node is part of a cycle of nodes, which is left out", "/nodes/" + std::to_string(index));
  }

  void walk_from(const std::vector<std::uint64_t>& roots, const std::string& pointer) {
    worlds_.assign(1, glm::dmat4(1.0));
    push(roots, pointer, 1);
    while (!pending_.empty() && !full_) {
      const Pending next = pending_.back();
      pending_.pop_back();
      if (next.leaving) {
        on_path_[next.node] = false;
      } else {
        visit(next);
      }
    }
  }

  // In reverse, so that the first child comes off the stack first.
  void push(const std::vector<std::uint64_t>& nodes, const std::string& parent_pointer, std::uint64_t depth) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      if (*node < on_path_.size()) {
        pending_.push_back({*node, depth, false});
      } else {
        report("node " + std::to_string(*node) + " does not exist", parent_pointer);
      }
    }
  }

  // glTF asks for a tree, but files in use hang one node below several parents; each way to it is an instance.
  void visit(const Pending& pending) {
    const std::string pointer = "/nodes/" + std::to_string(pending.node);
    if (on_path_[pending.node]) {
      report("the node is its own ancestor: nodes form a cycle", pointer);
      return;
    }
    if (pending.depth > document_.input.limits.node_depth) {
      report("nodes are nested deeper than " + std::to_string(document_.input.limits.node_depth), pointer);
      return;
    }
    if (!count_visit(pointer)) return;
    reached_[pending.node] = true;
    const JsonView node = root_.item("nodes", pending.node);
    if (!node) return;
    // The walk is depth-first, so that the parent's world is still the last one of its depth.
    worlds_.resize(pending.depth);
    worlds_.push_back(worlds_.back() * local_transform(node));
    if (node.has("mesh")) place(node, pending.node, worlds_.back());
    if (!node.has("children")) return;
    on_path_[pending.node] = true;
    pending_.push_back({pending.node, pending.depth, true});
    push(node.wholes("children"), pointer, pending.depth + 1);
  }

  // Shared nodes let a short file describe endless walks, with or without meshes on the way.
  bool count_visit(const std::string& pointer) {
    if (++visits_ <= std::max<std::uint64_t>(document_.input.limits.instances, on_path_.size())) return true;
    full_ = true;
    report("the walk over shared nodes passes the limit of instances; the rest is left out", pointer);
    return false;
  }

  void place(const JsonView& node, std::uint64_t index, const glm::dmat4& world) {
    const auto mesh = node.whole("mesh");
    if (!mesh) return;
    const JsonView attributes = node.extension("EXT_mesh_gpu_instancing").object("attributes");
    if (!attributes) {
      add({*mesh, index, std::nullopt, world}, node.pointer());
      return;
    }
    const auto columns = copy_columns(attributes);
    for (std::uint64_t copy = 0; columns && copy < columns->count; ++copy) {
      if (!add({*mesh, index, copy, world * columns->at(copy)}, node.pointer())) return;
    }
  }

  std::optional<CopyColumns> copy_columns(const JsonView& attributes) const {
    CopyColumns columns;
    std::optional<std::uint64_t> count;
    const auto read = [&](std::string_view key, std::string_view type, std::size_t components,
                          std::vector<double>& column) {
      const auto accessor = attributes.whole(key);
      if (!accessor) return true;
      auto values = accessors_.numbers(*accessor, type);
      if (!values) return false;
      column = std::move(*values);
      const std::uint64_t rows = column.size() / components;
      count = std::min(count.value_or(rows), rows);
      return true;
    };
    const bool sound = read("TRANSLATION", "VEC3", 3, columns.translations) &&
                       read("ROTATION", "VEC4", 4, columns.rotations) && read("SCALE", "VEC3", 3, columns.scales);
    if (!sound) return std::nullopt;
    columns.count = count.value_or(1);
    return columns;
  }

  // Whether there is room for more.
  bool add(const MeshInstance& instance, const std::string& pointer) {
    if (full_) return false;
    if (instances_.size() < document_.input.limits.instances) {
      instances_.push_back(instance);
      return true;
    }
    full_ = true;
    report("more than " + std::to_string(document_.input.limits.instances) + " meshes are placed; the rest is left out",
           pointer);
    return false;
  }

  const Document& document_;
  const Accessors& accessors_;
  const JsonView root_;
  std::vector<bool> on_path_;
  std::vector<bool> reached_;
  std::vector<Pending> pending_;
  std::vector<glm::dmat4> worlds_;  ///< identity, then one for each node on the way to the current one
  std::uint64_t visits_ = 0;
  std::vector<MeshInstance> instances_;
  bool full_ = false;
};

}  // namespace

std::vector<MeshInstance> mesh_instances(const Document& document, const Accessors& accessors) {
  return Walk(document, accessors).run();
}

}  // namespace rad::readers::gltf
