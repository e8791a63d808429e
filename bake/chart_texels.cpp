#include "bake/chart_texels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "bake/border_balance.h"
#include "bake/texel_coverage.h"

namespace rad::bake {
namespace {

constexpr std::uint32_t kRowsOfBand = 64;
// Texels; a centre on the common edge of two elements must not fall between them.
constexpr double kOnEdge = 1e-9;
// From a texel of the gutter, at its corner, to the border.
constexpr double kReach = kGutter * 1.4143;

// Where another chart has the same nodes both have to show the same; elsewhere nothing is beside the border to compare.
constexpr double kSharedWeight = 100;

struct Rows {
  std::uint32_t first = 0;
  std::uint32_t last = 0;  ///< one past the end
};

// Rows of a band whose squares come within `margin` of [low, high].
Rows rows_within(double low, double high, double margin, std::uint32_t first, std::uint32_t last) {
  const double from = std::max<double>(first, std::ceil(low - margin));
  const double to = std::min<double>(last, std::floor(high + margin) + 1);
  if (!(from < to)) return {first, first};
  return {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)};
}

struct Box {
  dvec2 low{std::numeric_limits<double>::infinity()};
  dvec2 high{-std::numeric_limits<double>::infinity()};
};

Box box_of(const FlatElement& element) {
  Box box;
  for (std::uint32_t i = 0; i < element.count; ++i) {
    box.low = glm::min(box.low, element.corner[i]);
    box.high = glm::max(box.high, element.corner[i]);
  }
  return box;
}

dvec2 nearest_on_segment(const dvec2& point, const dvec2& from, const dvec2& to) {
  const dvec2 way = to - from;
  const double squared = glm::dot(way, way);
  return squared > 0 ? from + way * std::clamp(glm::dot(point - from, way) / squared, 0.0, 1.0) : from;
}

void store(float* texel, const dvec3& value) {
  for (int channel = 0; channel < 3; ++channel) texel[channel] = static_cast<float>(value[channel]);
}

}  // namespace

ChartTexels::ChartTexels(const Atlas& atlas, std::uint32_t chart, const mesh::RadiosityMesh& mesh,
                         const mesh::RadiosityField& field, std::vector<ElementIndex> elements)
    : chart_(atlas.charts[chart]),
      place_(atlas.places[chart]),
      mesh_(mesh),
      field_(field),
      shared_node_(atlas.shared_node),
      elements_(std::move(elements)),
      inside_(std::size_t{place_.columns} * place_.rows, 0) {
  find_border();
}

// Seen with y down, corners that go counter-clockwise in front of the face go the other way round.
FlatElement ChartTexels::flat(ElementIndex element) const {
  const mesh::Corners& corners = mesh_.elements[element].corners;
  FlatElement result;
  result.count = corners.count;
  for (std::uint32_t i = 0; i < corners.count; ++i) {
    const mesh::NodeId node = corners.node[corners.count - 1 - i];
    result.corner[i] = place_.to_texels(chart_.in_plane(mesh_.nodes[node].position));
    result.value[i] = field_.radiosity[node];
  }
  return result;
}

// Edges that no other element of the chart has.
void ChartTexels::find_border() {
  struct Use {
    mesh::NodeId low, high;
    ElementIndex element;
    std::uint32_t edge;
  };
  std::vector<Use> uses;
  for (const ElementIndex id : elements_) {
    const auto& [node, count] = mesh_.elements[id].corners;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& [low, high] = std::minmax(node[count - 1 - i], node[(2 * count - 2 - i) % count]);
      uses.push_back({low, high, id, i});
    }
  }
  std::ranges::sort(uses, [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.element, a.edge) < std::tie(b.low, b.high, b.element, b.edge);
  });
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const auto same = [&](std::size_t other) {
      return uses[i].low == uses[other].low && uses[i].high == uses[other].high;
    };
    if ((i > 0 && same(i - 1)) || (i + 1 < uses.size() && same(i + 1))) continue;
    border_.push_back({uses[i].element, uses[i].edge});
  }
  std::ranges::sort(border_, {}, [](const BorderEdge& edge) { return std::pair(edge.element, edge.edge); });
}

std::vector<ChartTexels::Band> ChartTexels::bands() const {
  std::vector<Band> bands((place_.rows + kRowsOfBand - 1) / kRowsOfBand);
  for (std::uint32_t i = 0; i < bands.size(); ++i) {
    bands[i].first = i * kRowsOfBand;
    bands[i].last = std::min(place_.rows, bands[i].first + kRowsOfBand);
  }
  const auto into = [&](double low, double high, double margin, auto list, auto what) {
    const Rows rows = rows_within(low, high, margin, 0, place_.rows);
    if (rows.first == rows.last) return;
    for (std::uint32_t i = rows.first / kRowsOfBand; i <= (rows.last - 1) / kRowsOfBand; ++i) {
      (bands[i].*list).push_back(what);
    }
  };
  for (const ElementIndex id : elements_) {
    const Box box = box_of(flat(id));
    into(box.low.y, box.high.y, 0.5, &Band::elements, id);
  }
  for (std::uint32_t i = 0; i < border_.size(); ++i) {
    const FlatElement element = flat(border_[i].element);
    const auto [low, high] =
        std::minmax({element.corner[border_[i].edge].y, element.corner[(border_[i].edge + 1) % element.count].y});
    into(low, high, kReach, &Band::border, i);
  }
  return bands;
}

void ChartTexels::paint(LightPage& page) {
  const std::vector<Band> all = bands();
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { paint_band(all[i], page); });
  balance_border(page);
}

void ChartTexels::paint_band(const Band& band, LightPage& page) {
  const std::vector<std::uint8_t> at_border = border_texels(band);
  std::vector<double> shares(at_border.size(), 0);
  for (const ElementIndex id : band.elements) {
    const FlatElement element = flat(id);
    paint_element(element, band, page);
    cover(element, band, at_border, shares);
  }
  for (std::uint32_t row = band.first; row < band.last; ++row) {
    for (std::uint32_t column = 0; column < place_.columns; ++column) {
      const std::size_t at = std::size_t{row - band.first} * place_.columns + column;
      const double share = at_border[at] != 0 ? std::min(shares[at], 1.0) : inside_[inside_index(column, row)];
      page.coverage[std::size_t{place_.y + row} * page.width + place_.x + column] = static_cast<float>(share);
    }
  }
  extend(band, page);
}

// Of elements that meet in a centre the first has it; both say the same there.
void ChartTexels::paint_element(const FlatElement& element, const Band& band, LightPage& page) {
  const Box box = box_of(element);
  const Rows rows = rows_within(box.low.y, box.high.y, kOnEdge, band.first, band.last);
  const Rows columns = rows_within(box.low.x, box.high.x, kOnEdge, 0, place_.columns);
  for (std::uint32_t row = rows.first; row < rows.last; ++row) {
    for (std::uint32_t column = columns.first; column < columns.last; ++column) {
      std::uint8_t& inside = inside_[inside_index(column, row)];
      const dvec2 centre(column, row);
      if (inside != 0 || !element.contains(centre, kOnEdge)) continue;
      inside = 1;
      store(texel(page, column, row), element.at(centre).value);
    }
  }
}

std::vector<std::uint8_t> ChartTexels::border_texels(const Band& band) const {
  std::vector<std::uint8_t> met(std::size_t{band.last - band.first} * place_.columns, 0);
  for (const std::uint32_t edge : band.border) {
    const FlatElement element = flat(border_[edge].element);
    const dvec2& from = element.corner[border_[edge].edge];
    const dvec2 way = element.corner[(border_[edge].edge + 1) % element.count] - from;
    const Rows rows = rows_within(std::min(from.y, from.y + way.y), std::max(from.y, from.y + way.y), 0.5 + kOnEdge,
                                  band.first, band.last);
    for (std::uint32_t row = rows.first; row < rows.last; ++row) {
      double low = 0, high = 1;  // of the way, within the row
      if (way.y != 0) {
        const double upper = (row - 0.5 - from.y) / way.y, lower = (row + 0.5 - from.y) / way.y;
        low = std::clamp(std::min(upper, lower), 0.0, 1.0);
        high = std::clamp(std::max(upper, lower), 0.0, 1.0);
      }
      const auto [left, right] = std::minmax({from.x + low * way.x, from.x + high * way.x});
      const Rows columns = rows_within(left, right, 0.5 + kOnEdge, 0, place_.columns);
      const std::size_t start = std::size_t{row - band.first} * place_.columns;
      std::fill(met.begin() + static_cast<std::ptrdiff_t>(start + columns.first),
                met.begin() + static_cast<std::ptrdiff_t>(start + columns.last), std::uint8_t{1});
    }
  }
  return met;
}

void ChartTexels::cover(const FlatElement& element, const Band& band, std::span<const std::uint8_t> at_border,
                        std::vector<double>& shares) const {
  const Box box = box_of(element);
  const Rows rows = rows_within(box.low.y, box.high.y, 0.5, band.first, band.last);
  for (std::uint32_t row = rows.first; row < rows.last; ++row) {
    const std::size_t start = std::size_t{row - band.first} * place_.columns;
    const auto counted = at_border.subspan(start, place_.columns);
    const Rows columns = rows_within(box.low.x, box.high.x, 0.5, 0, place_.columns);
    const auto met = counted.subspan(columns.first, columns.last - columns.first);
    if (std::ranges::find(met, std::uint8_t{1}) == met.end()) continue;
    add_coverage(element, {row, std::span(shares).subspan(start, place_.columns), counted});
  }
}

void ChartTexels::extend(const Band& band, LightPage& page) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<Nearest> nearest(std::size_t{band.last - band.first} * place_.columns, {kNone, 0});
  for (const std::uint32_t edge : band.border) seek_nearest(edge, band, nearest);
  for (std::uint32_t row = band.first; row < band.last; ++row) {
    for (std::uint32_t column = 0; column < place_.columns; ++column) {
      const Nearest& found = nearest[std::size_t{row - band.first} * place_.columns + column];
      if (found.squared == kNone) continue;
      const auto& [id, edge] = border_[found.edge];
      const FlatElement element = flat(id);
      const dvec2 centre(column, row);
      const dvec2 at = nearest_on_segment(centre, element.corner[edge], element.corner[(edge + 1) % element.count]);
      const FlatValue there = element.at(at);
      const dvec3 beyond = there.value + there.along_x * (centre.x - at.x) + there.along_y * (centre.y - at.y);
      store(texel(page, column, row), glm::clamp(beyond, dvec3(0), 2.0 * there.value));
    }
  }
}

void ChartTexels::seek_nearest(std::uint32_t edge, const Band& band, std::vector<Nearest>& nearest) const {
  const FlatElement element = flat(border_[edge].element);
  const dvec2& from = element.corner[border_[edge].edge];
  const dvec2& to = element.corner[(border_[edge].edge + 1) % element.count];
  const Rows rows = rows_within(std::min(from.y, to.y), std::max(from.y, to.y), kReach, band.first, band.last);
  const Rows columns = rows_within(std::min(from.x, to.x), std::max(from.x, to.x), kReach, 0, place_.columns);
  for (std::uint32_t row = rows.first; row < rows.last; ++row) {
    for (std::uint32_t column = columns.first; column < columns.last; ++column) {
      if (inside_[inside_index(column, row)] != 0) continue;
      const dvec2 centre(column, row);
      const dvec2 way = centre - nearest_on_segment(centre, from, to);
      const double squared = glm::dot(way, way);
      Nearest& known = nearest[std::size_t{row - band.first} * place_.columns + column];
      if (squared <= kReach * kReach && squared < known.squared) known = {squared, edge};
    }
  }
}

bool ChartTexels::is_shared(ElementIndex element, std::uint32_t edge) const {
  const mesh::Corners& corners = mesh_.elements[element].corners;
  const auto shared = [&](std::uint32_t corner) {
    return shared_node_[corners.node[corners.count - 1 - corner % corners.count]] != 0;
  };
  return shared(edge) && shared(edge + 1);
}

void ChartTexels::balance_border(LightPage& page) const {
  BorderBalance balance(inside_, place_.columns, place_.rows);
  for (const auto& [id, edge] : border_) {
    const FlatElement element = flat(id);
    const std::uint32_t next = (edge + 1) % element.count;
    balance.add_edge({element.corner[edge], element.corner[next], element.value[edge], element.value[next]},
                     is_shared(id, edge) ? kSharedWeight : 1);
  }
  balance.settle({texel(page, 0, 0), 3 * std::size_t{page.width}});
}

}  // namespace rad::bake
