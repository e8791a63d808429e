#include "validate/context.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <tuple>

#include "geom/auto_tolerance.h"
#include "scene/near_distances.h"

namespace rad::validate {
namespace {

std::vector<geom::Box> boxes_of_objects(const scene::Scene& scene, const scene::LatticeModel& model) {
  std::vector<geom::Box> boxes(scene.objects.size());
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
      for (const PointId p : model.corners_of(loop)) {
        if (p != scene::kNoPoint) boxes[scene.faces[id].object].add(model.position(p));
      }
    }
  }
  return boxes;
}

}  // namespace

dvec3 Context::centre(FaceId face) const {
  // Summed exactly: the same whichever corner a loop starts with.
  std::array<std::int64_t, 3> sum{};
  std::int64_t count = 0;
  for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
    for (const PointId id : model.corners_of(loop)) {
      if (id == scene::kNoPoint) continue;
      const geom::LatticePoint& p = model.points[id];
      sum = {sum[0] + p.x, sum[1] + p.y, sum[2] + p.z};
      ++count;
    }
  }
  const double share = count > 0 ? 1.0 / static_cast<double>(count) : 0.0;
  return position(dvec3(static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])) * share);
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

std::optional<geom::Tolerance> chosen_tolerance(const scene::Scene& scene, const scene::LatticeModel& model,
                                                const std::optional<geom::ToleranceRequest>& tolerance,
                                                std::string& refusal) {
  const geom::ToleranceBasis basis = scene::tolerance_basis(scene, model);
  if (!tolerance || model.points.empty()) return geom::default_tolerance(basis);
  if (tolerance->measure == geom::ToleranceRequest::Measure::Auto) {
    return geom::auto_tolerance(basis, scene::near_distances(scene, model));
  }
  auto outcome = geom::requested_tolerance(*tolerance, basis, scene.metres_per_unit);
  if (!outcome.tolerance) refusal = std::move(outcome.problem);
  return outcome.tolerance;
}

std::optional<Context> build_context(const scene::Scene& scene, const scene::ReadIssues& issues,
                                     const std::optional<geom::ToleranceRequest>& tolerance, std::string& refusal,
                                     const std::function<void(std::string_view)>& lap) {
  const auto done = [&](std::string_view step) {
    if (lap) lap(step);
  };
  Context context{scene, issues, scene::build_lattice_model(scene), {}, {}, {}, {}, {}, {}, {}};
  done("lattice");
  const auto chosen = chosen_tolerance(scene, context.model, tolerance, refusal);
  if (!chosen) return std::nullopt;
  context.tolerance = *chosen;
  done("tolerance");
  context.object_boxes = boxes_of_objects(scene, context.model);
  context.triangles = triangulate_faces(scene, context.model, context.tolerance);
  done("triangulate");
  context.contacts = find_contacts(context.triangles, context.tolerance);
  context.index_contacts();
  done("contacts");
  context.topology = build_topology(scene, context.model, context.triangles, context.contacts);
  done("topology");
  return context;
}

Context context_after_turning(Context before, const scene::Scene& scene, const std::vector<FaceId>& turned) {
  Context context{scene, before.issues, scene::build_lattice_model(scene), before.tolerance, {}, {}, {}, {}, {}, {}};
  context.object_boxes = std::move(before.object_boxes);
  context.triangles = triangulate_faces(scene, context.model, context.tolerance);
  context.contacts = std::move(before.contacts);
  for (FaceContact& contact : context.contacts.faces) {
    const auto is_turned = [&](FaceId face) { return std::binary_search(turned.begin(), turned.end(), face); };
    const bool opposed = is_turned(contact.a) != is_turned(contact.b);
    if (opposed) contact.same_facing = !contact.same_facing;
  }
  context.index_contacts();
  context.topology = build_topology(scene, context.model, context.triangles, context.contacts);
  return context;
}

}  // namespace rad::validate
