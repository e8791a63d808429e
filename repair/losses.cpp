#include "repair/losses.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "validate/thin_features.h"

namespace rad::repair {
namespace {

using scene::FaceId;
using validate::FaceCondition;
using validate::ThinKind;

// The ladder works at up to this many T, and welds that much farther.
constexpr double kLargestScale = 1.4;

struct Loss {
  FaceId face = 0;
  dvec3 point{0, 0, 0};  ///< file units
  double area = 0;       ///< file units²
};

class LossLedger {
 public:
  explicit LossLedger(const scene::Scene& scene) : scene_(scene) {}

  void add(const char* operation, std::vector<Loss> losses) {
    if (losses.empty()) return;
    scene::LedgerEntry entry;
    entry.stage = "grouper";
    entry.operation = operation;
    entry.count = losses.size();
    const auto key = [](const Loss& x) { return std::tuple(-x.area, x.point.x, x.point.y, x.point.z); };
    const std::size_t listed = std::min(losses.size(), scene::kListedPlaces);
    std::ranges::partial_sort(losses, losses.begin() + static_cast<std::ptrdiff_t>(listed),
                              [&](const Loss& x, const Loss& y) { return key(x) < key(y); });
    for (const Loss& loss : std::span(losses).first(listed)) {
      entry.places.push_back({loss.point, scene::reference_to(scene_, loss.face), loss.area});
    }
    ledger.push_back(std::move(entry));
  }

  scene::Ledger ledger;

 private:
  const scene::Scene& scene_;
};

std::vector<Loss> pairs_joined(const validate::Context& input, const std::vector<validate::ThinFeature>& features,
                               ThinKind kind, const Remains& remains) {
  std::vector<Loss> lost;
  for (const validate::ThinFeature& feature : features) {
    if (feature.kind != kind || !remains.joined(feature.faces[0], feature.faces[1])) continue;
    lost.push_back({feature.faces[0], input.position(feature.point), input.area(feature.area)});
  }
  return lost;
}

}  // namespace

Remains::Remains(const PlanarTriangles& triangles, std::size_t face_count) : left_(face_count, false) {
  std::vector<std::pair<std::array<PointId, 3>, FaceId>> placed;
  for (const PlanarTriangles::Member& member : triangles.members) {
    left_[member.source] = true;
    std::array<PointId, 3> points = member.points;
    std::sort(points.begin(), points.end());
    placed.emplace_back(points, member.source);
  }
  std::sort(placed.begin(), placed.end());
  for (std::size_t i = 1; i < placed.size(); ++i) {
    if (placed[i].first == placed[i - 1].first) joined_.push_back({placed[i - 1].second, placed[i].second});
  }
  std::sort(joined_.begin(), joined_.end());
}

bool Remains::joined(scene::FaceId a, scene::FaceId b) const {
  return std::ranges::binary_search(joined_, std::array{std::min(a, b), std::max(a, b)});
}

scene::Ledger losses(const validate::Context& input, const Remains& remains, const CoplanarLog& covered) {
  std::vector<Loss> degenerate, closed;
  for (FaceId face = 0; face < input.scene.faces.size(); ++face) {
    if (remains.left(face) || covered.gave_way(face) || input.model.left_out[face]) continue;
    const double area = input.area(glm::length(input.triangles.normal[face]) / 2);
    const bool had_none = input.triangles.condition[face] == FaceCondition::Degenerate;
    (had_none ? degenerate : closed).push_back({face, input.centre(face), area});
  }
  const auto reach = std::ceil(kLargestScale * static_cast<double>(geom::weld_pitches(input.tolerance)));
  const auto features = validate::find_facing_sides(input, static_cast<std::int64_t>(reach));
  LossLedger ledger(input.scene);
  ledger.add("drop-degenerate", std::move(degenerate));
  ledger.add("close-face", std::move(closed));
  ledger.add("flatten-plate", pairs_joined(input, features, ThinKind::Plate, remains));
  ledger.add("close-slit", pairs_joined(input, features, ThinKind::Slit, remains));
  return std::move(ledger.ledger);
}

}  // namespace rad::repair
