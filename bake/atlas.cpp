#include "bake/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "bake/rectangle_packing.h"

namespace rad::bake {
namespace {

constexpr std::uint32_t kSmallestPage = 64;

// Steps between the centres of texels along a side; more than any page has for what does not fit on one.
std::uint32_t steps(double side, double texel) {
  const double count = std::ceil(side / (texel * (1 + kTexelRounding)));
  return static_cast<std::uint32_t>(std::clamp(count, 1.0, 2.0 * kMostPageSize));
}

std::uint32_t texels_along(double side, double texel) { return steps(side, texel) + 1 + 2 * kGutter; }

class Layout {
 public:
  Layout(const std::vector<LightChart>& charts, std::uint32_t page_size) : charts_(charts), page_size_(page_size) {}

  // Texels of all charts; nothing where one does not fit on a page.
  [[nodiscard]] std::optional<std::uint64_t> texels(double texel) const {
    std::uint64_t sum = 0;
    for (const LightChart& chart : charts_) {
      const std::uint32_t columns = texels_along(chart.width, texel), rows = texels_along(chart.height, texel);
      if (std::max(columns, rows) > page_size_) return std::nullopt;
      sum += std::uint64_t{columns} * rows;
    }
    return sum;
  }

  // A texel near `finest` and not below it with which the charts have at most `most` texels; nothing where the gutters
  // alone have more.
  [[nodiscard]] std::optional<double> fitting_texel(double finest, std::uint64_t most) const {
    const auto fits = [&](double texel) {
      const auto count = texels(texel);
      return count && *count <= most;
    };
    if (fits(finest)) return finest;
    double low = finest, high = finest;
    const double largest = longest_side();
    while (!fits(high)) {
      if (high > largest) return std::nullopt;
      low = high;
      high *= 2;
    }
    while (high > low * kClose) {
      const double middle = std::sqrt(low * high);
      (fits(middle) ? high : low) = middle;
    }
    return rounded_up(high);
  }

  // Places all charts on pages of at most `most` texels together; false where they do not find room.
  bool place(double texel, std::uint64_t most, Atlas& into) const {
    into.places.assign(charts_.size(), {});
    into.pages.clear();
    for (std::size_t i = 0; i < charts_.size(); ++i) {
      const LightChart& chart = charts_[i];
      const std::uint32_t across = steps(chart.width, texel), along = steps(chart.height, texel);
      into.places[i].columns = across + 1 + 2 * kGutter;
      into.places[i].rows = along + 1 + 2 * kGutter;
      into.places[i].texel = {chart.width / across, chart.height / along};
    }
    std::vector<std::size_t> left = by_size(into.places);
    std::uint64_t used = 0;
    while (!left.empty()) {
      left = fill_page(left, into);
      used += std::uint64_t{into.pages.back().width} * into.pages.back().height;
      if (used > most) return false;
    }
    return true;
  }

  /// To two digits that are enough.
  static double rounded_up(double length) {
    const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
    return std::ceil(length / unit) * unit;
  }

 private:
  static constexpr double kClose = 1.001;

  [[nodiscard]] double longest_side() const {
    double longest = 0;
    for (const LightChart& chart : charts_) longest = std::max(longest, chart.width);
    return longest;
  }

  static std::vector<std::size_t> by_size(const std::vector<ChartPlace>& places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return places[a].rows != places[b].rows ? places[a].rows > places[b].rows : places[a].columns > places[b].columns;
    });
    return order;
  }

  // The first of those that are left, as many as their area lets hope for, on a page of the least size that holds all
  // that is left, or of full size. Returns what is left then.
  std::vector<std::size_t> fill_page(const std::vector<std::size_t>& left, Atlas& into) const {
    const std::uint64_t full = std::uint64_t{page_size_} * page_size_;
    std::vector<PackedRectangle> tried;
    std::uint64_t area = 0;
    for (const std::size_t chart : left) {
      const ChartPlace& place = into.places[chart];
      area += std::uint64_t{place.columns} * place.rows;
      if (area > full) break;
      tried.push_back({place.columns, place.rows});
    }
    AtlasPage page{page_size_, page_size_};
    if (area > full || !pack_small(tried, area, page)) pack_rectangles(tried, page.width, page.height);
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (i >= tried.size() || !tried[i].placed) {
        rest.push_back(left[i]);
        continue;
      }
      ChartPlace& place = into.places[left[i]];
      place.page = static_cast<std::uint32_t>(into.pages.size());
      place.x = tried[i].x;
      place.y = tried[i].y;
    }
    into.pages.push_back(page);
    return rest;
  }

  bool pack_small(std::vector<PackedRectangle>& rectangles, std::uint64_t area, AtlasPage& page) const {
    const std::uint32_t limit = std::bit_floor(page_size_);
    for (std::uint32_t side = kSmallestPage; side <= limit; side *= 2) {
      for (const std::uint32_t height : {side / 2, side}) {
        if (std::uint64_t{side} * height < area) continue;
        pack_rectangles(rectangles, side, height);
        if (!std::ranges::all_of(rectangles, &PackedRectangle::placed)) continue;
        page = {side, height};
        return true;
      }
    }
    return false;
  }

  const std::vector<LightChart>& charts_;
  std::uint32_t page_size_;
};

std::string too_large(double texel, const std::optional<double>& fitting, const AtlasOptions& options) {
  const std::string limits = fmt::format("pages of {} x {} texels, {:.0f} million texels in all", options.page_size,
                                         options.page_size, static_cast<double>(options.most_texels) / 1e6);
  if (!fitting) {
    return fmt::format("light maps of so many faces do not fit into {}, whatever the size of a texel", limits);
  }
  return fmt::format("light maps with texels of {:.6g} do not fit into {}; texels of {:.6g} fit", texel, limits,
                     *fitting);
}

// A texel with which the charts have not only the area but find their places.
std::optional<double> placed_texel(const Layout& layout, double finest, std::uint64_t modest,
                                   const AtlasOptions& options, Atlas& atlas) {
  std::optional<double> texel = layout.fitting_texel(finest, modest);
  while (texel && !layout.place(*texel, options.most_texels, atlas)) {
    // What the packing leaves empty is a tenth of a page or two.
    constexpr double kCoarser = 1.1;
    texel = layout.fitting_texel(Layout::rounded_up(*texel * kCoarser), options.most_texels);
  }
  return texel;
}

std::vector<std::uint8_t> shared_nodes(const mesh::RadiosityMesh& mesh, const std::vector<std::uint32_t>& charts) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> first(mesh.nodes.size(), kNone);
  std::vector<std::uint8_t> shared(mesh.nodes.size(), 0);
  for (const mesh::Element& element : mesh.elements) {
    const std::uint32_t chart = charts[element.patch];
    for (const mesh::NodeId node : element.corners.all()) {
      if (first[node] == kNone) first[node] = chart;
      shared[node] |= static_cast<std::uint8_t>(first[node] != chart);
    }
  }
  return shared;
}

}  // namespace

dvec2 Atlas::page_coordinates(std::uint32_t chart, const dvec3& position) const {
  const ChartPlace& place = places[chart];
  const dvec2 texels = place.to_texels(charts[chart].in_plane(position)) + dvec2(place.x, place.y) + 0.5;
  return texels / dvec2(pages[place.page].width, pages[place.page].height);
}

Atlas lay_out_atlas(const mesh::RadiosityMesh& mesh, const AtlasOptions& options) {
  Atlas atlas;
  atlas.charts = light_charts(mesh);
  const Layout layout(atlas.charts, options.page_size);
  const double wanted = options.texel.value_or(options.finest_texel);
  bool placed = false;
  if (options.texel) {
    atlas.texel = wanted;
    const auto texels = layout.texels(wanted);
    placed = texels && *texels <= options.most_texels && layout.place(wanted, options.most_texels, atlas);
  } else {
    auto texel = placed_texel(layout, wanted, std::min(kModestTexels, options.most_texels), options, atlas);
    if (!texel) texel = placed_texel(layout, wanted, options.most_texels, options, atlas);
    placed = texel.has_value();
    atlas.texel = texel.value_or(0);
  }
  if (!placed) {
    const auto fitting = placed_texel(layout, wanted, options.most_texels, options, atlas);
    atlas = {};
    atlas.problem = too_large(wanted, fitting, options);
    return atlas;
  }
  atlas.chart_of_patch.resize(mesh.patches.size());
  for (std::uint32_t chart = 0; chart < atlas.charts.size(); ++chart) {
    for (const PatchId patch : atlas.charts[chart].patches) atlas.chart_of_patch[patch] = chart;
  }
  atlas.shared_node = shared_nodes(mesh, atlas.chart_of_patch);
  return atlas;
}

}  // namespace rad::bake
