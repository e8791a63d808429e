#include "solve/near_radiator.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

/// Distance from a piece of an element, in radii of the piece, below which its radiosity is not taken at its centre.
constexpr double kPieceRadii = 2;
constexpr std::uint32_t kDeepestPiece = 4;

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

}  // namespace

NearRadiator::NearRadiator(const CouplingSource& source, mesh::PatchId patch)
    : source_(source), patch_(patch), radiator_(source.radiators.patch[patch]) {}

const StratifiedRadiator& NearRadiator::strata_for(int level) {
  std::optional<StratifiedRadiator>& made = strata_[static_cast<std::size_t>(level)];
  if (made) return *made;
  std::vector<Stratum> cells;
  for (std::uint32_t i = 0; i < radiator_.element_count; ++i) {
    cells.push_back(stratum_of(source_.mesh.elements[radiator_.first_element + i].corners, source_.mesh));
  }
  const std::size_t first = std::size_t{1} << (2 * source_.importance.first_level(level));
  const std::size_t most = std::size_t{1} << (2 * level);
  const dvec3 lift = source_.mesh.patches[patch_].normal * source_.lift;
  made = stratified(patch_, lift, std::move(cells), first, most);
  return *made;
}

void NearRadiator::look(std::span<const ReceiverId> receivers, int level, std::vector<float>& weights) {
  const StratifiedRadiator& radiator = strata_for(level);
  const Sights sights = rad::solve::look(radiator, receivers, source_.receivers, source_.visibility);
  for (const Sight& sight : sights.sight) {
    weight_.assign(radiator_.local_count, 0.0);
    if (sight.visible > 0) add_weights(radiator, sight, sights.votes_of(sight));
    weights.insert(weights.end(), weight_.begin(), weight_.end());
  }
}

void NearRadiator::add_weights(const StratifiedRadiator& radiator, const Sight& sight, const Vote* vote) {
  const std::uint32_t level = sight.blocked == 0 ? 0 : radiator.level[sight.step];
  const std::vector<Stratum>& strata = sight.blocked == 0 ? radiator.cell : radiator.step[sight.step];
  for (std::size_t i = 0; i < strata.size(); ++i) {
    if (sight.blocked > 0 && vote[i] != Vote::Visible) continue;
    const std::size_t element = radiator_.first_element + (i >> (2 * level));
    add_shape_weights(strata[i], source_.receivers[sight.receiver], source_.radiators.element[element], level, weight_);
  }
}

}  // namespace rad::solve
