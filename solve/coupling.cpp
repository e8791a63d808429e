#include "solve/coupling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "solve/receiver_looks.h"

namespace rad::solve {
namespace {

/// Gap between a patch and a radiator, in radii of the radiator or of the patch's elements, below which its samples do
/// not stand for it;
constexpr double kCloseRadii = 2;
/// and distance of the centres, in radii of the receiving patch.
constexpr double kSampledRadii = 2;
/// Shares of the irradiance, in units of the noise, up to which samples may stand for a patch: in any case, where the
/// radiator is partly hidden, and where it is seen by all of them or by none. What hides one radiator from the samples
/// hides its neighbours as well, so the errors of many add up.
constexpr double kSampledAnyway = 0.25;
constexpr double kSampledPartly = 0.5;
constexpr double kSampledWhole = 1.5;
/// Departure of the centre from the mean of the corners, as a share of the largest, up to which the quadratic through
/// them will do.
constexpr double kSampledBend = 0.15;

enum class Reach : std::uint8_t { None, Sampled, Everywhere };

class Coupler {
 public:
  Coupler(const CouplingSource& source, mesh::PatchId patch, PatchRange range, CouplingScratch& scratch)
      : source_(source), patch_(patch), radiator_(source.radiators.patch[patch]), looks_(source, patch, scratch) {
    for (mesh::PatchId receiver = range.first; receiver < range.end; ++receiver) {
      const Reach reach = reach_of(receiver);
      if (reach != Reach::None) pairs_.push_back({receiver, reach, source_.importance.of(patch_, receiver)});
    }
  }

  Coupling run() {
    for (const Pair& pair : pairs_) {
      if (pair.reach == Reach::Sampled) request_samples(pair);
    }
    looks_.look_far();
    for (Pair& pair : pairs_) {
      if (pair.reach == Reach::Sampled && !stand_for(pair)) pair.reach = Reach::Everywhere;
    }
    for (const Pair& pair : pairs_) {
      if (pair.reach == Reach::Everywhere) request_locals(pair);
    }
    looks_.look_far();
    looks_.look_near(coupling_.near_weight);
    for (const Pair& pair : pairs_) {
      if (pair.reach == Reach::Sampled) add_samples(pair);
      if (pair.reach != Reach::Everywhere) continue;
      coupling_.everywhere.push_back(pair.patch);
      add_locals(pair);
    }
    return std::move(coupling_);
  }

 private:
  struct Pair {
    mesh::PatchId patch = 0;
    Reach reach = Reach::None;
    double importance = 0;
  };

  /// True where no corner of one patch is in front of the plane of the other.
  [[nodiscard]] bool behind(mesh::PatchId patch, mesh::PatchId plane) const {
    const Radiator& own = source_.radiators.patch[patch];
    const dvec3& origin = source_.radiators.patch[plane].centre;
    const dvec3& normal = source_.mesh.patches[plane].normal;
    const double height = glm::dot(own.centre - origin, normal);
    if (height > own.radius) return false;
    if (height < -own.radius) return true;
    const mesh::Corners& corners = source_.mesh.patches[patch].corners;
    return std::none_of(corners.node.begin(), corners.node.begin() + corners.count, [&](mesh::NodeId node) {
      return glm::dot(source_.mesh.nodes[node].position - origin, normal) > source_.lift;
    });
  }

  [[nodiscard]] Reach reach_of(mesh::PatchId receiver) const {
    if (receiver == patch_ || behind(receiver, patch_) || behind(patch_, receiver)) return Reach::None;
    if (source_.samples_only) return Reach::Sampled;
    const Radiator& own = source_.radiators.patch[receiver];
    const double distance = glm::length(own.centre - radiator_.centre);
    if (distance - own.radius < kCloseRadii * std::max(radiator_.radius, own.element_radius)) return Reach::Everywhere;
    return own.element_count > 1 && distance > kSampledRadii * own.radius ? Reach::Sampled : Reach::Everywhere;
  }

  void request_samples(const Pair& pair) {
    for (const ReceiverId receiver : source_.samples.receiver[pair.patch])
      looks_.request_far(receiver, pair.importance);
  }

  void request_locals(const Pair& pair) {
    for (const ReceiverId receiver : source_.radiators.receivers_of(source_.radiators.patch[pair.patch])) {
      looks_.request(receiver, pair.importance);
    }
  }

  /// Whether the samples of a patch stand for all of it: a matter of how much comes there, of whether they agree on
  /// what is in the way, and of how much it bends.
  [[nodiscard]] bool stand_for(const Pair& pair) const {
    if (source_.samples_only) return true;
    const auto& receivers = source_.samples.receiver[pair.patch];
    double share = 0, largest = 0, corners = 0;
    bool seen = false, hidden = false;
    const std::uint32_t count = source_.mesh.patches[pair.patch].corners.count;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const FarView& sample = looks_.view(receivers[i]);
      share = std::max<double>(share, sample.share);
      largest = std::max<double>(largest, sample.weight[0]);
      if (i < count) corners += sample.weight[0] / count;
      seen = seen || sample.seen == Seen::Whole || sample.seen == Seen::Partly;
      hidden = hidden || sample.seen == Seen::Blocked || sample.seen == Seen::Partly;
    }
    const double noise = source_.importance.noise;
    if (share <= kSampledAnyway * noise) return true;
    if (share > (seen && hidden ? kSampledPartly : kSampledWhole) * noise) return false;
    return std::abs(looks_.view(receivers[kCentreShare]).weight[0] - corners) <= kSampledBend * largest;
  }

  void add_samples(const Pair& pair) {
    SampleRow row;
    row.patch = pair.patch;
    bool any = false;
    for (std::size_t i = 0; i < row.weight.size(); ++i) {
      row.weight[i] = looks_.view(source_.samples.receiver[pair.patch][i]).weight;
      any = any || row.weight[i][0] > 0;
    }
    if (any) coupling_.sample.push_back(row);
  }

  void add_locals(const Pair& pair) {
    const Radiator& own = source_.radiators.patch[pair.patch];
    for (std::uint32_t local = own.first_local; local < own.first_local + own.local_count; ++local) {
      const ReceiverId receiver = source_.radiators.local_receiver[local];
      if (const auto row = looks_.near_row(receiver)) {
        coupling_.near_local.push_back(local);
        coupling_.near_row.push_back(*row);
        continue;
      }
      const FarWeight& weight = looks_.view(receiver).weight;
      if (!(weight[0] > 0)) continue;
      coupling_.far_local.push_back(local);
      coupling_.far_weight.push_back(weight);
    }
  }

  const CouplingSource& source_;
  mesh::PatchId patch_;
  const Radiator& radiator_;
  ReceiverLooks looks_;
  std::vector<Pair> pairs_;
  Coupling coupling_;
};

template <typename Item>
std::size_t bytes_of(const std::vector<Item>& items) {
  return items.capacity() * sizeof(Item);
}

}  // namespace

std::size_t Coupling::bytes() const {
  return sizeof(Coupling) + bytes_of(sample) + bytes_of(everywhere) + bytes_of(far_local) + bytes_of(far_weight) +
         bytes_of(near_local) + bytes_of(near_row) + bytes_of(near_weight);
}

void Coupling::shrink() {
  sample.shrink_to_fit();
  everywhere.shrink_to_fit();
  far_local.shrink_to_fit();
  far_weight.shrink_to_fit();
  near_local.shrink_to_fit();
  near_row.shrink_to_fit();
  near_weight.shrink_to_fit();
}

Coupling couple(const CouplingSource& source, mesh::PatchId patch, PatchRange range, CouplingScratch& scratch) {
  Coupling coupling = Coupler(source, patch, range, scratch).run();
  coupling.shrink();
  return coupling;
}

}  // namespace rad::solve
