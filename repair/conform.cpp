#include "repair/conform.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>

#include "repair/contact_lint.h"
#include "repair/isect.h"
#include "repair/leader_planes.h"
#include "repair/normaliser.h"
#include "repair/triangle_lint.h"
#include "repair/weld.h"

namespace rad::repair {
namespace {

// Measured on thousands of hard scenes: plane passes need 4 rounds in 99 % of them, the residual loop 6 in 95 % and up
// to about 100 where many things nearly coincide in one place. The caps end what would not end.
constexpr std::size_t kPlaneRounds = 8;
constexpr std::size_t kResidualRounds = 150;
constexpr std::size_t kMergeEvery = 10;
// Every so many rounds new points reach half a weld distance farther for points to use.
constexpr std::size_t kWidenEvery = 15;
constexpr std::size_t kMostWidenings = 3;  // the reach that the grid of points serves (complex.cpp: kGridCellInWelds)
constexpr double kWidening = 0.5;
constexpr double kForcedReach = 0.5;  // T
// After snapping a face within this of its plane keeps it, as a share of T.
constexpr double kKeepBand = 0.5;

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Conformer {
 public:
  Conformer(Soup soup, std::int64_t tolerance, double scale, const ConformProgress& progress)
      : tolerance_(tolerance), width_(static_cast<double>(tolerance) * scale), progress_(progress) {
    result_.welded = std::move(soup);
  }

  Conformer(std::unique_ptr<Complex> grouped, std::int64_t tolerance, const ConformProgress& progress)
      : tolerance_(tolerance), width_(grouped->tolerance()), progress_(progress) {
    result_.complex = std::move(grouped);
  }

  Conformed run(ConformSteps steps) {
    Stopwatch watch;
    if (steps.group) group();
    if (!result_.complex) load();
    Normaliser normaliser(*result_.complex);
    const double weld = result_.complex->weld_distance();
    if (steps.group && go_on("inserting T-vertices", 0)) normaliser.run(weld);
    result_.counts.t_vertices = result_.complex->counts().splits;
    result_.timings.grouper = watch.lap();
    if (steps.cut) {
      plane_rounds(normaliser, weld);
      residual_rounds(normaliser, weld);
    } else {
      result_.triangulation.update(*result_.complex);
      result_.sound = result_.triangulation.sound();
    }
    result_.counts.complex = result_.complex->counts();
    result_.timings.isect = watch.lap();
    return std::move(result_);
  }

 private:
  bool go_on(const char* step, std::size_t left) {
    if (!result_.interrupted && progress_ && !progress_(step, left)) result_.interrupted = true;
    return !result_.interrupted;
  }

  void weld_soup() {
    Soup& soup = result_.welded;
    const auto representative = weld(soup.points, width_);
    for (std::size_t i = 0; i < representative.size(); ++i) {
      const LatticePoint &from = soup.points[i], &to = soup.points[representative[i]];
      if (from == to) continue;
      ++result_.counts.welded;
      const double moved = glm::distance(geom::as_vector(from), geom::as_vector(to));
      result_.counts.largest_weld = std::max(result_.counts.largest_weld, moved);
    }
    result_.counts.collapsed += replace_points(soup, representative);
  }

  void group() {
    weld_soup();
    if (!go_on("finding planes", 0)) return;
    result_.counts.snapped = snap_to_planes(result_.welded, claim_planes(result_.welded, width_, width_), width_);
    if (result_.counts.snapped.moved == 0) return;
    result_.counts.collapsed += replace_points(result_.welded, weld(result_.welded.points, width_));
  }

  void load() {
    const Soup& soup = result_.welded;
    result_.complex = std::make_unique<Complex>(width_);
    Complex& complex = *result_.complex;
    for (const LatticePoint& point : soup.points) complex.add_point(point);
    const PlaneClaims claims = claim_planes(soup, kKeepBand * width_, width_);
    for (const LeaderPlane& leader : claims.leaders) complex.add_cluster(leader.plane, leader.area);
    for (std::size_t i = 0; i < soup.pieces.size(); ++i) {
      const SoupPiece& piece = soup.pieces[i];
      const ClusterId cluster = claims.leader_of_piece[i];
      const bool along = glm::dot(soup.normal_of(piece), claims.leaders[cluster].plane.normal) > 0;
      const PieceId id = complex.add_piece({cluster, along, piece.rank, piece.source});
      for (const auto& [from, to] : soup.edges_of(piece)) complex.toggle(edge_key(from, to), Item::piece(id));
    }
  }

  void plane_rounds(Normaliser& normaliser, double weld) {
    Isect isect(*result_.complex);
    for (std::size_t round = 0; round < kPlaneRounds && go_on("cutting planes", 0); ++round) {
      result_.triangulation.update(*result_.complex);
      const bool cut = isect.pass(result_.triangulation);
      const bool changed = normaliser.run(weld);
      result_.counts.plane_rounds = round + 1;
      if (!cut && !changed) break;
    }
  }

  void judge() {
    result_.triangulation.update(*result_.complex);
    const TriangleSet set{result_.complex->points(), result_.triangulation.triangles(), result_.triangulation.folded()};
    result_.violations = lint_triangles(set, tolerance_);
    result_.sound = result_.triangulation.sound();
    if (result_.clean()) result_.violations = lint_contacts(set, tolerance_);
  }

  // Tries harder until something changes.
  bool cure(Residual& residual, double reach, bool merge) {
    if (!merge) {
      for (const Effort effort : {Effort::OneKind, Effort::AllKinds, Effort::Forced}) {
        const double own_reach = effort == Effort::Forced ? kForcedReach * width_ : reach;
        if (residual.round(result_.triangulation, result_.violations, effort, own_reach)) return true;
      }
    }
    return residual.round(result_.triangulation, result_.violations, Effort::Merge, reach);
  }

  void residual_rounds(Normaliser& normaliser, double weld) {
    Residual residual(*result_.complex);
    judge();
    for (std::size_t round = 0; round < kResidualRounds && !result_.clean(); ++round) {
      if (!go_on("curing what is left", result_.violations.size())) break;
      const std::size_t widenings = std::min(round / kWidenEvery, kMostWidenings);
      const double reach = weld * (1 + kWidening * static_cast<double>(widenings));
      const bool merge = round > 0 && round % kMergeEvery == 0;
      if (!cure(residual, reach, merge) && !merge) break;
      normaliser.run(reach);
      judge();
      result_.counts.residual_rounds = round + 1;
    }
    result_.counts.residual = residual.counts();
  }

  std::int64_t tolerance_;
  double width_;
  const ConformProgress& progress_;
  Conformed result_;
};

}  // namespace

Conformed conform(Soup soup, std::int64_t tolerance, double scale, const ConformProgress& progress,
                  ConformSteps steps) {
  return Conformer(std::move(soup), tolerance, scale, progress).run(steps);
}

Conformed cut(std::unique_ptr<Complex> grouped, std::int64_t tolerance, const ConformProgress& progress) {
  return Conformer(std::move(grouped), tolerance, progress).run({.group = false, .cut = true});
}

}  // namespace rad::repair
