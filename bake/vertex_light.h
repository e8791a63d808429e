// The light of a solution on the vertices of the display mesh, and the exposure that shows it.
#pragma once

#include <optional>
#include <span>

#include "mesh/display_mesh.h"
#include "mesh/radiosity_field.h"
#include "mesh/radiosity_mesh.h"
#include "scene/vertex_light.h"

namespace rad::bake {

/// Share of the area of non-emitting materials that is to be shown below kWhitePoint.
inline constexpr double kExposurePercentile = 0.98;
/// Linear display value of the luminance at that percentile: below 1, so that the brighter rest keeps some shape.
inline constexpr double kWhitePoint = 0.8;

using scene::luminance;

/// kWhitePoint over the least luminance that kExposurePercentile of the area does not exceed, in m²/W. Each element of
/// a material that emits nothing gives an equal share of its area to each of its nodes. Where that luminance is zero
/// the greatest of those nodes takes its place; where all of them are dark, or no such material is there, all elements
/// count. 1 where everything is dark.
double automatic_exposure(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                          const mesh::RadiosityField& field);

/// Radiosity and colour of each display vertex; `field` holds a value for each node of `mesh`, and `materials` are
/// those that its patches name. A vertex between two nodes gets its share of both. `exposure` in m²/W, positive;
/// automatic_exposure() where none is given; under false colours what is white then is the next round_above().
scene::VertexLight vertex_light(const mesh::DisplayMesh& display, const mesh::RadiosityMesh& mesh,
                                std::span<const scene::Material> materials, const mesh::RadiosityField& field,
                                std::optional<double> exposure,
                                scene::DisplayCurve curve = scene::DisplayCurve::Linear);

}  // namespace rad::bake
