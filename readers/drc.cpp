// Plain Draco files: one mesh of triangles without names and materials.
#include <algorithm>
#include <array>
#include <cmath>

#include "readers/gltf_draco.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader drc_reader;

namespace {

constexpr std::array<std::string_view, 1> kSuffixes = {".drc"};
constexpr std::string_view kMagic = "DRACO";

std::optional<double> recorded(const gltf::DracoMesh& mesh, const char* name) {
  const auto found = mesh.numbers.find(name);
  if (found == mesh.numbers.end() || !std::isfinite(found->second)) return std::nullopt;
  return found->second;
}

geom::dvec3 origin_of(const gltf::DracoMesh& mesh) {
  return {recorded(mesh, "radfix.origin.x").value_or(0), recorded(mesh, "radfix.origin.y").value_or(0),
          recorded(mesh, "radfix.origin.z").value_or(0)};
}

scene::ReadIssue issue(scene::ReadIssueKind kind, std::string what) { return {kind, std::move(what), {}, 1}; }

void add_triangles(const gltf::DracoMesh& mesh, scene::SceneBuilder& builder, scene::ReadIssues& issues) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i];
    const std::uint32_t largest = std::max({corners[0], corners[1], corners[2]});
    if (largest >= mesh.positions.size()) {
      issues.add(issue(scene::ReadIssueKind::IndexOutOfRange,
                       "vertex index " + std::to_string(largest) + " of triangle " + std::to_string(i) +
                           " exceeds the " + std::to_string(mesh.positions.size()) + " vertices"));
      continue;
    }
    builder.add_face(corners, i);
  }
}

bool sniff(std::string_view head) { return head.starts_with(kMagic); }

ReadResult read(const Input& input) {
  ReadResult result;
  const gltf::DracoMesh mesh = gltf::decode_draco(input.bytes, {}, std::min(input.limits.vertices, input.limits.faces));
  scene::SceneBuilder builder(input.path, "drc");
  if (!mesh.fault.empty()) {
    result.issues.add(issue(scene::ReadIssueKind::ParseError, mesh.fault));
    result.scene = builder.take();
    return result;
  }
  const geom::dvec3 origin = origin_of(mesh);
  for (const geom::dvec3& position : mesh.positions) builder.add_vertex(origin + position);
  add_triangles(mesh, builder, result.issues);
  result.scene = builder.take();
  const auto pitch = recorded(mesh, "radfix.pitch"), tolerance = recorded(mesh, "radfix.tolerance");
  if (pitch && tolerance) result.scene.recorded = scene::RecordedLattice{{*pitch, origin}, *tolerance};
  return result;
}

}  // namespace

const Reader drc_reader{"drc", kSuffixes, sniff, read};

}  // namespace rad::readers
