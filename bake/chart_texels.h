// The texels of one chart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bake/element_function.h"
#include "bake/light_page.h"

namespace rad::bake {

using ElementIndex = std::uint32_t;

/// Values of the field over a chart, in the texels of its rectangle.
class ChartTexels {
 public:
  /// `elements` are those of the chart's patches, indices of mesh.elements; all that is referred to outlives the
  /// object.
  ChartTexels(const Atlas& atlas, std::uint32_t chart, const mesh::RadiosityMesh& mesh,
              const mesh::RadiosityField& field, std::vector<ElementIndex> elements);

  /// Fills the rectangle of the chart.
  void paint(LightPage& page);

 private:
  /// An edge of an element at the border of the chart.
  struct BorderEdge {
    ElementIndex element = 0;
    std::uint32_t edge = 0;  ///< from this corner of the flat element to the next
  };
  struct Nearest {
    double squared = 0;  ///< texels²
    std::uint32_t edge = 0;
  };
  /// Rows first to last - 1, and what reaches into them.
  struct Band {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::vector<ElementIndex> elements;
    std::vector<std::uint32_t> border;
  };

  /// Whether other charts have both nodes of the edge.
  [[nodiscard]] bool is_shared(ElementIndex element, std::uint32_t edge) const;
  [[nodiscard]] FlatElement flat(ElementIndex element) const;
  void find_border();
  [[nodiscard]] std::vector<Band> bands() const;
  void paint_band(const Band& band, LightPage& page);
  void paint_element(const FlatElement& element, const Band& band, LightPage& page);
  /// Of each texel of the band, 1 where a border edge meets its square: all others are whole or empty.
  [[nodiscard]] std::vector<std::uint8_t> border_texels(const Band& band) const;
  void cover(const FlatElement& element, const Band& band, std::span<const std::uint8_t> at_border,
             std::vector<double>& shares) const;
  void extend(const Band& band, LightPage& page);
  void seek_nearest(std::uint32_t edge, const Band& band, std::vector<Nearest>& nearest) const;
  void balance_border(LightPage& page) const;

  [[nodiscard]] std::size_t inside_index(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * place_.columns + column;
  }
  [[nodiscard]] float* texel(LightPage& page, std::uint32_t column, std::uint32_t row) const {
    return &page.radiosity[3 * (std::size_t{place_.y + row} * page.width + place_.x + column)];
  }

  const LightChart& chart_;
  const ChartPlace& place_;
  const mesh::RadiosityMesh& mesh_;
  const mesh::RadiosityField& field_;
  const std::vector<std::uint8_t>& shared_node_;
  std::vector<ElementIndex> elements_;
  std::vector<BorderEdge> border_;
  std::vector<std::uint8_t> inside_;  ///< of each texel of the rectangle: its centre lies in the chart
};

}  // namespace rad::bake
