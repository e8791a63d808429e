#include "mesh/patch_sectors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "scene/disjoint_sets.h"

namespace rad::mesh {
namespace {

/// One patch's use of an edge; `slot` is the corner that the edge leaves from.
struct EdgeUse {
  PointPair ends;
  std::uint32_t patch;
  std::uint32_t slot;
  bool forward;  ///< from ends[0] to ends[1]
};

class SectorFinder {
 public:
  SectorFinder(const PatchSoup& soup, std::span<const PatchedFace> faces, std::span<const PointPair> contacts)
      : soup_(soup), faces_(faces), contacts_(contacts), classes_(soup.corners.size() * 4) {}

  Sectors run() {
    collect_uses();
    for_each_edge([this](std::span<const EdgeUse> uses) {
      if (!smooth(uses)) return;
      for (const int end : {0, 1}) classes_.unite(corner_at(uses[0], end), corner_at(uses[1], end));
    });
    Sectors sectors = numbered();
    for_each_edge([&](std::span<const EdgeUse> uses) {
      if (!smooth(uses) && unparted(uses, sectors)) sectors.unparted.push_back(uses[0].ends);
    });
    return sectors;
  }

 private:
  void collect_uses() {
    for (std::uint32_t p = 0; p < soup_.corners.size(); ++p) {
      const PatchCorners& corners = soup_.corners[p];
      for (std::uint32_t slot = 0; slot < corners.count; ++slot) {
        const std::uint32_t a = corners.point[slot], b = corners.point[(slot + 1) % corners.count];
        uses_.push_back({{std::min(a, b), std::max(a, b)}, p, slot, a < b});
      }
    }
    std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.ends, a.patch, a.slot) < std::tie(b.ends, b.patch, b.slot);
    });
  }

  template <typename Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t first = 0, last = 0; first < uses_.size(); first = last) {
      while (last < uses_.size() && uses_[last].ends == uses_[first].ends) ++last;
      visit(std::span(uses_).subspan(first, last - first));
    }
  }

  [[nodiscard]] bool smooth(std::span<const EdgeUse> uses) const {
    static const double kLeastCosine = std::cos(kSmoothDegrees * std::numbers::pi / 180);
    if (uses.size() != 2 || uses[0].forward == uses[1].forward) return false;
    if (std::binary_search(contacts_.begin(), contacts_.end(), uses[0].ends)) return false;
    const std::uint32_t f = soup_.face[uses[0].patch], g = soup_.face[uses[1].patch];
    return f == g || (faces_[f].material == faces_[g].material && faces_[f].object == faces_[g].object &&
                      glm::dot(faces_[f].normal, faces_[g].normal) >= kLeastCosine);
  }

  // Index of the use's corner at the lower (0) or higher (1) point.
  [[nodiscard]] std::uint32_t corner_at(const EdgeUse& use, int end) const {
    const bool leaving = use.forward == (end == 0);
    return 4 * use.patch + (leaving ? use.slot : (use.slot + 1) % soup_.corners[use.patch].count);
  }

  Sectors numbered() {
    constexpr std::uint32_t kUnnumbered = 0xffffffffU;
    Sectors sectors;
    sectors.node.resize(soup_.corners.size());
    std::vector<std::uint32_t> number(soup_.corners.size() * 4, kUnnumbered);
    for (std::uint32_t p = 0; p < soup_.corners.size(); ++p) {
      for (std::uint32_t slot = 0; slot < soup_.corners[p].count; ++slot) {
        std::uint32_t& known = number[classes_.find(4 * p + slot)];
        if (known == kUnnumbered) known = sectors.node_count++;
        sectors.node[p][slot] = known;
      }
    }
    return sectors;
  }

  [[nodiscard]] bool unparted(std::span<const EdgeUse> uses, const Sectors& sectors) const {
    const auto node = [&](const EdgeUse& use, int end) {
      const std::uint32_t corner = corner_at(use, end);
      return sectors.node[corner / 4][corner % 4];
    };
    for (std::size_t i = 0; i < uses.size(); ++i) {
      for (std::size_t j = i + 1; j < uses.size(); ++j) {
        if (node(uses[i], 0) == node(uses[j], 0) && node(uses[i], 1) == node(uses[j], 1)) return true;
      }
    }
    return false;
  }

  const PatchSoup& soup_;
  std::span<const PatchedFace> faces_;
  std::span<const PointPair> contacts_;
  scene::DisjointSets classes_;
  std::vector<EdgeUse> uses_;
};

}  // namespace

Sectors find_sectors(const PatchSoup& soup, std::span<const PatchedFace> faces, std::span<const PointPair> contacts) {
  return SectorFinder(soup, faces, contacts).run();
}

}  // namespace rad::mesh
