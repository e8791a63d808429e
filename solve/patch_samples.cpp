#include "solve/patch_samples.h"

#include <tbb/parallel_for.h>

namespace rad::solve {
namespace {

/// Where a receiver stands for the mesh: at its node, or at the centre of its element.
dvec3 point_of(const mesh::RadiosityMesh& mesh, ReceiverId receiver) {
  if (receiver < mesh.nodes.size()) return mesh.nodes[receiver].position;
  return stratum_of(mesh.elements[receiver - mesh.nodes.size()].corners, mesh).centre();
}

}  // namespace

PatchSamples patch_samples(const mesh::RadiosityMesh& mesh, const Radiators& radiators) {
  PatchSamples samples;
  samples.receiver.resize(mesh.patches.size());
  samples.share.resize(radiators.local_receiver.size());
  ReceiverId centre = centre_of(mesh, mesh.elements.size());
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    const mesh::Corners& corners = mesh.patches[patch].corners;
    std::array<ReceiverId, 5>& receiver = samples.receiver[patch];
    for (std::uint32_t i = 0; i < 4; ++i) receiver[i] = corners.node[i < corners.count ? i : 0];
    const Radiator& radiator = radiators.patch[patch];
    receiver[kCentreShare] = radiator.element_count == 1 ? centre_of(mesh, radiator.first_element) : centre++;
  }
  tbb::parallel_for(std::size_t{0}, mesh.patches.size(), [&](std::size_t patch) {
    const Stratum whole_patch = stratum_of(mesh.patches[patch].corners, mesh);
    const Radiator& radiator = radiators.patch[patch];
    for (std::uint32_t i = 0; i < radiator.local_count; ++i) {
      const std::uint32_t local = radiator.first_local + i;
      const Shares shares =
          shape_at(whole_patch.count, place_in(whole_patch, point_of(mesh, radiators.local_receiver[local])));
      for (std::size_t k = 0; k < shares.size(); ++k) samples.share[local][k] = static_cast<float>(shares[k]);
    }
  });
  return samples;
}

}  // namespace rad::solve
