#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// Largest distance of a corner from the plane through the middle of the corners with the Newell normal, in pitches.
double warp_of(const Context& context, FaceId id) {
  const dvec3 normal = glm::normalize(context.triangles.normal[id]);
  const dvec3 middle = (context.centre(id) - context.model.lattice.origin) / context.model.lattice.pitch;
  double warp = 0;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[id])) {
    for (const PointId p : context.model.corners_of(loop)) {
      const geom::LatticePoint& q = context.model.points[p];
      warp = std::max(warp, std::abs(glm::dot(normal, dvec3(q.x, q.y, q.z) - middle)));
    }
  }
  return warp;
}

bool is_polygon(const Context& context, FaceId id) {
  const scene::Face& face = context.scene.faces[id];
  return context.is_sound(id) && (face.loop_count > 1 || context.scene.loops[face.first_loop].count > 3);
}

void check(const Context& context, Violations& out) {
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!is_polygon(context, id)) continue;
    const double warp = warp_of(context, id);
    if (warp <= static_cast<double>(context.tolerance.pitches)) continue;
    out.add({.faces = {id, kNoFace},
             .point = context.centre(id),
             .measure = context.length(warp),
             .cluster = kPerParticipants});
  }
}

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule nonplanar_face{
    .id = "RL008",
    .alias = "nonplanar-face",
    .title = "A polygon is not flat",
    .message = "{n} polygon{s} not flat{object}; a corner lies {measure} off the plane (tolerance {limit})",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .measure = {"distance to plane", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 2.1",
    .doc = {.what = "A face of four or more corners does not lie in one plane.",
            .why =
                "The paper's faces are planar. How a warped one is split into triangles is anybody's choice, and two "
                "programs that choose differently see different surfaces.",
            .how =
                "The largest distance of a corner from the plane through the corners' middle with the Newell normal, "
                "against T. Distance only: angles between partial normals say little on small faces.",
            .fix = "radfix makes it of triangles, each in a plane of its own (Grouper).",
            .modeller = "Blender: Mesh > Clean Up > Make Planar Faces, or triangulate. SketchUp draws only planar "
                        "faces; imported ones need autofold. Rhino: quads of meshes may warp; triangulate them. Revit: "
                        "export with triangulated faces.",
            .limits = "None known."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
