#include "solve/coupling.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "solve/sight.h"

namespace rad::solve {
namespace {

/// Distance from the centre of a patch, in radii of the patch, below which a receiver is near.
constexpr double kNearRadii = 3;
/// Distance from a piece of an element, in radii of the piece, below which its radiosity is not taken at its centre.
constexpr double kPieceRadii = 2;
constexpr std::uint32_t kDeepestPiece = 4;
/// Strata at first, and where these disagree.
constexpr std::size_t kFarStrata[] = {4, 16};
constexpr std::size_t kNearStrata[] = {16, 64};
constexpr std::size_t kEmitterStrata[] = {64, 256};
/// Receivers that look at a time: enough rays to fill packets, few enough to stay in the cache.
constexpr std::size_t kBlock = 64;

enum class Reach { None, Far, Near };

Reach reach(const Receiver& receiver, const mesh::Patch& patch, const Radiator& radiator, const Stratum& whole_patch) {
  if (!(glm::dot(receiver.position - radiator.centre, patch.normal) > 0)) return Reach::None;
  const dvec3 towards = radiator.centre - receiver.position;
  if (glm::dot(towards, receiver.normal) <= -radiator.radius) return Reach::None;
  const bool rises =
      std::any_of(whole_patch.corner.begin(), whole_patch.corner.begin() + whole_patch.count,
                  [&](const dvec3& corner) { return glm::dot(corner - receiver.position, receiver.normal) > 0; });
  if (!rises) return Reach::None;
  const double near = kNearRadii * radiator.radius;
  return glm::dot(towards, towards) < near * near ? Reach::Near : Reach::Far;
}

/// Adds F of `piece` to the weights of its element, split until its radiosity can be taken at its centre.
void add_shape_weights(const Stratum& piece, const Receiver& receiver, const ElementLocals& locals, std::uint32_t depth,
                       std::span<double> weight) {
  const dvec3 centre = piece.centre();
  const dvec3 away = receiver.position - centre;
  double radius2 = 0;
  for (const dvec3& point : piece.all()) radius2 = std::max(radius2, glm::dot(point - centre, point - centre));
  if (depth < kDeepestPiece && glm::dot(away, away) < kPieceRadii * kPieceRadii * radius2) {
    for (const Stratum& part : split(piece)) add_shape_weights(part, receiver, locals, depth + 1, weight);
    return;
  }
  const double factor = form_factor(above_horizon(piece.all(), receiver), receiver.normal);
  const Shares shares = shape_at_centre(piece);
  for (std::size_t i = 0; i < shares.size(); ++i) weight[locals[i]] += factor * shares[i];
}

/// The two ways to look at one patch.
class PatchCoupler {
 public:
  PatchCoupler(const CouplingSource& source, mesh::PatchId patch)
      : source_(source), patch_(patch), radiator_(source.radiators.patch[patch]) {}

  void add_far(std::span<const ReceiverId> receivers, Coupling& coupling) {
    if (far_.step.empty()) far_ = stratify(strata(whole_patch(), 1), kFarStrata);
    const Sights sights = look(far_, receivers, source_.receivers, source_.visibility);
    for (const Sight& sight : sights.sight) {
      const std::array<double, 3> weight = far_weight(sight, sights.votes_of(sight));
      if (!(weight[0] > 0)) continue;
      coupling.far_receiver.push_back(sight.receiver);
      coupling.far_weight.push_back(
          {static_cast<float>(weight[0]), static_cast<float>(weight[1]), static_cast<float>(weight[2])});
    }
  }

  void add_near(std::span<const ReceiverId> receivers, Coupling& coupling) {
    if (near_.step.empty()) near_ = stratify(element_cells(), kNearStrata);
    std::vector<double> weight(radiator_.local_count);
    const Sights sights = look(near_, receivers, source_.receivers, source_.visibility);
    for (const Sight& sight : sights.sight) {
      if (sight.visible == 0) continue;
      std::fill(weight.begin(), weight.end(), 0.0);
      add_near_weights(sight, sights.votes_of(sight), weight);
      coupling.near_receiver.push_back(sight.receiver);
      coupling.near_weight.insert(coupling.near_weight.end(), weight.begin(), weight.end());
    }
  }

  [[nodiscard]] Stratum whole_patch() const { return stratum_of(source_.mesh.patches[patch_].corners, source_.mesh); }

 private:
  [[nodiscard]] StratifiedRadiator stratify(std::vector<Stratum> cells, const std::size_t (&usual)[2]) const {
    const std::size_t(&wanted)[2] = source_.principal[patch_] ? kEmitterStrata : usual;
    const dvec3 lift = source_.mesh.patches[patch_].normal * source_.lift;
    return stratified(patch_, lift, std::move(cells), wanted[0], wanted[1]);
  }

  [[nodiscard]] std::vector<Stratum> element_cells() const {
    std::vector<Stratum> cells;
    cells.reserve(radiator_.element_count);
    for (std::uint32_t i = 0; i < radiator_.element_count; ++i) {
      cells.push_back(stratum_of(source_.mesh.elements[radiator_.first_element + i].corners, source_.mesh));
    }
    return cells;
  }

  [[nodiscard]] std::array<double, 3> far_weight(const Sight& sight, const Vote* vote) const {
    std::array<double, 3> weight{};
    if (sight.visible == 0) return weight;
    const Receiver& receiver = source_.receivers[sight.receiver];
    const std::vector<Stratum>& strata = sight.blocked == 0 ? far_.cell : far_.step[sight.step];
    for (std::size_t i = 0; i < strata.size(); ++i) {
      if (sight.blocked > 0 && vote[i] != Vote::Visible) continue;
      const double factor = form_factor(above_horizon(strata[i].all(), receiver), receiver.normal);
      const auto [u, v] = radiator_.coordinates(strata[i].centre());
      weight[0] += factor;
      weight[1] += factor * u;
      weight[2] += factor * v;
    }
    return weight;
  }

  void add_near_weights(const Sight& sight, const Vote* vote, std::span<double> weight) const {
    const Receiver& receiver = source_.receivers[sight.receiver];
    const std::uint32_t level = sight.blocked == 0 ? 0 : near_.level[sight.step];
    const std::vector<Stratum>& strata = sight.blocked == 0 ? near_.cell : near_.step[sight.step];
    for (std::size_t i = 0; i < strata.size(); ++i) {
      if (sight.blocked > 0 && vote[i] != Vote::Visible) continue;
      const std::size_t element = radiator_.first_element + (i >> (2 * level));
      add_shape_weights(strata[i], receiver, source_.radiators.element[element], level, weight);
    }
  }

  const CouplingSource& source_;
  mesh::PatchId patch_;
  const Radiator& radiator_;
  StratifiedRadiator far_;
  StratifiedRadiator near_;
};

}  // namespace

std::size_t Coupling::bytes() const {
  return sizeof(Coupling) + far_receiver.capacity() * sizeof(ReceiverId) +
         far_weight.capacity() * sizeof(std::array<float, 3>) + near_receiver.capacity() * sizeof(ReceiverId) +
         near_weight.capacity() * sizeof(float);
}

void Coupling::shrink() {
  far_receiver.shrink_to_fit();
  far_weight.shrink_to_fit();
  near_receiver.shrink_to_fit();
  near_weight.shrink_to_fit();
}

Coupling CouplingSource::couple(mesh::PatchId patch, ReceiverRange range) const {
  Coupling coupling;
  PatchCoupler coupler(*this, patch);
  const Stratum whole_patch = coupler.whole_patch();
  std::vector<ReceiverId> far;
  std::vector<ReceiverId> near;
  for (ReceiverId first = range.first; first < range.end; first += kBlock) {
    far.clear();
    near.clear();
    const ReceiverId end = std::min<ReceiverId>(range.end, first + kBlock);
    for (ReceiverId node = first; node < end; ++node) {
      const Reach how = reach(receivers[node], mesh.patches[patch], radiators.patch[patch], whole_patch);
      if (how == Reach::Far) far.push_back(node);
      if (how == Reach::Near) near.push_back(node);
    }
    if (!far.empty()) coupler.add_far(far, coupling);
    if (!near.empty()) coupler.add_near(near, coupling);
  }
  coupling.shrink();
  return coupling;
}

}  // namespace rad::solve
