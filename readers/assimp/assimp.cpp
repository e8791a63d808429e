// COLLADA, FBX, 3DS, 3MF, X3D and LWO through assimp, without any of its processing: topology is what the file's
// coordinates say.
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <string>

#include "readers/assimp/frame.h"
#include "readers/assimp/model_files.h"
#include "readers/components.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "readers/unique_names.h"
#include "readers/unread_formats.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader assimp_reader;

namespace assimp {
namespace {

using scene::ReadIssueKind;

constexpr std::string_view kFbxMark = "Kaydara FBX Binary";
constexpr std::size_t kLongestName = 255;

std::string name_of(const aiString& name) { return {name.data, std::min<std::size_t>(name.length, kLongestName)}; }

std::string format_of(const Input& input) {
  const std::string name = lower_case_name(input.path);
  for (const std::string_view suffix : kAssimpSuffixes) {
    if (name.ends_with(suffix)) return std::string(suffix.substr(1));
  }
  return input.bytes.starts_with(kFbxMark) ? "fbx" : "dae";
}

struct PlacedNode {
  const aiNode* node = nullptr;
  glm::dmat4 world{1.0};
  std::uint64_t depth = 0;
};

class AssimpReader {
 public:
  explicit AssimpReader(const Input& input)
      : input_(input), format_(format_of(input)), builder_(input.path, format_of(input)) {
    builder_.add_section({input.path, {}, scene::RecordKind::Element});
    builder_.scene().single_precision = true;
    builder_.scene().splits_vertices = true;
  }

  ReadResult run() {
    try {
      read_model();
    } catch (const std::exception&) {
      refuse("assimp cannot read the file");
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void refuse(std::string what) { issues_.add({ReadIssueKind::ParseError, std::move(what), {}, 1}); }
  void count(std::string what) { issues_.add_unsupported(std::move(what), {}); }

  void read_model() {
    const std::string name = "model." + format_;
    Assimp::Importer importer;
    if (!importer.IsExtensionSupported("." + format_)) return refuse("this build of assimp does not read ." + format_);
    importer.SetIOHandler(new ModelFiles(input_, name));
    const aiScene* const model = importer.ReadFile(name, 0);
    if (model == nullptr || model->mRootNode == nullptr) {
      return refuse("assimp cannot read the file: " + in_quotes(importer.GetErrorString()));
    }
    if ((model->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0 && model->mNumMeshes > 0) {
      refuse("assimp has read only a part of the file");
    }
    read_materials(*model);
    count_all(*model);
    const Frame frame = frame_of(*model, format_);
    builder_.scene().metres_per_unit = frame.metres_per_unit;
    builder_.scene().up = frame.up;
    walk(*model, frame.root);
  }

  void count_all(const aiScene& model) {
    if (model.mNumAnimations > 0) count("animations");
    if (model.mNumLights > 0) count("lights without a surface");
    for (unsigned i = 0; i < model.mNumMeshes; ++i) {
      if (model.mMeshes[i]->mNumBones > 0) count("skins");
    }
  }

  // Colours are taken as they stand, as those of MTL are.
  void read_materials(const aiScene& model) {
    UniqueNames names;
    for (unsigned i = 0; i < model.mNumMaterials; ++i) {
      const aiMaterial& from = *model.mMaterials[i];
      aiString name;
      from.Get(AI_MATKEY_NAME, name);
      const std::string own = name_of(name);
      const auto id = builder_.material(names.claim(own.empty() ? "material " + std::to_string(i) : own));
      read_material(from, builder_.material_at(id));
      materials_.push_back(id);
    }
  }

  void read_material(const aiMaterial& from, scene::Material& material) {
    aiColor3D colour;
    const bool textured = from.GetTextureCount(aiTextureType_DIFFUSE) > 0;
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS && !textured) {
      material.reflectance = {colour.r, colour.g, colour.b};
      material.reflectance_stated = true;
    }
    if (textured) count("images of materials");
    if (from.Get(AI_MATKEY_COLOR_EMISSIVE, colour) == aiReturn_SUCCESS && !colour.IsBlack()) {
      count("emissive colours, which have no unit");
    }
    float opacity = 1;
    if (from.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity < 1) count("transparency of materials");
    int two_sided = 0;
    if (from.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS) material.double_sided = two_sided != 0;
  }

  // Depth first, in the file's order.
  void walk(const aiScene& model, const glm::dmat4& root) {
    std::vector<PlacedNode> pending{{model.mRootNode, root, 1}};
    while (!pending.empty() && !full_) {
      const PlacedNode next = pending.back();
      pending.pop_back();
      place_meshes(model, next);
      if (next.depth >= input_.limits.node_depth) {
        if (next.node->mNumChildren > 0)
          refuse("nodes are nested deeper than " + std::to_string(input_.limits.node_depth));
        continue;
      }
      for (unsigned i = next.node->mNumChildren; i-- > 0;) {
        const aiNode* const child = next.node->mChildren[i];
        pending.push_back({child, next.world * matrix_of(child->mTransformation), next.depth + 1});
      }
    }
  }

  void place_meshes(const aiScene& model, const PlacedNode& placed) {
    for (unsigned i = 0; i < placed.node->mNumMeshes && !full_; ++i) {
      const unsigned index = placed.node->mMeshes[i];
      if (index >= model.mNumMeshes) continue;
      place_mesh(*model.mMeshes[index], index, placed);
    }
  }

  void place_mesh(const aiMesh& mesh, unsigned index, const PlacedNode& placed) {
    std::string why = limit_before_vertices(builder_.scene(), mesh.mNumVertices, input_.limits);
    if (why.empty() && ++instances_ > input_.limits.instances)
      why = "meshes are placed too often; the rest is left out";
    if (!why.empty()) {
      full_ = true;
      return refuse(std::move(why));
    }
    builder_.add_section({input_.path, "/meshes/" + std::to_string(index), scene::RecordKind::Element});
    builder_.use_object(builder_.object(name_of(placed.node->mName)));
    builder_.use_group(builder_.group(name_of(mesh.mName)));
    builder_.use_material(mesh.mMaterialIndex < materials_.size() ? materials_[mesh.mMaterialIndex] : 0);
    const auto first = static_cast<scene::VertexId>(builder_.vertex_count());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& at = mesh.mVertices[i];
      builder_.add_vertex(scene::dvec3(placed.world * glm::dvec4(at.x, at.y, at.z, 1.0)));
    }
    const bool mirrored = glm::determinant(glm::dmat3(placed.world)) < 0;
    for (unsigned i = 0; i < mesh.mNumFaces && !full_; ++i) add_face(mesh, i, first, mirrored);
  }

  void add_face(const aiMesh& mesh, unsigned index, scene::VertexId first, bool mirrored) {
    const aiFace& face = mesh.mFaces[index];
    if (face.mNumIndices < 3) return count(face.mNumIndices == 2 ? "lines" : "points");
    std::string why = limit_before_face(builder_.scene(), face.mNumIndices, input_.limits);
    if (!why.empty()) {
      full_ = true;
      return refuse(std::move(why));
    }
    corners_.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      if (face.mIndices[i] >= mesh.mNumVertices) {
        issues_.add({ReadIssueKind::IndexOutOfRange, index_outside(face.mIndices[i], mesh.mNumVertices), {}, 1});
        return;
      }
      corners_.push_back(first + face.mIndices[i]);
    }
    if (mirrored) std::ranges::reverse(corners_);
    builder_.add_face(corners_, index);
  }

  const Input& input_;
  std::string format_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  std::vector<scene::MaterialId> materials_;
  std::vector<scene::VertexId> corners_;
  std::uint64_t instances_ = 0;
  bool full_ = false;
};

bool sniff(std::string_view head) {
  return head.starts_with(kFbxMark) || (head.starts_with("<?xml") && head.find("<COLLADA") != std::string_view::npos);
}

ReadResult read(const Input& input) { return AssimpReader(input).run(); }

}  // namespace
}  // namespace assimp

std::string assimp_version();
std::string assimp_version() {
  return std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) + "." +
         std::to_string(aiGetVersionPatch());
}

const Reader assimp_reader{"assimp", kAssimpSuffixes, assimp::sniff, assimp::read};

}  // namespace rad::readers
