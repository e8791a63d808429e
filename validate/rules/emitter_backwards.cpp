#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "validate/component_members.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-ahead", "1", 0.1, 0.001, 1,
              "distance ahead of a lamp over that behind it, up to which it is turned"},
};

// Of a component with more emitting faces the first by place are asked.
constexpr std::size_t kAskedFaces = 16;
// What is farther ahead than half of the lamp's own size is lit by it, whatever is behind.
constexpr double kNearSizes = 0.5;

// Share of the way from `from` to `to` at which a triangle is met; nothing where it is not.
std::optional<double> meeting(const geom::LatticeTriangle& triangle, const dvec3& from, const dvec3& to) {
  const dvec3 a = geom::as_vector(triangle.points[0]), way = to - from;
  const dvec3 u = geom::as_vector(triangle.points[1]) - a, v = geom::as_vector(triangle.points[2]) - a;
  const dvec3 across = glm::cross(way, v);
  const double determinant = glm::dot(u, across);
  if (determinant == 0) return std::nullopt;
  const double s = glm::dot(from - a, across) / determinant;
  const dvec3 turned = glm::cross(from - a, u);
  const double t = glm::dot(way, turned) / determinant;
  const double share = glm::dot(v, turned) / determinant;
  if (s < 0 || t < 0 || s + t > 1 || share < 0 || share > 1) return std::nullopt;
  return share;
}

// Pitches to the nearest other face along a ray; infinite where there is none.
double free_way(const Context& context, FaceId face, const dvec3& from, const dvec3& direction) {
  const double reach = 2 * context.tolerance.diagonal / context.model.lattice.pitch;
  const dvec3 to = from + direction * reach;
  double nearest = std::numeric_limits<double>::infinity();
  context.contacts.tree->for_each_near_segment(from, to, 1, [&](std::uint32_t i) {
    if (context.triangles.triangles[i].face == face) return;
    if (const auto share = meeting(context.triangles.geometry[i], from, to))
      nearest = std::min(nearest, *share * reach);
  });
  return nearest;
}

// How near what the face shines at is, as a share of what is behind it; nothing where it is not so near at all.
std::optional<double> share_ahead(const Context& context, FaceId face) {
  const dvec3 centre = (context.centre(face) - context.model.lattice.origin) / context.model.lattice.pitch;
  const double twice_area = glm::length(context.triangles.normal[face]);
  const dvec3 normal = context.triangles.normal[face] / twice_area;
  const double start = static_cast<double>(context.tolerance.pitches);
  const double ahead = free_way(context, face, centre + start * normal, normal);
  if (ahead > kNearSizes * std::sqrt(twice_area / 2)) return std::nullopt;
  return ahead / free_way(context, face, centre - start * normal, -normal);
}

std::vector<FaceId> asked_faces(const Context& context, std::vector<FaceId> faces) {
  std::erase_if(faces, [&](FaceId face) { return !any_emits(context, {face}) || !context.is_sound(face); });
  const auto count = static_cast<std::ptrdiff_t>(std::min(kAskedFaces, faces.size()));
  std::partial_sort(faces.begin(), faces.begin() + count, faces.end(),
                    [&](FaceId a, FaceId b) { return context.precedes(a, b); });
  faces.resize(static_cast<std::size_t>(count));
  return faces;
}

double threshold(const Context& context) { return context.parameter(emitter_backwards, "max-ahead"); }

void check(const Context& context, Violations& out) {
  const auto& materials = context.scene.materials;
  if (std::ranges::none_of(materials, &scene::Material::emits)) return;
  const ComponentMembers members = members_of_components(context);
  const double most = threshold(context);
  for (std::uint32_t id = 0; id < members.faces.size(); ++id) {
    if (context.topology.components[id].open_subedges == 0) continue;
    for (const FaceId face : asked_faces(context, members.faces[id])) {
      const auto share = share_ahead(context, face);
      if (!share || *share > most) continue;
      out.add(
          {.faces = {face, kNoFace}, .point = context.centre(face), .measure = *share, .cluster = kPerParticipants});
    }
  }
}

}  // namespace

constinit const Rule emitter_backwards{
    .id = "RL403",
    .alias = "emitter-backwards",
    .title = "A lamp shines into what it is mounted on",
    .message =
        "{n} emitting face{s} {looks|look} the wrong way{object}: what is ahead is at {measure} of the distance "
        "to what is behind",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"distance ahead over behind", MeasureUnit::Ratio, true},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "The front of an open surface that emits light faces a wall or ceiling that is very near, and its "
                    "back faces the room.",
            .why = "Faces emit from their fronts only: the lamp lights the spot that it hangs on, and the room stays "
                   "dark.",
            .how = "Rays from the middle of up to 16 emitting faces of each open surface, along the normal and against "
                   "it. What is ahead is nearer than half the size of the face and than a tenth of what is behind.",
            .fix = "Turn the face.",
            .modeller = "SketchUp: Reverse Faces. Rhino: Flip. Blender: Mesh > Normals > Flip. Revit: mirrored light "
                        "families cause it; place them anew.",
            .limits = "A lamp that is meant to light the wall that it nearly touches is reported. A lamp that lies in "
                      "the plane of the ceiling is not; overlaps are RL220 to RL222."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
