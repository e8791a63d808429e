// The light of one page of an atlas.
#pragma once

#include <vector>

#include "bake/atlas.h"
#include "mesh/radiosity_field.h"

namespace rad::bake {

/// Texels by rows from the top, each row from the left.
struct LightPage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> radiosity;  ///< three for each texel, W/m², linear RGB; 0 where no chart and no gutter is
  std::vector<float> coverage;   ///< share of the texel's square that lies in its chart, 0 to 1
};

/// Paints the charts of a page. A texel whose centre lies in its chart has the value of its element there, linear in
/// triangles, bilinear in quadrilaterals. Other texels within kGutter of the chart go on from the nearest point of its
/// border, linearly with the slopes of the element there, not below 0 and not above twice the value at that point; then
/// those next to the border, on both sides of it, are balanced (BorderBalance) so that bilinear interpolation meets the
/// values of the nodes along the border. So both charts at an edge whose nodes they share show the same there. The same
/// bits for any number of threads.
LightPage paint_page(const Atlas& atlas, std::uint32_t page, const mesh::RadiosityMesh& mesh,
                     const mesh::RadiosityField& field);

}  // namespace rad::bake
