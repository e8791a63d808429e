#include "corpus/mutate/mutator.h"

#include <numeric>

namespace rad::corpus {

std::span<const Mutator> mutators() {
  static const std::vector<Mutator> all = [] {
    std::vector<Mutator> list;
    for (const auto part : {edge_mutators(), face_mutators(), contact_mutators(), solid_mutators(), material_mutators(),
                            unit_mutators()}) {
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

geom::Box ball_box(const dvec3& centre, double radius) {
  geom::Box box;
  box.add(centre - dvec3(radius));
  box.add(centre + dvec3(radius));
  return box;
}

}  // namespace rad::corpus
