// The paper's own search for shadow borders (3.4.3): the elements drawn onto a hemi-cube over an emitter, with the id
// and the depth of what each pixel shows. Kept for comparison: it sees no more than its raster does.
#pragma once

#include <string>
#include <vector>

#include "mesh/light_samples.h"
#include "mesh/patch_rays.h"

namespace rad::mesh {

/// Row by row; the five faces side by side: the top, then the four half faces in a row of full ones.
struct Hemicube {
  std::uint32_t resolution = 0;  ///< pixels along an edge of the top
  std::vector<ElementId> item;   ///< kNoElement where nothing is seen
  std::vector<float> depth;      ///< distance along the axis of the face, pitches; 0 where nothing is seen

  [[nodiscard]] std::uint32_t width() const { return 5 * resolution; }
  [[nodiscard]] std::size_t at(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * width() + column;
  }
};

Hemicube hemicube(const ElementMesh& mesh, const PatchRays& rays, const LightSample& light, std::uint32_t resolution);

/// Of neighbouring pixels of one face of the cube that show different elements at depths that differ by more than a
/// surface at 60 degrees would make them differ, marks the farther element.
void mark_steps(const Hemicube& cube, std::vector<std::uint8_t>& marked);

/// Writes the two buffers as channels `item` (unsigned integer) and `Z` (float) of an OpenEXR file; a problem, or
/// nothing.
std::string write_hemicube(const Hemicube& cube, const std::string& path);

}  // namespace rad::mesh
