#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// Distance between the lines of the two diagonals, in pitches: how far the surfaces of the two ways to draw a
// quadrilateral lie apart in its middle. Nothing where the diagonals have no distance to speak of.
std::optional<double> gap_of(const Context& context, FaceId id) {
  const scene::Face& face = context.scene.faces[id];
  if (face.loop_count != 1 || context.scene.loops[face.first_loop].count != 4) return std::nullopt;
  std::array<dvec3, 4> corner;
  std::size_t i = 0;
  for (const PointId p : context.model.corners_of(context.scene.loops[face.first_loop])) {
    const geom::LatticePoint& q = context.model.points[p];
    corner[i++] = {q.x, q.y, q.z};
  }
  const dvec3 across = glm::cross(corner[2] - corner[0], corner[3] - corner[1]);
  const double length = glm::length(across);
  if (length == 0) return std::nullopt;
  return std::abs(glm::dot(across, corner[1] - corner[0])) / length;
}

void check(const Context& context, Violations& out) {
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!context.is_sound(id)) continue;
    const auto gap = gap_of(context, id);
    if (!gap || *gap <= static_cast<double>(context.tolerance.pitches)) continue;
    out.add({.faces = {id, kNoFace},
             .point = context.centre(id),
             .measure = context.length(*gap),
             .cluster = kPerParticipants});
  }
}

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule nonplanar_quad_display{
    .id = "RL303",
    .alias = "nonplanar-quad-display",
    .title = "A quadrilateral is seen differently by different viewers",
    .message =
        "{n} bent quadrilateral{s}{object}: drawn along one diagonal or the other, surfaces differ by {measure} "
        "(tolerance {limit})",
    .requirement = Requirement::Ziplocking,
    .severity = scene::Severity::Warning,
    .measure = {"distance between diagonals", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "pmesh",
    .citation = "baum91 2.3",
    .doc = {.what = "The two diagonals of a face with four corners pass each other at more than the tolerance.",
            .why = "A display draws triangles. Which diagonal it takes is its own affair, and with a bent face the "
                   "surface, its shading and what touches it in the middle come out one way or the other.",
            .how = "Distance between the lines of the diagonals, against T: twice the distance that RL008 measures, so "
                   "that this speaks of quadrilaterals that still count as flat for meshing.",
            .fix = "radfix --mesh makes triangles of such faces (Pmesh). In a model nothing is required.",
            .modeller = "Blender: Triangulate Faces fixes the diagonal, Make Planar Faces flattens. Rhino: triangulate "
                        "quads of meshes. SketchUp and Revit draw planar faces only; imported ones need triangulation.",
            .limits = "Polygons with more corners are RL008 only."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
