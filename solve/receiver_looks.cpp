#include "solve/receiver_looks.h"

#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

/// Distance from the centre of a radiator, in its radii, below which its radiosity is not taken as a mean and two
/// slopes.
constexpr double kNearRadii = 1.5;
/// The least strata, as a level, that make it worth while.
constexpr int kNearLevel = 2;

}  // namespace

ReceiverLooks::ReceiverLooks(const CouplingSource& source, mesh::PatchId patch, CouplingScratch& scratch)
    : source_(source), patch_(patch), scratch_(scratch), far_(source, patch), near_(source, patch) {
  scratch_.far.clear();
  scratch_.near.clear();
}

void ReceiverLooks::request_far(ReceiverId receiver, double importance) {
  if (scratch_.far.add(receiver)) requests_.push_back({receiver, importance});
}

void ReceiverLooks::request(ReceiverId receiver, double importance) {
  if (!request_near(receiver, importance)) request_far(receiver, importance);
}

bool ReceiverLooks::request_near(ReceiverId id, double importance) {
  if (scratch_.near.find(id) != ReceiverSet::kNone) return true;
  const Radiator& radiator = source_.radiators.patch[patch_];
  const Receiver& receiver = source_.receivers[id];
  const dvec3 away = receiver.position - radiator.centre;
  const double near = kNearRadii * radiator.radius;
  if (!(glm::dot(away, away) < near * near)) return false;
  if (!(glm::dot(away, source_.mesh.patches[patch_].normal) > 0)) return false;
  const Stratum whole_patch = stratum_of(source_.mesh.patches[patch_].corners, source_.mesh);
  const double factor = form_factor(above_horizon(whole_patch.all(), receiver), receiver.normal);
  const int level = source_.importance.level_for(factor * importance);
  if (level < kNearLevel) return false;
  scratch_.near.add(id);
  near_level_.push_back(level);
  return true;
}

void ReceiverLooks::look_near(std::vector<float>& weights) {
  const std::vector<ReceiverId>& near = scratch_.near.list();
  row_.resize(near.size());
  std::uint32_t rows = 0;
  std::vector<ReceiverId> together;
  for (int level = kNearLevel; level <= kDeepestStrata; ++level) {
    together.clear();
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (near_level_[i] != level) continue;
      together.push_back(near[i]);
      row_[i] = rows++;
    }
    if (!together.empty()) near_.look(together, level, weights);
  }
}

std::optional<std::uint32_t> ReceiverLooks::near_row(ReceiverId receiver) const {
  const std::uint32_t number = scratch_.near.find(receiver);
  if (number == ReceiverSet::kNone) return std::nullopt;
  return row_[number];
}

}  // namespace rad::solve
