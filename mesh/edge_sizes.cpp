#include "mesh/edge_sizes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "geom/planar_shape.h"
#include "mesh/face_gaps.h"
#include "mesh/lengths.h"

namespace rad::mesh {
namespace {

struct Link {
  std::uint32_t a, b;
  double length;
};

class SizeSolver {
 public:
  SizeSolver(const scene::ConformingModel& model, const EdgeDivision& division, std::span<const FaceOutline> outlines)
      : model_(model), division_(division), outlines_(outlines) {
    sizes_.assign(division.points().size(), std::numeric_limits<double>::infinity());
  }

  EdgeSizes run() {
    add_edges();
    add_faces();
    spread();
    return along_edges();
  }

 private:
  [[nodiscard]] double distance(PointId a, PointId b) const {
    return std::sqrt(static_cast<double>(geom::squared_distance(division_.points()[a], division_.points()[b])));
  }

  void lower(PointId point, double size) { sizes_[point] = std::min(sizes_[point], size); }

  void add_edges() {
    std::vector<PointId> chain;
    for (std::size_t edge = 0; edge < division_.edge_count(); ++edge) {
      division_.chain_of(edge, chain);
      for (std::size_t i = 0; i < chain.size(); ++i) {
        lower(chain[i], division_.longest(edge));
        if (i > 0) links_.push_back({chain[i - 1], chain[i], distance(chain[i - 1], chain[i])});
      }
    }
  }

  void add_faces() {
    std::vector<FaceGaps> gaps(outlines_.size());
    tbb::parallel_for(std::size_t{0}, outlines_.size(),
                      [&](std::size_t f) { gaps[f] = face_gaps(model_, model_.faces[f], outlines_[f], division_); });
    for (const FaceGaps& face : gaps) {
      for (const FaceGaps::Near& near : face.near) lower(near.point, near.size);
      for (const PointPair& pair : face.across) links_.push_back({pair[0], pair[1], distance(pair[0], pair[1])});
    }
    const double least = kShortestPatchInTolerances * static_cast<double>(model_.tolerance.pitches);
    for (double& size : sizes_) size = std::max(size, least);
  }

  // Every point gets the least of size + slope · way over all points: Dijkstra from all of them at once.
  void spread() {
    std::vector<std::uint32_t> first(sizes_.size() + 1, 0), ends(2 * links_.size());
    for (const Link& link : links_) {
      ++first[link.a];
      ++first[link.b];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : first) entry = sum += entry;
    for (std::uint32_t i = 0; i < links_.size(); ++i) {
      ends[--first[links_[i].a]] = i;
      ends[--first[links_[i].b]] = i;
    }
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::uint32_t p = 0; p < sizes_.size(); ++p) {
      if (std::isfinite(sizes_[p])) queue.emplace(sizes_[p], p);
    }
    while (!queue.empty()) {
      const auto [size, point] = queue.top();
      queue.pop();
      if (size > sizes_[point]) continue;
      for (std::uint32_t i = first[point]; i < first[point + 1]; ++i) {
        const Link& link = links_[ends[i]];
        const std::uint32_t other = link.a == point ? link.b : link.a;
        const double grown = size + kSizeSlope * link.length;
        if (grown >= sizes_[other]) continue;
        sizes_[other] = grown;
        queue.emplace(grown, other);
      }
    }
  }

  [[nodiscard]] EdgeSizes along_edges() const {
    EdgeSizes result;
    std::vector<PointId> chain;
    for (std::size_t edge = 0; edge < division_.edge_count(); ++edge) {
      division_.chain_of(edge, chain);
      result.begin_edge();
      for (const PointId point : chain) result.add({distance(division_.ends(edge)[0], point), sizes_[point]});
    }
    return result;
  }

  const scene::ConformingModel& model_;
  const EdgeDivision& division_;
  std::span<const FaceOutline> outlines_;
  std::vector<double> sizes_;  ///< per point of the division
  std::vector<Link> links_;
};

/// The number of parts that lie before a place, as a table.
class PartsBefore {
 public:
  PartsBefore(std::span<const SizedPlace> sizes, double from, double to, double longest) {
    table_.push_back({from, 0});
    for (std::size_t i = 1; i < sizes.size(); ++i) {
      const SizedPlace &a = sizes[i - 1], &b = sizes[i];
      for (int step = 0; step < kSteps; ++step) {
        const double place = a.place + (b.place - a.place) * (step + 0.5) / kSteps;
        const double size =
            std::min({a.size + kSizeSlope * (place - a.place), b.size + kSizeSlope * (b.place - place), longest});
        const double low = std::max(from, a.place + (b.place - a.place) * step / kSteps);
        const double high = std::min(to, a.place + (b.place - a.place) * (step + 1) / kSteps);
        if (low < high) table_.push_back({high, table_.back().parts + (high - low) / size});
      }
    }
  }

  [[nodiscard]] double total() const { return table_.back().parts; }

  [[nodiscard]] double place_after(double parts) const {
    const auto above = std::lower_bound(table_.begin() + 1, table_.end() - 1, parts,
                                        [](const Entry& entry, double wanted) { return entry.parts < wanted; });
    const Entry& below = *(above - 1);
    const double share = (parts - below.parts) / (above->parts - below.parts);
    return below.place + (above->place - below.place) * share;
  }

 private:
  // Sizes change by the slope at most: within a step of 1/16 of a part's length by 2 %.
  static constexpr int kSteps = 16;
  struct Entry {
    double place;
    double parts;
  };
  std::vector<Entry> table_;
};

std::vector<double> parted(const PartsBefore& before, double from, double to, std::uint32_t parts) {
  std::vector<double> places{from};
  for (std::uint32_t k = 1; k < parts; ++k) places.push_back(before.place_after(before.total() * k / parts));
  places.push_back(to);
  return places;
}

double longest_part(std::span<const double> places) {
  double longest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) longest = std::max(longest, places[i] - places[i - 1]);
  return longest;
}

}  // namespace

EdgeSizes edge_sizes(const scene::ConformingModel& model, const EdgeDivision& division,
                     std::span<const FaceOutline> outlines) {
  return SizeSolver(model, division, outlines).run();
}

std::vector<double> graded_places(std::span<const SizedPlace> sizes, double from, double to, double longest,
                                  std::uint32_t least_parts, double spacing) {
  const PartsBefore before(sizes, from, to, longest);
  const double most = std::max(1.0, std::floor((to - from) / spacing));
  const double wanted = std::max({std::round(before.total()), static_cast<double>(least_parts), 1.0});
  auto parts = static_cast<std::uint32_t>(std::min(wanted, most));
  std::vector<double> places = parted(before, from, to, parts);
  while (parts < most && longest_part(places) > longest + kLengthRounding) places = parted(before, from, to, ++parts);
  return places;
}

}  // namespace rad::mesh
