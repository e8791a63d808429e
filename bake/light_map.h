// A solution as light maps: pages to be stored and pages to be shown.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake/atlas.h"
#include "bake/exr.h"
#include "bake/light_page.h"
#include "geom/lattice.h"
#include "mesh/display_mesh.h"
#include "mesh/radiosity_field.h"
#include "scene/display_curve.h"
#include "scene/light_map.h"

namespace rad::bake {

/// Between the whites of one material. A chart has at least the codes up to that of 1 / kWhiteStep, 103; so half a code
/// is at most 1.2 codes where its brightest is white. A material comes at most kWhites times for this.
inline constexpr double kWhiteStep = 8;
inline constexpr int kWhites = 4;

/// What the texels of the stored pages are.
enum class StoredQuantity : std::uint8_t {
  Exitance,    ///< radiant exitance M, own emission included: the radiosity
  Irradiance,  ///< E = (M - emission) / reflectance; 0 in a channel that the material does not reflect
};

struct LightMapOptions {
  scene::LightMapLook look = scene::LightMapLook::Unlit;
  StoredQuantity stored = StoredQuantity::Exitance;
  double exposure = 1;                                      ///< m²/W, above 0
  scene::DisplayCurve curve = scene::DisplayCurve::Linear;  ///< of unlit pages that are shown
  std::string software;                                     ///< for the headers
};

struct BakedPage {
  std::string exr;
  std::string png;
  double area = 0;          ///< of its charts, file units²
  double clamped_area = 0;  ///< of it, where a channel is above white
};

class LightMapBaker {
 public:
  /// `materials` are those that the patches name; all that is referred to outlives the object.
  LightMapBaker(const Atlas& atlas, const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                const mesh::RadiosityField& field, LightMapOptions options);

  /// One page; about 30 bytes a texel while it works.
  [[nodiscard]] BakedPage bake(std::uint32_t page) const;

  /// Of all stored pages.
  [[nodiscard]] ExrPrecision precision() const { return precision_; }
  /// The radiosity of each chart, W/m², that is shown as 1: unlit the same for all, 1 / exposure; emissive the largest
  /// of the nodes and channels of the chart's material, so that nothing is cut off, over a power of kWhiteStep as far
  /// as that still holds for the chart, so that dark rooms have codes too. Above 0.
  [[nodiscard]] const std::vector<double>& white() const { return white_; }

 private:
  struct Transfer {
    dvec3 from{0, 0, 0};
    dvec3 factor{1, 1, 1};
    [[nodiscard]] dvec3 stored(const dvec3& radiosity) const { return (radiosity - from) * factor; }
  };

  void choose_white();
  void choose_precision();
  [[nodiscard]] std::string exr_page(const LightPage& page, std::uint32_t index) const;
  [[nodiscard]] std::string png_page(const LightPage& page, std::uint32_t index) const;
  void add_areas(const LightPage& page, std::uint32_t index, BakedPage& baked) const;
  [[nodiscard]] std::vector<double> brightest_of_charts() const;
  [[nodiscard]] scene::MaterialId material_of(std::uint32_t chart) const;

  const Atlas& atlas_;
  const mesh::RadiosityMesh& mesh_;
  const mesh::RadiosityField& field_;
  LightMapOptions options_;
  std::vector<Transfer> transfer_;  ///< of each material
  std::vector<double> white_;       ///< of each chart
  ExrPrecision precision_ = ExrPrecision::Half;
};

/// Pages and coordinates for the faces of display_scene(), in the order of their corners; no images. `white` is that of
/// each chart, W/m².
scene::LightMap light_map_places(const Atlas& atlas, const mesh::DisplayMesh& display, const geom::Lattice& lattice,
                                 std::span<const double> white);

}  // namespace rad::bake
