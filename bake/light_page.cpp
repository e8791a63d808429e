#include "bake/light_page.h"

#include <tbb/parallel_for.h>

#include <numeric>

#include "bake/chart_texels.h"

namespace rad::bake {
namespace {

// Elements of patch p from first[p] to first[p + 1].
std::vector<ElementIndex> first_elements(const mesh::RadiosityMesh& mesh) {
  std::vector<ElementIndex> first(mesh.patches.size() + 1, 0);
  for (const mesh::Element& element : mesh.elements) ++first[element.patch + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

}  // namespace

LightPage paint_page(const Atlas& atlas, std::uint32_t page, const mesh::RadiosityMesh& mesh,
                     const mesh::RadiosityField& field) {
  const auto& [width, height] = atlas.pages[page];
  const std::size_t texels = std::size_t{width} * height;
  LightPage result{width, height, std::vector<float>(3 * texels, 0), std::vector<float>(texels, 0)};
  const std::vector<ElementIndex> first = first_elements(mesh);
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(atlas.charts.size()), [&](std::uint32_t chart) {
    if (atlas.places[chart].page != page) return;
    std::vector<ElementIndex> elements;
    for (const PatchId patch : atlas.charts[chart].patches) {
      for (ElementIndex id = first[patch]; id < first[patch + 1]; ++id) elements.push_back(id);
    }
    ChartTexels(atlas, chart, mesh, field, std::move(elements)).paint(result);
  });
  return result;
}

}  // namespace rad::bake
