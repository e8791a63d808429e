#include "repair/conform.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>

#include "repair/isect.h"
#include "repair/leader_planes.h"
#include "repair/normaliser.h"
#include "repair/piece_loader.h"
#include "repair/pieces_at_fault.h"
#include "repair/triangle_lint.h"
#include "repair/weld.h"

namespace rad::repair {
namespace {

// Measured on thousands of hard scenes: the residual loop needs 6 rounds in 95 % of them and up to about 100 where many
// things nearly coincide in one place. The cap ends what would not end.
constexpr std::size_t kResidualRounds = 150;
constexpr std::size_t kMergeEvery = 10;
// Every so many rounds new points reach half a weld distance farther for points to use.
constexpr std::size_t kWidenEvery = 15;
constexpr std::size_t kMostWidenings = 3;
constexpr double kWidening = 0.5;
constexpr double kForcedReach = 0.5;  // T
// Contacts are looked for as soon as no more than this many other violations are left. Measured on the hardest models:
// where one fault that stays hides the contacts, each of them costs a round of its own later.
constexpr std::size_t kFewViolations = 30;
// No surface is drawn farther from where it was than this, in T of the lint: 8 T is what is promised, and half of T is
// for points inside triangles of which the corners are held to different pieces.
constexpr double kFarthestDrawn = 7.5;
// After snapping a face within this of its plane keeps it, as a share of T.
constexpr double kKeepBand = 0.5;

class Conformer {
 public:
  Conformer(Soup soup, std::int64_t tolerance, double scale, const Held& held, const ConformProgress& progress)
      : tolerance_(tolerance),
        width_(static_cast<double>(tolerance) * scale),
        held_(held),
        lint_(tolerance),
        soup_(std::move(soup)),
        progress_(progress) {
    if (soup_.origins.empty()) soup_.note_origins();
  }

  Conformed run() {
    Stopwatch watch;
    const auto representative = weld_points(soup_.points, {});
    const bool fit_before = is_fit_unwelded(soup_, representative, tolerance_);
    result_.counts.collapsed += replace_points(soup_, representative);
    go_on("looking for faults", 0);
    leave_as_they_are();
    lint_.start(triangle_set(soup_.points), result_.triangulation.take_fresh());
    std::vector<PieceState> state = pieces_at_fault(soup_, result_.triangulation, lint_);
    result_.untouched = result_.counts.welded > 0
                            ? fit_before
                            : std::ranges::all_of(state, [](PieceState own) { return own == PieceState::Sound; });
    add_opposite_overlaps(soup_, result_.triangulation, lint_, state);
    group(state);
    return work(watch, {});
  }

  Conformer(std::unique_ptr<Complex> grouped, std::int64_t tolerance, const ConformProgress& progress)
      : tolerance_(tolerance), width_(grouped->tolerance()), lint_(tolerance), progress_(progress) {
    result_.complex = std::move(grouped);
  }

  // Every piece goes into the complex, whether something is wrong with it or not.
  Conformed run_steps(ConformSteps steps) {
    Stopwatch watch;
    if (!result_.complex) {
      std::vector<std::uint8_t> all(soup_.pieces.size(), 1);
      if (steps.group) {
        result_.counts.collapsed += replace_points(soup_, weld_points(soup_.points, {}));
        all.resize(soup_.pieces.size());
        if (go_on("finding planes", 0)) snap({}, all);
      }
      leave_as_they_are();
      load(all);
    }
    return work(watch, steps);
  }

  // `at_fault`: the pieces that an earlier attempt could not cure; nothing is wrong with the others.
  Conformed run_on(std::span<const PieceId> at_fault) {
    Stopwatch watch;
    goes_on_ = true;
    leave_as_they_are();
    lint_.trust(triangle_set(soup_.points), result_.triangulation.take_fresh());
    group(states_around(soup_, at_fault));
    return work(watch, {});
  }

 private:
  Conformed work(Stopwatch& watch, ConformSteps steps) {
    Normaliser normaliser(*result_.complex);
    const double weld = result_.complex->weld_distance();
    if (steps.group && go_on("inserting T-vertices", 0)) normaliser.run(weld);
    result_.counts.t_vertices = result_.complex->counts().splits;
    result_.timings.grouper = watch.lap();
    if (steps.cut) {
      cut_planes(normaliser, weld);
      residual_rounds(normaliser, weld);
    } else {
      result_.triangulation.update(*result_.complex);
      result_.sound = result_.triangulation.sound();
    }
    result_.counts.complex = result_.complex->counts();
    note_covered();
    result_.timings.isect = watch.lap();
    note_faults();
    return std::move(result_);
  }

  void note_faults() {
    if (result_.clean()) return;
    lint_.update_contacts(triangle_set(result_.complex->points()));  // not looked for as long as there was worse
    std::vector<std::uint32_t>& list = result_.at_fault;
    lint_.for_each_evidence([&](const Evidence& evidence) {
      list.push_back(evidence.violation.a);
      list.push_back(evidence.other);
    });
    const Triangulation& triangulation = result_.triangulation;
    for (ClusterId id = 0; id < triangulation.folded().size(); ++id) {
      if (!triangulation.folded()[id]) continue;
      const auto own = triangulation.of_cluster(id);
      list.insert(list.end(), own.begin(), own.end());
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  bool go_on(const char* step, std::size_t left) {
    if (!result_.interrupted && progress_ && !progress_(step, left)) result_.interrupted = true;
    return !result_.interrupted;
  }

  [[nodiscard]] TriangleSet triangle_set(std::span<const LatticePoint> points) const {
    const Triangulation& triangulation = result_.triangulation;
    return {points, triangulation.triangles(), triangulation.alive(), triangulation.folded()};
  }

  // `mask`: per point, whether it is looked at; empty where all are.
  std::vector<std::uint32_t> weld_points(const std::vector<LatticePoint>& points, std::span<const std::uint8_t> mask) {
    auto representative = weld(points, width_, mask);
    for (std::size_t i = 0; i < representative.size(); ++i) {
      const LatticePoint &from = points[i], &to = points[representative[i]];
      if (from == to) continue;
      ++result_.counts.welded;
      const double moved = glm::distance(geom::as_vector(from), geom::as_vector(to));
      result_.counts.largest_weld = std::max(result_.counts.largest_weld, moved);
    }
    return representative;
  }

  void leave_as_they_are() {
    for (PieceId id = 0; id < soup_.pieces.size(); ++id) {
      if (soup_.pieces[id].edge_count != 3) continue;
      const auto edges = soup_.edges_of(soup_.pieces[id]);
      result_.triangulation.add_as_it_is({edges[0][0], edges[1][0], edges[2][0]}, id);
    }
  }

  // What is at fault and what is around it goes into the complex.
  void group(const std::vector<PieceState>& state) {
    std::vector<std::uint8_t> taken(state.size());
    std::ranges::transform(state, taken.begin(), [](PieceState own) { return own != PieceState::Sound ? 1 : 0; });
    const std::vector<std::uint8_t> movable = points_at_fault(state);
    if (goes_on_) adopt(soup_.points, weld_points(soup_.points, movable), taken);
    if (go_on("finding planes", 0)) snap(movable, taken);
    load(taken);
  }

  [[nodiscard]] std::vector<std::uint8_t> points_at_fault(const std::vector<PieceState>& state) const {
    std::vector<std::uint8_t> at_fault(soup_.points.size(), 0);
    for (PieceId id = 0; id < state.size(); ++id) {
      if (state[id] != PieceState::AtFault) continue;
      for (const auto& edge : soup_.edges_of(soup_.pieces[id])) at_fault[edge[0]] = at_fault[edge[1]] = 1;
    }
    return at_fault;
  }

  static std::vector<PieceId> ids_of(std::span<const std::uint8_t> taken) {
    std::vector<PieceId> ids;
    for (PieceId id = 0; id < taken.size(); ++id) {
      if (taken[id]) ids.push_back(id);
    }
    return ids;
  }

  // Points of pieces at fault move onto their planes. Where any did the points are welded again.
  void snap(std::span<const std::uint8_t> movable, std::vector<std::uint8_t>& taken) {
    Soup part = part_of(soup_, ids_of(taken));
    const SnapCounts snapped = snap_to_planes(part, claim_planes(part, width_, width_), width_, movable);
    result_.counts.snapped = snapped;
    if (snapped.moved == 0) return;
    std::vector<std::uint8_t> in_use(soup_.points.size(), 0);
    for (const auto& edge : soup_.edges) in_use[edge[0]] = in_use[edge[1]] = 1;
    const auto representative = weld_points(part.points, goes_on_ ? movable : std::span<const std::uint8_t>(in_use));
    adopt(part.points, representative, taken);
  }

  // New places of points, and others that take the place of some. The pieces of every point that changed are taken.
  void adopt(std::vector<LatticePoint> points, std::span<const std::uint32_t> representative,
             std::vector<std::uint8_t>& taken) {
    for (PieceId id = 0; id < soup_.pieces.size(); ++id) {
      for (const auto& [from, to] : soup_.edges_of(soup_.pieces[id])) {
        if (representative[from] != from || points[from] != soup_.points[from]) taken[id] = 1;
      }
    }
    soup_.points = std::move(points);
    for (auto& [from, to] : soup_.edges) {
      from = representative[from];
      to = representative[to];
    }
  }

  void load(std::span<const std::uint8_t> taken) {
    result_.complex = std::make_unique<Complex>(width_);
    hold();
    loader_.emplace(soup_, taken, *result_.complex, result_.triangulation);
    std::vector<PieceId> pieces = ids_of(taken);
    const auto collapsed = [&](PieceId id) {
      const auto edges = soup_.edges_of(soup_.pieces[id]);
      return std::ranges::count_if(edges, [](const auto& edge) { return edge[0] != edge[1]; }) < 3 ||
             soup_.normal_of(soup_.pieces[id]) == dvec3(0, 0, 0);
    };
    result_.counts.collapsed += std::erase_if(pieces, collapsed);
    const Soup part = part_of(soup_, pieces);
    for (const SoupPiece& piece : soup_.pieces) result_.grouped_area += glm::length(soup_.normal_of(piece)) / 2;
    loader_->load(part, pieces, claim_planes(part, kKeepBand * width_, width_));
  }

  void hold() {
    if (!held_.all && held_.origins.empty()) {
      result_.complex->keep_near(soup_.origins, std::numeric_limits<double>::infinity());
      return;
    }
    std::vector<std::uint8_t> held;
    if (!held_.all) {
      held.resize(soup_.origins.size(), 0);
      for (const std::uint32_t origin : held_.origins) held[origin] = 1;
    }
    result_.complex->keep_near(soup_.origins, kFarthestDrawn * static_cast<double>(tolerance_), std::move(held));
  }

  void note_covered() {
    const Triangulation& triangulation = result_.triangulation;
    const auto pieces = result_.complex->pieces();
    for (const std::uint32_t i : triangulation.living()) {
      const Triangle& triangle = triangulation.triangles()[i];
      if (triangle.cluster == kNoCluster) continue;
      for (const PieceId id : triangulation.cover_of(triangle)) {
        if (id == triangle.winner || pieces[id].along != triangle.along) continue;
        const dvec3 a = result_.complex->place(triangle.points[0]), b = result_.complex->place(triangle.points[1]),
                    c = result_.complex->place(triangle.points[2]);
        result_.covered.push_back({pieces[triangle.winner].source, pieces[id].source,
                                   glm::length(glm::cross(b - a, c - a)) / 2, (a + b + c) / 3.0});
      }
    }
  }

  // One pass: more were measured to find hardly anything that the residual loop does not.
  void cut_planes(Normaliser& normaliser, double weld) {
    if (!go_on("cutting planes", 0)) return;
    result_.triangulation.update(*result_.complex);
    Isect(*result_.complex).pass(result_.triangulation);
    normaliser.run(weld);
  }

  // Pieces left as they are that changes reached, or that something new is wrong with, join the complex.
  bool load_what_changes_reach(Normaliser& normaliser) {
    bool any = false;
    while (loader_ && loader_->follow_changes()) {
      normaliser.run(result_.complex->weld_distance());
      any = true;
    }
    return any;
  }

  bool load_what_is_at_fault() {
    bool any = false;
    std::vector<PieceId> pieces;
    lint_.for_each_evidence([&](const Evidence& evidence) {
      for (const std::uint32_t i : {evidence.violation.a, evidence.other}) {
        const Triangle& triangle = result_.triangulation.triangles()[i];
        if (triangle.cluster == kNoCluster) pieces.push_back(triangle.winner);
      }
    });
    std::sort(pieces.begin(), pieces.end());
    for (const PieceId piece : pieces) any |= loader_->load(piece);
    return any;
  }

  void judge(Normaliser& normaliser) {
    do {
      load_what_changes_reach(normaliser);
      Triangulation& triangulation = result_.triangulation;
      triangulation.update(*result_.complex);
      const TriangleSet set = triangle_set(result_.complex->points());
      lint_.update(set, triangulation.take_fresh());
      result_.violations = lint_.violations(set);
      result_.sound = triangulation.sound();
      if (!result_.sound || result_.violations.size() > kFewViolations) continue;
      lint_.update_contacts(set);
      std::vector<Violation> all;
      std::ranges::set_union(result_.violations, lint_.contacts(), std::back_inserter(all));
      result_.violations = std::move(all);
    } while (load_what_is_at_fault() && normalised(normaliser));
  }

  bool normalised(Normaliser& normaliser) {
    normaliser.run(result_.complex->weld_distance());
    return true;
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
    judge(normaliser);
    for (std::size_t round = 0; round < kResidualRounds && !result_.clean(); ++round) {
      if (!go_on("curing what is left", result_.violations.size())) break;
      const std::size_t widenings = std::min(round / kWidenEvery, kMostWidenings);
      const double reach = weld * (1 + kWidening * static_cast<double>(widenings));
      const bool merge = round > 0 && round % kMergeEvery == 0;
      if (!cure(residual, reach, merge) && !merge) break;
      normaliser.run(reach);
      judge(normaliser);
      result_.counts.residual_rounds = round + 1;
    }
    result_.counts.residual = residual.counts();
  }

  std::int64_t tolerance_;
  double width_;
  Held held_;
  bool goes_on_ = false;  ///< with what an earlier attempt left
  TriangleLint lint_;
  Soup soup_;  ///< welded
  std::optional<PieceLoader> loader_;
  const ConformProgress& progress_;
  Conformed result_;
};

}  // namespace

Conformed conform(Soup soup, std::int64_t tolerance, double scale, const Held& held, const ConformProgress& progress) {
  return Conformer(std::move(soup), tolerance, scale, held, progress).run();
}

Conformed conform(Soup soup, std::int64_t tolerance, const ConformProgress& progress, ConformSteps steps) {
  return Conformer(std::move(soup), tolerance, 1, {}, progress).run_steps(steps);
}

Conformed cut(std::unique_ptr<Complex> grouped, std::int64_t tolerance, const ConformProgress& progress) {
  return Conformer(std::move(grouped), tolerance, progress).run_steps({.group = false, .cut = true});
}

Conformed conform_rest(const Conformed& attempt, std::int64_t tolerance, double scale, const Held& held,
                       const ConformProgress& progress) {
  Soup soup;
  const Complex& complex = *attempt.complex;
  soup.points.assign(complex.points().begin(), complex.points().end());
  soup.origins = complex.origins();
  std::vector<PieceId> at_fault;
  for (const std::uint32_t i : attempt.triangulation.living()) {
    const Triangle& triangle = attempt.triangulation.triangles()[i];
    const Piece& piece = complex.pieces()[triangle.winner];
    if (std::ranges::binary_search(attempt.at_fault, i)) at_fault.push_back(static_cast<PieceId>(soup.pieces.size()));
    soup.pieces.push_back({static_cast<std::uint32_t>(soup.edges.size()), 3, piece.source, piece.rank,
                           piece.won || attempt.triangulation.hides_others(complex, triangle), piece.origin});
    for (std::size_t k = 0; k < 3; ++k) soup.edges.push_back({triangle.points[k], triangle.points[(k + 1) % 3]});
  }
  Conformed next = Conformer(std::move(soup), tolerance, scale, held, progress).run_on(at_fault);
  ConformCounts counts = attempt.counts;
  counts += next.counts;
  next.counts = counts;
  next.covered.insert(next.covered.begin(), attempt.covered.begin(), attempt.covered.end());
  next.grouped_area = attempt.grouped_area;
  next.timings += attempt.timings;
  return next;
}

}  // namespace rad::repair
