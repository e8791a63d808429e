// Where each chart of a light map lies: sizes in texels, and places on pages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bake/light_charts.h"

namespace rad::bake {

/// Texels around a chart that hold its light beyond its border: one for bilinear interpolation, one for the coarser
/// level that a viewer may make.
inline constexpr std::uint32_t kGutter = 2;
/// Longest side of a page: what every viewer of today shows, and the most that is asked of anyone.
inline constexpr std::uint32_t kDefaultPageSize = 4096;
inline constexpr std::uint32_t kLeastPageSize = 64;
inline constexpr std::uint32_t kMostPageSize = 8192;
/// Of all pages: eight of 4096 × 4096, about 1 GiB once encoded.
inline constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 27;
/// What a texel that nobody asked for may come to: one page of 4096 × 4096.
inline constexpr std::uint64_t kModestTexels = std::uint64_t{1} << 24;

/// A side that is a whole number of texels but for rounding has that number of them. Float32 coordinates are off by
/// 2^-24 of themselves, so a side whose ends lie up to 8 times its length from the origin by up to 2^-20 of it.
inline constexpr double kTexelRounding = 0x1p-20;

struct AtlasOptions {
  /// Longest side of a texel, but for kTexelRounding of it; file units, above 0; nothing: chosen.
  std::optional<double> texel;
  double finest_texel = 0;  ///< where it is chosen: not below this, and as large as kModestTexels needs; above 0
  std::uint32_t page_size = kDefaultPageSize;  ///< kLeastPageSize to kMostPageSize
  std::uint64_t most_texels = kMostTexels;     ///< of all charts with their gutters, and of all pages
};

/// A rectangle of texels on a page. The centres of the texels inside the gutter lie on a grid from the chart's origin
/// to the end of its sides, so that the sides of a rectangle run through centres and are met exactly.
struct ChartPlace {
  std::uint32_t page = 0;
  std::uint32_t x = 0;        ///< upper left texel, gutter included
  std::uint32_t y = 0;        ///< from the top
  std::uint32_t columns = 0;  ///< gutter included
  std::uint32_t rows = 0;
  dvec2 texel{0, 0};  ///< sides of a texel along right and down, file units

  /// From file units along right and down to texels of the rectangle: (i, j) is the centre of column i in row j.
  [[nodiscard]] dvec2 to_texels(const dvec2& in_plane) const { return in_plane / texel + static_cast<double>(kGutter); }
};

struct AtlasPage {
  std::uint32_t width = 0;  ///< texels
  std::uint32_t height = 0;
};

struct Atlas {
  std::string problem;  ///< why there is none; then the rest is empty
  std::vector<LightChart> charts;
  std::vector<ChartPlace> places;             ///< of each chart
  std::vector<std::uint32_t> chart_of_patch;  ///< of the mesh
  std::vector<std::uint8_t> shared_node;      ///< of the mesh: 1 where elements of several charts have the node
  std::vector<AtlasPage> pages;
  double texel = 0;  ///< longest side of a texel that is allowed, file units

  /// Coordinates in the image of a page, 0 to 1, from the upper left corner.
  [[nodiscard]] dvec2 page_coordinates(std::uint32_t chart, const dvec3& position) const;
};

/// Lays out the charts of the mesh. Nothing as large as a page is allocated. Problem: charts that do not fit on a page,
/// or on all, with texels of the size that is asked for; it names one that fits.
Atlas lay_out_atlas(const mesh::RadiosityMesh& mesh, const AtlasOptions& options);

}  // namespace rad::bake
