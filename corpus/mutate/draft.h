// A scene taken apart into polygons that can be edited one by one, and put together again.
#pragma once

#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace rad::corpus {

using geom::dvec3;
using scene::FaceId;
using scene::VertexId;

struct DraftFace {
  std::vector<std::vector<VertexId>> loops;
  scene::Face record;  ///< material, object, group and source; its loop numbers mean nothing here
};

class Draft {
 public:
  explicit Draft(const scene::Scene& scene);

  std::vector<DraftFace> faces;

  VertexId add_vertex(const dvec3& position);
  [[nodiscard]] dvec3& vertex(VertexId id) { return scene_.vertices[id]; }
  scene::ObjectId add_object(std::string_view name);
  scene::MaterialId add_material(std::string_view name);
  [[nodiscard]] scene::Material& material(scene::MaterialId id) { return scene_.materials[id]; }
  /// Adds a face of new vertices at `ring`.
  FaceId add_face(const std::vector<dvec3>& ring, scene::MaterialId material, scene::ObjectId object);
  FaceId add_face_of(std::vector<VertexId> ring, scene::MaterialId material, scene::ObjectId object);
  /// A closed box with its own vertices: `corner` ± the three half axes, which are right-handed. Returns its base.
  FaceId add_box(const dvec3& centre, const dvec3& u, const dvec3& v, const dvec3& n, scene::MaterialId material,
                 scene::ObjectId object);

  [[nodiscard]] scene::Scene scene() const;

 private:
  scene::Scene scene_;  ///< all but faces, loops and corners
};

void reverse(DraftFace& face);

}  // namespace rad::corpus
