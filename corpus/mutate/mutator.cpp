#include "corpus/mutate/mutator.h"

#include <algorithm>
#include <numeric>

#include "geom/tolerance.h"
#include "scene/lattice_model.h"

namespace rad::corpus {

std::span<const Mutator> mutators() {
  static const std::vector<Mutator> all = [] {
    std::vector<Mutator> list;
    for (const auto part : {edge_mutators(), face_mutators(), contact_mutators(), solid_mutators(), fine_mutators(),
                            surface_mutators(), material_mutators(), unit_mutators()}) {
      list.insert(list.end(), part.begin(), part.end());
    }
    return list;
  }();
  return all;
}

std::vector<FaceId> all_faces(const Survey& survey) {
  std::vector<FaceId> faces(survey.scene().faces.size());
  std::iota(faces.begin(), faces.end(), FaceId{0});
  return faces;
}

bool may_be_in_matter(const Survey& survey, const dvec3& point) {
  return std::ranges::any_of(survey.objects(), [&](const ObjectFacts& object) {
    if (object.faces.empty() || !object.closed || object.volume <= 0) return false;
    for (int axis = 0; axis < 3; ++axis) {
      if (point[axis] < object.box.low[axis] || point[axis] > object.box.high[axis]) return false;
    }
    return true;
  });
}

std::optional<Spot> spot_in_air(const Survey& survey, Random& random, double clearance) {
  constexpr int kTrials = 64;
  for (int trial = 0; trial < kTrials; ++trial) {
    auto spot = survey.free_spot(random, clearance);
    if (spot && !may_be_in_matter(survey, spot->point)) return spot;
  }
  return std::nullopt;
}

double tolerance_of(const scene::Scene& scene) {
  return geom::default_tolerance(scene::tolerance_basis(scene, scene::build_lattice_model(scene))).length;
}

geom::Box ball_box(const dvec3& centre, double radius) {
  geom::Box box;
  box.add(centre - dvec3(radius));
  box.add(centre + dvec3(radius));
  return box;
}

}  // namespace rad::corpus
