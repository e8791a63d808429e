#include "repair/contact_lint.h"

#include <algorithm>

#include "validate/contacts.h"

namespace rad::repair {
namespace {

validate::FaceTriangles faces_of(const TriangleSet& set) {
  validate::FaceTriangles faces;
  faces.triangles.reserve(set.triangles.size());
  faces.geometry.reserve(set.triangles.size());
  for (std::uint32_t i = 0; i < set.triangles.size(); ++i) {
    std::array<PointId, 3> points = set.triangles[i].points;
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    faces.triangles.push_back({points, i});
    faces.geometry.push_back(
        {{set.points[points[0]], set.points[points[1]], set.points[points[2]]}, std::array{true, true, true}});
  }
  faces.condition.assign(set.triangles.size(), validate::FaceCondition::Sound);
  return faces;
}

}  // namespace

std::vector<Violation> lint_contacts(const TriangleSet& set, std::int64_t tolerance) {
  scene::LatticeModel model;
  model.points.assign(set.points.begin(), set.points.end());
  geom::Tolerance length;
  length.pitches = tolerance;
  const validate::Contacts contacts = validate::find_contacts(model, faces_of(set), length);
  std::vector<Violation> found;
  for (const validate::FaceContact& contact : contacts.faces) {
    if (contact.kind == geom::ContactKind::Overlap) {
      if (contact.same_facing) found.push_back({ViolationKind::NearCoplanar, contact.a, contact.b, 0});
    } else {
      found.push_back({ViolationKind::Contact, contact.a, contact.b, 0});
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace rad::repair
