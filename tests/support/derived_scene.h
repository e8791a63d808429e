// A scene with everything that rules look at, step by step as lint() derives it.
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/lattice_model.h"
#include "scene/scene_builder.h"
#include "validate/topology.h"

namespace rad::tests {

struct DerivedScene {
  scene::Scene scene;
  scene::LatticeModel model;
  geom::Tolerance tolerance;
  validate::FaceTriangles triangles;
  validate::Contacts contacts;
  validate::Topology topology;

  /// `length` is the tolerance in file units.
  DerivedScene(scene::Scene raw, double length) : scene(std::move(raw)), model(scene::build_lattice_model(scene)) {
    const geom::ToleranceRequest request{length, geom::ToleranceRequest::Measure::FileUnits};
    tolerance = geom::requested_tolerance(request, scene::tolerance_basis(scene, model), {}).tolerance.value();
    triangles = validate::triangulate_faces(scene, model, tolerance);
    contacts = validate::find_contacts(triangles, tolerance);
    topology = validate::build_topology(scene, model, triangles, contacts);
  }

  /// The lattice point at a place in file units; kNoPoint where no face has one.
  [[nodiscard]] scene::PointId point_at(const scene::dvec3& place) const {
    const auto found = std::lower_bound(model.points.begin(), model.points.end(), model.lattice.nearest(place));
    if (found == model.points.end() || *found != model.lattice.nearest(place)) return scene::kNoPoint;
    return static_cast<scene::PointId>(found - model.points.begin());
  }
};

/// Builds scenes from places, each corner a vertex of its own.
class SceneSketch {
 public:
  SceneSketch() : builder_("scene.obj", "obj") { builder_.add_section({"scene.obj", "", scene::RecordKind::Line}); }

  void use(std::string_view object, std::string_view material) {
    builder_.use_object(builder_.object(object));
    builder_.use_material(builder_.material(material));
  }
  scene::FaceId face(const std::vector<scene::dvec3>& places) {
    return builder_.add_face(ids_of(places), builder_.scene().faces.size() + 1);
  }
  void hole(const std::vector<scene::dvec3>& places) { builder_.add_hole(ids_of(places)); }

  /// Axis-parallel box of six outward rectangles; the one at `left_out`, if any, is missing (0 low x, 1 high x … 5).
  void box(const scene::dvec3& low, const scene::dvec3& high, int left_out = -1) {
    const auto at = [&](int bits) {
      return scene::dvec3(bits & 1 ? high.x : low.x, bits & 2 ? high.y : low.y, bits & 4 ? high.z : low.z);
    };
    constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int side = 0; side < 6; ++side) {
      const auto& corner = kSides[side];
      if (side != left_out) face({at(corner[0]), at(corner[1]), at(corner[2]), at(corner[3])});
    }
  }
  scene::Scene take() { return builder_.take(); }

 private:
  std::vector<scene::VertexId> ids_of(const std::vector<scene::dvec3>& places) {
    std::vector<scene::VertexId> ids;
    for (const scene::dvec3& place : places) ids.push_back(builder_.add_vertex(place));
    return ids;
  }

  scene::SceneBuilder builder_;
};

}  // namespace rad::tests
