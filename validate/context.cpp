#include "validate/context.h"

#include <numeric>
#include <string_view>
#include <tuple>

namespace rad::validate {

dvec3 Context::centre(FaceId face) const {
  dvec3 sum{0, 0, 0};
  double count = 0;
  for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
    for (const PointId p : model.corners_of(loop)) {
      if (p == scene::kNoPoint) continue;
      sum += position(p);
      ++count;
    }
  }
  return count > 0 ? sum / count : sum;
}

void Context::index_contacts() {
  contact_start.assign(scene.faces.size() + 1, 0);
  for (const FaceContact& contact : contacts.faces) {
    ++contact_start[contact.a + 1];
    ++contact_start[contact.b + 1];
  }
  std::partial_sum(contact_start.begin(), contact_start.end(), contact_start.begin());
  std::vector<std::uint32_t> next = contact_start;
  contact_index.resize(contact_start.back());
  for (std::uint32_t i = 0; i < contacts.faces.size(); ++i) {
    contact_index[next[contacts.faces[i].a]++] = i;
    contact_index[next[contacts.faces[i].b]++] = i;
  }
}

std::pair<const std::uint32_t*, const std::uint32_t*> Context::contacts_of(FaceId face) const {
  return {contact_index.data() + contact_start[face], contact_index.data() + contact_start[face + 1]};
}

bool Context::precedes(FaceId a, FaceId b) const {
  const auto key = [&](FaceId id) {
    const dvec3 middle = centre(id);
    return std::tuple(std::string_view(scene.objects[object_of(id)]),
                      std::string_view(scene.materials[material_of(id)].name), middle.x, middle.y, middle.z, id);
  };
  return key(a) < key(b);
}

}  // namespace rad::validate
