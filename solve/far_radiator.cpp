#include "solve/far_radiator.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "solve/jitter_points.h"
#include "solve/random.h"

namespace rad::solve {
namespace {

/// Receivers that look at a time: enough rays to fill packets, few enough to stay in the cache.
constexpr std::size_t kBlock = 64;
/// Distance, in radii of the patch, from which its form factor is summed over the points of a quadrature. The error of
/// 2 × 2 Gauss points falls with the fourth power: 1e-4 of the form factor at 6 radii.
constexpr double kPointRadii = 6;
/// Distance, in radii of the patch, below which the strata are weighed by their own form factors.
constexpr double kExactRadii = 2;
/// Strata for the slopes of a radiator that is nearer, as a level.
constexpr int kSlopeLevel = 2;
/// The least strata of one that is partly below the horizon, as a level.
constexpr int kHorizonLevel = 1;
/// A lone visible stratum among at least this many blocked ones may be a ray that slipped between two triangles.
constexpr std::uint32_t kSuspectBlocked = 8;

double area_of(const Stratum& stratum, const dvec3& normal) {
  double twice = 0;
  for (std::uint32_t i = 2; i < stratum.count; ++i) {
    twice +=
        glm::dot(glm::cross(stratum.corner[i - 1] - stratum.corner[0], stratum.corner[i] - stratum.corner[0]), normal);
  }
  return twice / 2;
}

struct QuadraturePoint {
  dvec3 place;
  double weight = 0;  ///< an area
};

/// Exact for linear functions on any quadrilateral, for cubic ones on a parallelogram.
std::vector<QuadraturePoint> quadrature(const Stratum& patch, const dvec3& normal) {
  std::vector<QuadraturePoint> points;
  const auto& corner = patch.corner;
  if (patch.count == 3) {
    const double third = area_of(patch, normal) / 3;
    for (int i = 0; i < 3; ++i) {
      points.push_back(
          {corner[i] * (2.0 / 3) + corner[(i + 1) % 3] * (1.0 / 6) + corner[(i + 2) % 3] * (1.0 / 6), third});
    }
    return points;
  }
  const double low = (1 - 1 / std::numbers::sqrt3) / 2;
  for (const double u : {low, 1 - low}) {
    for (const double v : {low, 1 - low}) {
      const dvec3 along_u = (corner[1] - corner[0]) * (1 - v) + (corner[2] - corner[3]) * v;
      const dvec3 along_v = (corner[3] - corner[0]) * (1 - u) + (corner[2] - corner[1]) * u;
      points.push_back({point_in(patch, {u, v}), glm::dot(glm::cross(along_u, along_v), normal) / 4});
    }
  }
  return points;
}

}  // namespace

FarRadiator::FarRadiator(const CouplingSource& source, mesh::PatchId patch)
    : source_(source),
      patch_(patch),
      radiator_(source.radiators.patch[patch]),
      normal_(source.mesh.patches[patch].normal),
      whole_(stratum_of(source.mesh.patches[patch].corners, source.mesh)) {
  for (const QuadraturePoint& point : quadrature(whole_, normal_)) {
    points_.push_back({point.place, point.weight, radiator_.coordinates(point.place)});
  }
}

FarRadiator::Piece FarRadiator::piece_of(const Stratum& stratum) const {
  const dvec3 centre = stratum.centre();
  return {centre, area_of(stratum, normal_), radiator_.coordinates(centre)};
}

const FarRadiator::Level& FarRadiator::level(int number) {
  Level& level = levels_[static_cast<std::size_t>(number)];
  if (level.stratum.empty()) {
    level.stratum = strata(whole_, static_cast<std::uint32_t>(number));
    for (const Stratum& stratum : level.stratum) level.piece.push_back(piece_of(stratum));
  }
  return level;
}

/// The form factor of a small piece: cos θ cos θ' A / (π r²); 0 below the horizon.
double FarRadiator::kernel(const Look& look, const Piece& piece) const {
  const dvec3 towards = piece.centre - look.receiver->position;
  const double height = glm::dot(towards, look.receiver->normal);
  if (!(height > 0)) return 0;
  const double square = glm::dot(towards, towards);
  return height * look.plane_distance * piece.area / (std::numbers::pi * square * square);
}

/// Form factors of the mean and the slopes, were nothing in the way.
void FarRadiator::measure(Look& look) const {
  const dvec3 towards = radiator_.centre - look.receiver->position;
  const double square = glm::dot(towards, towards);
  const bool above = glm::dot(towards, look.receiver->normal) >= radiator_.radius;
  const bool small = above && square > kPointRadii * kPointRadii * radiator_.radius * radiator_.radius;
  look.near = !small;
  const std::vector<Piece>& pieces = small ? points_ : levels_[kSlopeLevel].piece;
  double sum = 0, u = 0, v = 0;
  for (const Piece& piece : pieces) {
    const double factor = kernel(look, piece);
    sum += factor;
    u += factor * piece.coordinates[0];
    v += factor * piece.coordinates[1];
  }
  look.factor =
      small ? std::min(sum, 1.0) : form_factor(above_horizon(whole_.all(), *look.receiver), look.receiver->normal);
  if (sum > 0) look.slope = {u / sum * look.factor, v / sum * look.factor};
}

FarRadiator::Look FarRadiator::begin(const FarRequest& request) const {
  Look look;
  look.receiver = &source_.receivers[request.receiver];
  look.plane_distance = glm::dot(look.receiver->position - radiator_.centre, normal_);
  if (!(look.plane_distance > 0)) return look;
  if (glm::dot(radiator_.centre - look.receiver->position, look.receiver->normal) <= -radiator_.radius) return look;
  measure(look);
  look.last_level = source_.importance.level_for(look.factor * request.importance);
  look.level = source_.importance.first_level(look.last_level);
  // Of what is partly below the horizon the whole says nothing.
  const dvec3 towards = radiator_.centre - look.receiver->position;
  const bool cut = glm::dot(towards, look.receiver->normal) < radiator_.radius;
  const double exact = kExactRadii * radiator_.radius;
  look.exact = cut || glm::dot(towards, towards) < exact * exact;
  if (cut) {
    look.level = std::max(look.level, kHorizonLevel);
    look.last_level = std::max(look.last_level, kHorizonLevel);
  }
  return look;
}

Segment FarRadiator::ray(const FarRequest& request, const Look& look, std::uint32_t stratum, std::uint32_t attempt) {
  const std::array<double, 2> random =
      jitter(patch_, request.receiver, stratum, static_cast<std::uint32_t>(2 * look.level) + attempt);
  const dvec3 lift = normal_ * source_.lift;
  const Stratum& piece = level(look.level).stratum[stratum];
  if (!look.exact) return {look.receiver->position, point_in(piece, random) + lift};
  const ConvexPolygon above = above_horizon(piece.all(), *look.receiver);
  return {look.receiver->position, look.receiver->position + point_in(above, random) + lift};
}

void FarRadiator::aim(const FarRequest& request, std::uint32_t index, Look& look) {
  const Level& pieces = level(look.level);
  look.all = look.visible = {};
  look.visible_count = look.blocked_count = 0;
  if (look.near && look.level < kSlopeLevel && aim_by_kernel(request, index, look)) return;
  for (std::uint32_t i = 0; i < pieces.piece.size(); ++i) {
    const double factor =
        look.exact ? form_factor(above_horizon(pieces.stratum[i].all(), *look.receiver), look.receiver->normal)
                   : kernel(look, pieces.piece[i]);
    if (!(factor > 0)) continue;
    segments_.push_back(ray(request, look, i, 0));
    rays_.push_back({index, i, factor, pieces.piece[i].coordinates});
  }
}

/// Few rays, each to a point chosen with a probability that is the kernel's: what is near is also less often hidden,
/// and rays that are even over the patch would lose light. False where no point is above the horizon.
bool FarRadiator::aim_by_kernel(const FarRequest& request, std::uint32_t index, const Look& look) {
  const Level& pieces = level(kSlopeLevel);
  std::array<double, 1 << (2 * kSlopeLevel)> until{};
  double sum = 0;
  for (std::size_t i = 0; i < until.size(); ++i) until[i] = sum += kernel(look, pieces.piece[i]);
  if (!(sum > 0)) return false;
  const std::uint32_t count = 1U << (2 * look.level);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [first, second] = jitter(patch_, request.receiver, i, static_cast<std::uint32_t>(2 * look.level));
    const double wanted = (i + first) / count * sum;
    const auto chosen = std::min<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(until.begin(), until.end(), wanted) - until.begin()),
        until.size() - 1);
    const double below = chosen > 0 ? until[chosen - 1] : 0;
    const double width = until[chosen] - below;
    const std::array<double, 2> random{width > 0 ? std::clamp((wanted - below) / width, 0.0, 1.0) : 0.5, second};
    const Stratum& stratum = pieces.stratum[chosen];
    const dvec3 target = look.exact
                             ? look.receiver->position + point_in(above_horizon(stratum.all(), *look.receiver), random)
                             : point_in(stratum, random);
    segments_.push_back({look.receiver->position, target + normal_ * source_.lift});
    rays_.push_back({index, static_cast<std::uint32_t>(chosen), 1.0 / count, pieces.piece[chosen].coordinates});
  }
  return true;
}

void FarRadiator::trace_level(std::span<const FarRequest> requests, std::span<Look> looks) {
  blocked_.resize(segments_.size());
  source_.visibility.trace(segments_, blocked_);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const auto& [index, stratum, factor, coordinates] = rays_[i];
    Look& look = looks[index];
    const std::array<double, 3> part{factor, factor * coordinates[0], factor * coordinates[1]};
    for (std::size_t k = 0; k < 3; ++k) look.all[k] += part[k];
    ++(blocked_[i] ? look.blocked_count : look.visible_count);
    if (blocked_[i]) continue;
    look.last_visible = stratum;
    for (std::size_t k = 0; k < 3; ++k) look.visible[k] += part[k];
  }
  segments_.clear();
  rays_.clear();
  for (std::size_t i = 0; i < looks.size(); ++i) confirm_lone(requests[i], looks[i]);
}

void FarRadiator::confirm_lone(const FarRequest& request, Look& look) {
  if (look.visible_count != 1 || look.blocked_count < kSuspectBlocked) return;
  const Segment again = ray(request, look, look.last_visible, 1);
  std::uint8_t blocked = 0;
  source_.visibility.trace({&again, 1}, {&blocked, 1});
  if (!blocked) return;
  look.visible = {};
  look.visible_count = 0;
  ++look.blocked_count;
}

FarView FarRadiator::view_of(const FarRequest& request, const Look& look) const {
  FarView view;
  view.share = static_cast<float>(look.factor * request.importance);
  if (look.visible_count + look.blocked_count == 0) return view;
  view.seen = look.blocked_count == 0 ? Seen::Whole : look.visible_count == 0 ? Seen::Blocked : Seen::Partly;
  if (view.seen == Seen::Blocked) return view;
  if (view.seen == Seen::Whole) {
    view.weight = {static_cast<float>(look.factor), static_cast<float>(look.slope[0]),
                   static_cast<float>(look.slope[1])};
    return view;
  }
  for (std::size_t k = 0; k < 3; ++k) view.weight[k] = static_cast<float>(look.factor * look.visible[k] / look.all[0]);
  return view;
}

void FarRadiator::look(std::span<const FarRequest> requests, std::vector<FarView>& views) {
  level(kSlopeLevel);
  std::vector<Look> looks;
  for (std::size_t first = 0; first < requests.size(); first += kBlock) {
    const auto block = requests.subspan(first, std::min(kBlock, requests.size() - first));
    looks.clear();
    for (const FarRequest& request : block) looks.push_back(begin(request));
    for (std::uint32_t i = 0; i < block.size(); ++i) {
      if (looks[i].factor > 0) aim(block[i], i, looks[i]);
    }
    trace_level(block, looks);
    for (std::uint32_t i = 0; i < block.size(); ++i) {
      Look& look = looks[i];
      if (look.level == look.last_level || look.visible_count == 0 || look.blocked_count == 0) continue;
      look.level = look.last_level;
      aim(block[i], i, look);
    }
    if (!segments_.empty()) trace_level(block, looks);
    for (std::size_t i = 0; i < block.size(); ++i) views.push_back(view_of(block[i], looks[i]));
  }
}

}  // namespace rad::solve
