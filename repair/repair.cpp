#include "repair/repair.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "repair/conform.h"
#include "repair/covered_triangles.h"
#include "repair/fitness.h"
#include "repair/input_soup.h"
#include "repair/maximal_faces.h"
#include "repair/orientation.h"
#include "repair/stage_exchange.h"
#include "repair/work_log.h"
#include "scene/stage_record.h"

namespace rad::repair {
namespace {

using scene::Filter;

// Where the work at T does not end clean it starts again from the input at a little more, while lint stays at T.
constexpr std::array kScales{1.0, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4};
// Where this many scales in a row leave no less, the rest are not tried.
constexpr int kAttemptsInVain = 2;
// Turning faces of the result may make two of them overlap: then it is repaired once more.
constexpr int kPasses = 3;

constexpr const char* kNotConforming =
    "coplanar works on faces that are cut where they meet, and edges of one plane cross in this model: run grouper and "
    "isect before it";

double area_of(const Soup& soup) {
  double twice = 0;
  for (const SoupPiece& piece : soup.pieces) twice += glm::length(soup.normal_of(piece));
  return twice / 2;
}

class Repairer {
 public:
  Repairer(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options)
      : input_(scene), scene_(scene), issues_(issues), options_(options), tolerance_(options.tolerance) {}

  Repaired run() {
    if (fix_tolerance()) run_filters();
    result_.ledger = std::move(log_.ledger);
    result_.timings = std::move(log_.timings);
    if (result_.stage) sign_stage();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool asked(Filter filter) const { return options_.filters.has(filter); }
  [[nodiscard]] bool asked_for_all() const {
    return options_.filters.common(scene::kRepairFilters) == scene::kRepairFilters;
  }
  [[nodiscard]] bool asked_to_cut() const {
    return asked(Filter::Grouper) || asked(Filter::Isect) || asked(Filter::Coplanar);
  }

  void run_filters() {
    if (input_.stage && !input_.stage->planes.empty() && go_on_from_stage()) return;
    if (options_.filters.common(scene::kRepairFilters).empty()) return keep_as_it_is();
    const std::size_t turned = turn_input();
    if (!asked_to_cut()) return keep_turned(turned);
    if (take_if_fit()) {
      result_.untouched = turned == 0;
      if (turned > 0) result_.turned = scene_;
      return;
    }
    log_.lap("grouper");
    if (!asked_for_all()) return run_some();
    for (int pass = 0; pass < kPasses && !result_.interrupted; ++pass) {
      if (repair_once()) break;
    }
  }

  std::optional<validate::Context> context_of(const scene::Scene& scene) {
    return validate::build_context(scene, issues_, tolerance_, result_.refusal);
  }

  // A share of the diagonal must not change its meaning when points move. False where T is refused.
  bool fix_tolerance() {
    const auto context = context_of(scene_);
    if (!context) return false;
    if (tolerance_) tolerance_ = {context->tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
    lattice_ = context->model.lattice;
    used_ = context->tolerance;
    return true;
  }

  void keep_as_it_is() {
    result_.untouched = true;
    take(*context_of(scene_));
  }

  void keep_turned(std::size_t turned) {
    result_.untouched = turned == 0;
    take(*context_of(scene_));
    if (turned > 0) result_.turned = scene_;
  }

  std::size_t turn_input() {
    if (!asked(Filter::Orient)) return 0;
    const std::vector<scene::FaceId> turned_faces = orient(scene_, issues_, tolerance_);
    log_.record("orient", "turn-face", turned_faces.size(), 0, 0.0);
    log_.lap("orient");
    return turned_faces.size();
  }

  bool take_if_fit() {
    const auto context = context_of(scene_);
    const PlanarTriangles set = repair::planar_triangles(*context);
    if (!is_fit(set, *context)) return false;
    take(*context);
    return true;
  }

  void take(const validate::Context& context) {
    const PlanarTriangles set = repair::planar_triangles(context);
    result_.model = maximal_faces(set, scene_, context.model.lattice, context.tolerance);
    if (options_.stage) result_.stage = stage_scene(scene_, recorded());
  }

  bool is_fit(const PlanarTriangles& set, const validate::Context& context) {
    const auto crosses = [](validate::FaceCondition condition) {
      return condition == validate::FaceCondition::RingCrosses;
    };
    return std::ranges::none_of(context.triangles.condition, crosses) &&
           violations_of(set, context.tolerance.pitches).empty() && broken_rules(scene_, issues_, tolerance_) == 0;
  }

  [[nodiscard]] scene::RecordedLattice recorded() const { return {lattice_, used_.length}; }

  void note_area(const char* stage, double square_pitches) {
    result_.areas.push_back({stage, square_pitches * lattice_.pitch * lattice_.pitch});
  }

  // The first scale that ends clean, or the one that leaves the least.
  Conformed conform_at_some_scale(const Soup& soup) {
    std::optional<Conformed> best;
    int in_vain = 0;
    for (const double scale : kScales) {
      Conformed attempt = conform(soup, used_.pitches, scale, options_.progress);
      add_times(attempt.timings);
      const bool better = !best || attempt.clean() ||
                          (attempt.sound >= best->sound && attempt.violations.size() < best->violations.size());
      if (better) best = std::move(attempt);
      in_vain = better ? 0 : in_vain + 1;
      if (best->clean() || best->interrupted || in_vain == kAttemptsInVain) break;
    }
    return std::move(*best);
  }

  void add_times(const ConformTimings& timings) {
    log_.add_time("grouper", timings.grouper);
    log_.add_time("isect", timings.isect);
  }

  void record(const Conformed& conformed) {
    result_.interrupted = conformed.interrupted;
    log_.restart();
    log_.record(conformed.counts, lattice_.pitch);
  }

  PlanarTriangles resolved(const Conformed& conformed) {
    const Covered covered = covered_cells(conformed);
    PlanarTriangles set = repair::planar_triangles(conformed, scene_, Overlaps::Resolved);
    const double square = lattice_.pitch * lattice_.pitch;
    log_.record("coplanar", "remove-covered-cell", covered.cells, 0, -covered.area * square);
    note_area("isect", repair::area_of(set) + covered.area);
    note_area("coplanar", repair::area_of(set));
    return set;
  }

  // True where nothing is left to do, or nothing more can be done. Of several passes the one that leaves the least
  // counts.
  bool repair_once() {
    result_.areas.clear();
    const auto context = context_of(scene_);
    lattice_ = context->model.lattice;
    used_ = context->tolerance;
    const Soup soup = input_soup(*context);
    note_area("input", area_of(soup));
    const Conformed conformed = conform_at_some_scale(soup);
    note_area("grouper", area_of(conformed.welded));
    record(conformed);
    PlanarTriangles set = resolved(conformed);
    scene::Scene triangles = scene_of(set, scene_, lattice_, used_.length);
    log_.lap("coplanar");
    const std::size_t turned_triangles = turn_triangles(set, triangles);
    const std::size_t left = violations_of(set, used_.pitches).size() + broken_rules(triangles, {}, tolerance_);
    if (result_.model.faces.empty() || left < result_.unresolved) {
      result_.unresolved = left;
      put_together(set);
    }
    log_.lap("coplanar");
    if (left == 0 || turned_triangles == 0) return true;
    go_on_with(std::move(triangles), set);
    return false;
  }

  std::size_t turn_triangles(PlanarTriangles& set, scene::Scene& triangles) {
    const std::vector<scene::FaceId> turned_triangles = orient(triangles, {}, tolerance_);
    turn(set, turned_triangles);
    log_.record("orient", "turn-face", turned_triangles.size(), 0, 0.0);
    log_.lap("orient");
    return turned_triangles.size();
  }

  void put_together(const PlanarTriangles& set) {
    result_.model = maximal_faces(set, scene_, lattice_, used_);
    name_sources();
    if (options_.stage) result_.stage = stage_scene(result_.model, set, input_);
  }

  // Some of the filters, at T itself and once: what is not clean after them is for those that follow.
  void run_some() {
    const Soup soup = input_soup(*context_of(scene_));
    note_area("input", area_of(soup));
    const ConformSteps steps{asked(Filter::Grouper), asked(Filter::Isect)};
    Conformed conformed = conform(soup, used_.pitches, 1, options_.progress, steps);
    add_times(conformed.timings);
    note_area("grouper", area_of(conformed.welded));
    finish(conformed);
  }

  void finish(const Conformed& conformed) {
    if (asked(Filter::Coplanar) && !asked(Filter::Isect) && !conformed.triangulation.sound()) {
      result_.impossible = kNotConforming;
      return;
    }
    record(conformed);
    result_.unresolved = conformed.violations.size();
    const bool resolves = asked(Filter::Coplanar);
    PlanarTriangles set = resolves ? resolved(conformed) : repair::planar_triangles(conformed, scene_, Overlaps::Kept);
    log_.lap("coplanar");
    if (asked(Filter::Orient) && resolves) turn_result(set);
    result_.model = maximal_faces(set, scene_, lattice_, used_);
    if (!options_.stage) return;
    result_.stage = resolves ? stage_scene(result_.model, set, scene_) : stage_scene(conformed, scene_, recorded());
  }

  void turn_result(PlanarTriangles& set) {
    scene::Scene triangles = scene_of(set, scene_, lattice_, used_.length);
    turn_triangles(set, triangles);
  }

  // Whether a stage file holds what the filters asked for go on from, at the tolerance that it was made at.
  bool go_on_from_stage() {
    const scene::StageRecord& record = *input_.stage;
    const bool same_lattice = input_.recorded && input_.recorded->lattice.pitch == lattice_.pitch &&
                              input_.recorded->lattice.origin == lattice_.origin &&
                              input_.recorded->tolerance == used_.length;
    if (!same_lattice || asked(Filter::Grouper)) return forget_planes();
    if (record.overlaps_resolved) return asked_to_cut() ? forget_planes() : orient_stage();
    if (!asked_to_cut()) return forget_planes();
    log_.restart();
    auto complex = complex_of(scene_);
    Conformed conformed;
    if (asked(Filter::Isect)) {
      conformed = cut(std::move(complex), used_.pitches, options_.progress);
    } else {
      conformed.complex = std::move(complex);
      conformed.triangulation.update(*conformed.complex);
    }
    add_times(conformed.timings);
    finish(conformed);
    return true;
  }

  bool orient_stage() {
    PlanarTriangles set = triangles_of(scene_);
    if (asked(Filter::Orient)) turn_result(set);
    result_.model = maximal_faces(set, scene_, lattice_, used_);
    if (options_.stage) result_.stage = stage_scene(result_.model, set, scene_);
    return true;
  }

  void sign_stage() {
    auto record = std::make_shared<scene::StageRecord>(*result_.stage->stage);
    for (const Filter filter : scene::kFilters) {
      if (scene::kRepairFilters.has(filter) && asked(filter)) record->stage = name(filter);
    }
    if (input_.stage) record->ledger = input_.stage->ledger;
    record->ledger.insert(record->ledger.end(), result_.ledger.begin(), result_.ledger.end());
    result_.stage->stage = std::move(record);
  }

  // The planes are no longer those of the faces once anything else is done; where the faces came from stays true.
  bool forget_planes() {
    auto record = std::make_shared<scene::StageRecord>();
    record->faces = input_.stage->faces;
    record->face_of = input_.stage->face_of;
    scene_.stage = std::move(record);
    return false;
  }

  // Faces of the result name the face of the input, through those of the passes before.
  void name_sources() {
    if (origin_.empty()) return;
    for (scene::ConformingFace& face : result_.model.faces) face.source = origin_[face.source].source;
    for (scene::TriangleOrigin& origin : result_.model.origins) {
      const scene::TriangleOrigin& before = origin_[origin.source];
      origin = {before.source, origin.won || before.won};
    }
  }

  void go_on_with(scene::Scene triangles, const PlanarTriangles& set) {
    std::vector<scene::TriangleOrigin> origin;
    origin.reserve(set.members.size());
    for (const auto& member : set.members) {
      if (origin_.empty()) {
        origin.push_back({member.source, member.won});
      } else {
        origin.push_back({origin_[member.source].source, member.won || origin_[member.source].won});
      }
    }
    origin_ = std::move(origin);
    scene_ = std::move(triangles);
  }

  const scene::Scene& input_;
  scene::Scene scene_;
  std::vector<scene::TriangleOrigin> origin_;  ///< per face of scene_; empty while that is the input
  const scene::ReadIssues& issues_;
  const RepairOptions& options_;
  std::optional<geom::ToleranceRequest> tolerance_;
  geom::Lattice lattice_;
  geom::Tolerance used_;
  WorkLog log_;
  Repaired result_;
};

}  // namespace

Repaired repair(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options) {
  return Repairer(scene, issues, options).run();
}

}  // namespace rad::repair
