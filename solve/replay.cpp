#include "solve/replay.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "solve/receiver_looks.h"

namespace rad::solve {
namespace {

/// Shares of the irradiance of an element, in units of the noise, up to which the values at its corners and centre
/// stand for all of it: in any case, where only some of them see the radiator, and where all do.
constexpr double kStandAnyway = 0.25;
constexpr double kStandPartly = 2.5;
constexpr double kStandWhole = 5;
/// Departure of the centre from the mean of the corners, as a share of the largest, up to which the quadratic will do.
constexpr double kStandBend = 0.15;

class Replay {
 public:
  Replay(const CouplingSource& source, const Irradiance& irradiance, std::span<const Shot> shot_by,
         std::span<const ReplayPoint> points)
      : irradiance_(irradiance),
        shot_by_(shot_by),
        points_(points),
        first_id_(static_cast<ReceiverId>(source.receivers.size())),
        receivers_(with_points(source.receivers, points)),
        source_{source.mesh,       source.radiators,  receivers_, source.samples,
                source.visibility, source.importance, source.lift},
        scratch_(receivers_.size()),
        received_(points.size(), dvec3(0)) {}

  std::vector<dvec3> run(CouplingStore& couplings) {
    tbb::parallel_for(std::size_t{0}, couplings.ranges().size(), [&](std::size_t range) {
      const std::span<const ReplayPoint> points = points_of(couplings.ranges()[range]);
      if (points.empty()) return;
      for (const Shot& shot : shot_by_) {
        if (shot.at_local.empty()) continue;
        couplings.with(shot.patch, range, [&](const Coupling& coupling) { receive(shot, coupling, points); });
      }
      for (const ReplayPoint& point : points) received_[index_of(point)] += sampled(point);
    });
    return std::move(received_);
  }

 private:
  static std::vector<Receiver> with_points(std::span<const Receiver> receivers, std::span<const ReplayPoint> points) {
    std::vector<Receiver> all(receivers.begin(), receivers.end());
    for (const ReplayPoint& point : points) all.push_back(point.receiver);
    return all;
  }

  [[nodiscard]] std::size_t index_of(const ReplayPoint& point) const {
    return static_cast<std::size_t>(&point - points_.data());
  }
  [[nodiscard]] ReceiverId id_of(const ReplayPoint& point) const {
    return first_id_ + static_cast<ReceiverId>(index_of(point));
  }

  [[nodiscard]] mesh::PatchId patch_of(const ReplayPoint& point) const {
    return source_.mesh.elements[point.element].patch;
  }

  [[nodiscard]] std::span<const ReplayPoint> points_of(PatchRange patches) const {
    const auto patch = [&](const ReplayPoint& point) { return patch_of(point); };
    const auto first = std::ranges::lower_bound(points_, patches.first, {}, patch);
    const auto last = std::ranges::lower_bound(points_, patches.end, {}, patch);
    return {first, last};
  }

  void receive(const Shot& shot, const Coupling& coupling, std::span<const ReplayPoint> points) {
    std::vector<const ReplayPoint*> asking;
    auto patch = coupling.everywhere.begin();
    for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
      while (last < points.size() && points[last].element == points[first].element) ++last;
      patch = std::lower_bound(patch, coupling.everywhere.end(), patch_of(points[first]));
      if (patch == coupling.everywhere.end()) break;
      if (*patch != patch_of(points[first])) continue;
      const std::span<const ReplayPoint> together = points.subspan(first, last - first);
      const std::array<dvec3, 5> five = arriving_at_element(shot, coupling, points[first].element);
      if (stands(five, points[first].element)) {
        for (const ReplayPoint& point : together) received_[index_of(point)] += interpolated(five, point);
      } else {
        for (const ReplayPoint& point : together) asking.push_back(&point);
      }
    }
    if (!asking.empty()) look(shot, asking);
  }

  void look(const Shot& shot, std::span<const ReplayPoint* const> points) {
    ReceiverLooks looks(source_, shot.patch, scratch_.local());
    for (const ReplayPoint* point : points) {
      looks.request(id_of(*point), source_.importance.of(shot.patch, patch_of(*point)));
    }
    looks.look_far();
    std::vector<float> near;
    looks.look_near(near);
    const std::size_t locals = shot.at_local.size();
    for (const ReplayPoint* point : points) {
      const auto row = looks.near_row(id_of(*point));
      received_[index_of(*point)] += row ? arriving(shot, std::span(near).subspan(*row * locals, locals))
                                         : arriving(shot, looks.view(id_of(*point)).weight);
    }
  }

  [[nodiscard]] std::array<dvec3, 5> arriving_at_element(const Shot& shot, const Coupling& coupling,
                                                         std::uint32_t element) const {
    std::array<dvec3, 5> five{};
    const Radiator& patch = source_.radiators.patch[source_.mesh.elements[element].patch];
    for (std::size_t k = 0; k < five.size(); ++k) {
      five[k] = arriving_at(shot, coupling, patch.first_local + source_.radiators.element[element][k]);
    }
    return five;
  }

  static dvec3 arriving_at(const Shot& shot, const Coupling& coupling, std::uint32_t local) {
    const auto far = std::ranges::lower_bound(coupling.far_local, local);
    if (far != coupling.far_local.end() && *far == local) {
      return arriving(shot, coupling.far_weight[static_cast<std::size_t>(far - coupling.far_local.begin())]);
    }
    const auto near = std::ranges::lower_bound(coupling.near_local, local);
    if (near == coupling.near_local.end() || *near != local) return dvec3(0);
    const std::size_t locals = shot.at_local.size();
    const std::size_t row = coupling.near_row[static_cast<std::size_t>(near - coupling.near_local.begin())];
    return arriving(shot, std::span(coupling.near_weight).subspan(row * locals, locals));
  }

  /// Whether what arrives at the corners and the centre of an element stands for all of it.
  [[nodiscard]] bool stands(const std::array<dvec3, 5>& five, std::uint32_t element) const {
    const mesh::Element& own = source_.mesh.elements[element];
    const std::uint32_t count = own.corners.count;
    const dvec3& all = source_.importance.irradiance[own.patch];
    double share = 0, bend = 0;
    bool seen = false, hidden = false;
    for (int channel = 0; channel < 3; ++channel) {
      const double centre = std::abs(five[kCentreShare][channel]);
      double largest = centre, mean = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        largest = std::max(largest, std::abs(five[i][channel]));
        mean += five[i][channel] / count;
      }
      if (!(largest > 0)) continue;
      share = std::max(share, all[channel] > 0 ? largest / all[channel] : 1.0);
      bend = std::max(bend, std::abs(five[kCentreShare][channel] - mean) / largest);
    }
    const auto dark = [](const dvec3& value) { return value == dvec3(0); };
    for (std::uint32_t i = 0; i < count; ++i) (dark(five[i]) ? hidden : seen) = true;
    (dark(five[kCentreShare]) ? hidden : seen) = true;
    const double noise = source_.importance.noise;
    if (share <= kStandAnyway * noise) return seen || !hidden;
    return share <= (seen && hidden ? kStandPartly : kStandWhole) * noise && bend <= kStandBend;
  }

  [[nodiscard]] dvec3 interpolated(const std::array<dvec3, 5>& five, const ReplayPoint& point) const {
    const Stratum element = stratum_of(source_.mesh.elements[point.element].corners, source_.mesh);
    return sum_of(five, shape_at(element.count, place_in(element, point.receiver.position)));
  }

  static dvec3 sum_of(const std::array<dvec3, 5>& five, const Shares& shares) {
    dvec3 sum{0, 0, 0};
    for (std::size_t k = 0; k < five.size(); ++k) sum += five[k] * shares[k];
    return sum;
  }

  [[nodiscard]] dvec3 sampled(const ReplayPoint& point) const {
    const Stratum patch = stratum_of(source_.mesh.patches[patch_of(point)].corners, source_.mesh);
    return sum_of(irradiance_.sampled(patch_of(point)),
                  shape_at(patch.count, place_in(patch, point.receiver.position)));
  }

  const Irradiance& irradiance_;
  std::span<const Shot> shot_by_;
  std::span<const ReplayPoint> points_;
  ReceiverId first_id_ = 0;
  std::vector<Receiver> receivers_;  ///< of the mesh, then the points
  const CouplingSource source_;
  tbb::enumerable_thread_specific<CouplingScratch> scratch_;
  std::vector<dvec3> received_;  ///< by point; each is written by the one task that has its patch
};

}  // namespace

std::vector<dvec3> replay(const CouplingSource& source, CouplingStore& couplings, const Irradiance& irradiance,
                          std::span<const Shot> shot_by, std::span<const ReplayPoint> points) {
  return Replay(source, irradiance, shot_by, points).run(couplings);
}

}  // namespace rad::solve
