#include "validate/open_winding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "validate/facades.h"

namespace rad::validate {
namespace {

constexpr std::size_t kMostPoints = 512, kFewestPoints = 64, kMostTerms = std::size_t{1} << 24;
constexpr double kClearly = 0.1;

/// A directed stretch of a rim, with the number of times that faces run along it more often one way than the other.
struct RimEdge {
  dvec3 from{}, to{};
  double times = 1;
};

struct Rims {
  std::vector<RimEdge> edges;
  dvec3 low{}, high{};
};

bool counts(const Context& context, std::uint32_t component) {
  if (component == kNoComponent || context.topology.components[component].open_subedges == 0) return false;
  const FacadeVerdict verdict = facades_of(context).of_component[component].verdict;
  return verdict != FacadeVerdict::ValidProved && verdict != FacadeVerdict::Terrain;
}

Rims open_rims(const Context& context) {
  Rims rims;
  const auto& components = context.topology.components;
  std::vector<bool> counted(components.size());
  bool first = true;
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    counted[i] = counts(context, i);
    if (!counted[i]) continue;
    const dvec3 low = geom::as_vector(components[i].low), high = geom::as_vector(components[i].high);
    rims.low = first ? low : glm::min(rims.low, low);
    rims.high = first ? high : glm::max(rims.high, high);
    first = false;
  }
  if (first) return rims;
  for (const Subedge& subedge : context.topology.subedges) {
    int forward = 0;
    for (const Coedge& coedge : context.topology.coedges_of(subedge)) {
      if (counted[context.topology.component_of_face[coedge.face]]) forward += coedge.forward ? 1 : -1;
    }
    if (forward == 0) continue;
    rims.edges.push_back({geom::as_vector(context.model.points[subedge.a]),
                          geom::as_vector(context.model.points[subedge.b]), static_cast<double>(forward)});
  }
  return rims;
}

// Van Oosterom and Strackee, of the triangle between an edge and the apex.
double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double determinant = glm::dot(a, glm::cross(b, c));
  const double denominator = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2 * std::atan2(determinant, denominator);
}

// Distance of the winding number from the nearest whole number.
double ambiguity_at(const Rims& rims, const dvec3& point) {
  const dvec3 apex = rims.low - point;
  double total = 0;
  for (const RimEdge& edge : rims.edges) {
    total += edge.times * solid_angle(apex, edge.from - point, edge.to - point);
  }
  const double winding = total / (4 * std::numbers::pi);
  return std::abs(winding - std::nearbyint(winding));
}

// Halton's sequence in bases 2, 3, 5: spread evenly, the same in every run.
double halton(std::size_t index, std::size_t base) {
  double value = 0, share = 1;
  for (std::size_t i = index + 1; i > 0; i /= base) {
    share /= static_cast<double>(base);
    value += share * static_cast<double>(i % base);
  }
  return value;
}

dvec3 sample_point(const Rims& rims, std::size_t i) {
  return rims.low + (rims.high - rims.low) * dvec3(halton(i, 2), halton(i, 3), halton(i, 5));
}

}  // namespace

Ambiguity sample_ambiguity(const Context& context) {
  const Rims rims = open_rims(context);
  Ambiguity result;
  if (rims.edges.empty()) return result;
  const std::size_t points = std::clamp(kMostTerms / rims.edges.size(), kFewestPoints, kMostPoints);
  std::vector<double> ambiguity(points);
  tbb::parallel_for(std::size_t{0}, points,
                    [&](std::size_t i) { ambiguity[i] = ambiguity_at(rims, sample_point(rims, i)); });
  const auto unclear = std::ranges::count_if(ambiguity, [](double value) { return value > kClearly; });
  result.share = static_cast<double>(unclear) / static_cast<double>(points);
  const auto worst = std::ranges::max_element(ambiguity) - ambiguity.begin();
  result.worst = sample_point(rims, static_cast<std::size_t>(worst));
  return result;
}

}  // namespace rad::validate
