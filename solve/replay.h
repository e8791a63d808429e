// What all shots so far bring to points that are no locals of the mesh that was solved: nodes that refinement adds.
#pragma once

#include <vector>

#include "solve/coupling_store.h"
#include "solve/shooting.h"

namespace rad::solve {

/// A point of an element of the mesh, off its surface as receivers are.
struct ReplayPoint {
  Receiver receiver;
  std::uint32_t element = 0;  ///< index into RadiosityMesh::elements
};

/// Plays all shots again, at these points alone: what a local there would have received, irradiance in W/m². What
/// changes little over a patch, or over the element, is interpolated there by the quadratic through corners and centre;
/// all other radiators are looked at from each point. No error of an earlier interpolation is carried along (instead of
/// either option of paper section 4). `shot_by` has all that each patch has shot; those without locals have shot
/// nothing. Points are sorted by element. The same whatever the number of threads.
std::vector<dvec3> replay(const CouplingSource& source, CouplingStore& couplings, const Irradiance& irradiance,
                          std::span<const Shot> shot_by, std::span<const ReplayPoint> points);

}  // namespace rad::solve
