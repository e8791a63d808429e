#include <glm/geometric.hpp>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// Whether every corner of the outer loop has a normal, and all point to the back.
bool all_point_back(const Context& context, FaceId id) {
  const auto& normals = context.scene.attributes.normals;
  const scene::Loop& loop = context.scene.loops[context.scene.faces[id].first_loop];
  for (std::uint32_t i = 0; i < loop.count; ++i) {
    const scene::RowId row = normals.row(loop.first + i);
    if (row == scene::kNoRow || !(glm::dot(normals.table[row], context.triangles.normal[id]) < 0)) return false;
  }
  return loop.count > 0;
}

void check(const Context& context, Violations& out) {
  if (context.scene.attributes.normals.empty()) return;
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!context.is_sound(id) || !all_point_back(context, id)) continue;
    out.add({.faces = {id, kNoFace}, .point = context.centre(id), .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule normal_vs_winding{
    .id = "RL111",
    .alias = "normal-vs-winding",
    .title = "Stored normals point to the back of their face",
    .message = "{n} face{s} whose stored normals all point to the back{object}",
    .requirement = Requirement::NormalConsistency,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "The normals that the file stores at the corners of a face point to its other side than the order "
                    "of its corners does.",
            .why = "The front of a face is the side from which its corners run counter-clockwise; that side is lit. A "
                   "viewer that shades by the stored normals shows the other. One of the two is wrong, and often it "
                   "is the winding, after a mirrored copy.",
            .how = "All normals stored at the corners of the outer loop are more than 90 degrees from the normal of "
                   "the winding. One that is not is enough to be silent: at sharp edges smooth normals lean over.",
            .fix = "See which side is meant and turn the faces, or drop the normals and let them be computed. radfix "
                   "goes by the winding and by what encloses what (RL110, RL104, RL112).",
            .modeller = "Blender: Mesh > Normals > Reset Vectors, and Flip where the face itself is the wrong way. "
                        "Rhino: RebuildMeshNormals, Flip. SketchUp: Reverse Faces. Revit: mirrored families cause it.",
            .limits = "Faces whose normals are stored at some corners only are not judged."},
    .check = &check,
};

}  // namespace rad::validate
