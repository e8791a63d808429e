#include "repair/repair.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "repair/coplanar_log.h"
#include "repair/covered_triangles.h"
#include "repair/fitness.h"
#include "repair/input_soup.h"
#include "repair/ladder.h"
#include "repair/losses.h"
#include "repair/maximal_faces.h"
#include "repair/orientation.h"
#include "repair/stage_exchange.h"
#include "repair/work_log.h"
#include "scene/stage_record.h"

namespace rad::repair {
namespace {

using scene::Filter;

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
    // Faces are turned and cut here; what their corners have is looked up in the input.
    scene_.attributes = {};
    if (fix_tolerance()) run_filters();
    account();
    result_.ledger = std::move(log_.ledger);
    result_.timings = std::move(log_.timings);
    result_.cpu_timings = std::move(log_.cpu_timings);
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
    const std::vector<scene::FaceId> turned_faces = turn_input();
    if (!asked_to_cut()) return keep_turned(turned_faces);
    if (!asked_for_all()) {
      if (!take_if_fit(turned_faces)) run_some();
      return;
    }
    for (int pass = 0; pass < kPasses && !result_.interrupted; ++pass) {
      if (repair_once(turned_faces)) break;
    }
  }

  // Built once for what scene_ holds.
  const validate::Context& context_of_scene() {
    if (!context_) context_.emplace(std::move(*context_of(scene_)));
    return *context_;
  }

  std::optional<validate::Context> context_of(const scene::Scene& scene) {
    return validate::build_context(scene, issues_, tolerance_, result_.refusal);
  }

  // A share of the diagonal must not change its meaning when points move. False where T is refused.
  bool fix_tolerance() {
    const scene::LatticeModel model = scene::build_lattice_model(scene_);
    const auto chosen = validate::chosen_tolerance(scene_, model, tolerance_, result_.refusal);
    if (!chosen) return false;
    if (tolerance_) tolerance_ = {chosen->length, geom::ToleranceRequest::Measure::FileUnits};
    lattice_ = model.lattice;
    used_ = *chosen;
    return true;
  }

  void keep_as_it_is() {
    result_.untouched = true;
    take(context_of_scene());
  }

  void keep_turned(const std::vector<scene::FaceId>& turned_faces) {
    result_.untouched = turned_faces.empty();
    take(context_of_scene());
    if (!turned_faces.empty()) result_.turned = turned(input_, turned_faces);
  }

  std::vector<scene::FaceId> turn_input() {
    if (!asked(Filter::Orient)) return {};
    Oriented oriented = orient(scene_, issues_, tolerance_);
    if (oriented.context) context_.emplace(std::move(*oriented.context));
    log_.record("orient", "turn-face", oriented.turned.size(), 0, 0.0);
    log_.lap("orient");
    return std::move(oriented.turned);
  }

  bool take_if_fit(const std::vector<scene::FaceId>& turned_faces) {
    const validate::Context& context = context_of_scene();
    const PlanarTriangles set = repair::planar_triangles(context);
    if (!is_fit(set, context)) return false;
    keep_turned(turned_faces);
    return true;
  }

  void take(const validate::Context& context) {
    const PlanarTriangles set = repair::planar_triangles(context);
    result_.model = maximal_faces(set, input_, context.model.lattice, context.tolerance);
    if (options_.stage) result_.stage = stage_scene(scene_, recorded());
  }

  bool is_fit(const PlanarTriangles& set, const validate::Context& context) {
    const auto crosses = [](validate::FaceCondition condition) {
      return condition == validate::FaceCondition::RingCrosses;
    };
    return std::ranges::none_of(context.triangles.condition, crosses) &&
           violations_of(set, context.tolerance.pitches).empty() && broken_rules(context) == 0;
  }

  [[nodiscard]] scene::RecordedLattice recorded() const { return {lattice_, used_.length}; }

  void note_area(const char* stage, double square_pitches) {
    result_.areas.push_back({stage, square_pitches * lattice_.pitch * lattice_.pitch});
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
    if (order_) covered_.add(conformed.covered, *order_, faces_of_input());  // a stage file holds no reasons
    double covered = 0;
    for (const CoveredCell& cell : conformed.covered) covered += cell.area;
    PlanarTriangles set = repair::planar_triangles(conformed, scene_, Overlaps::Resolved, used_.pitches);
    const double square = lattice_.pitch * lattice_.pitch;
    log_.record("coplanar", "remove-covered-cell", conformed.covered.size(), 0, -covered * square);
    note_area("isect", repair::area_of(set) + covered);
    note_area("coplanar", repair::area_of(set));
    return set;
  }

  /// Per face of scene_ the face of the input; empty while they are the same.
  [[nodiscard]] std::vector<scene::FaceId> faces_of_input() const {
    std::vector<scene::FaceId> faces;
    for (const scene::TriangleOrigin& origin : origin_) faces.push_back(origin.source);
    return faces;
  }

  // The surfaces of the input decide in every pass, not what the passes before have cut out of them.
  Soup soup_of(const validate::Context& context) {
    if (!order_) order_.emplace(context, options_.coplanar);
    if (origin_.empty()) return input_soup(context, order_->ranks());
    std::vector<std::uint32_t> ranks;
    for (const scene::TriangleOrigin& origin : origin_) ranks.push_back(order_->ranks()[origin.source]);
    return input_soup(context, ranks);
  }

  // What was removed and lost, held against the input. Where faces were only turned nothing was.
  void account() {
    if (!remains_) return;
    // After a single pass scene_ is still the input, but for faces that were turned.
    if (!origin_.empty()) context_.reset();
    if (!context_) context_.emplace(std::move(*context_of(origin_.empty() ? scene_ : input_)));
    result_.removals = covered_.removals(input_, lattice_);
    const scene::Ledger lost = losses(*context_, *remains_, covered_);
    log_.ledger.insert(log_.ledger.end(), lost.begin(), lost.end());
  }

  // True where nothing is left to do, or nothing more can be done. Of several passes the one that leaves the least
  // counts.
  bool repair_once(const std::vector<scene::FaceId>& turned_before) {
    result_.areas.clear();
    const validate::Context& context = context_of_scene();
    lattice_ = context.model.lattice;
    used_ = context.tolerance;
    const Soup soup = soup_of(context);
    log_.lap("grouper");
    note_area("input", area_of(soup));
    const Conformed conformed = climb(soup, used_.pitches, options_.progress);
    if (conformed.untouched && origin_.empty() && broken_rules(context) == 0) {
      result_.areas.clear();
      keep_turned(turned_before);
      return true;
    }
    add_times(conformed.timings);
    note_area("grouper", conformed.grouped_area);
    record(conformed);
    PlanarTriangles set = resolved(conformed);
    name_sources(set);
    scene::Scene triangles = scene_of(set, input_, lattice_, used_.length);
    log_.lap("coplanar");
    const Oriented oriented = turn_triangles(set, triangles);
    // Turned faces may lie on others of the same facing now; nothing else has changed since the last lint.
    std::size_t left = conformed.violations.size() + conformed.drift.places;
    if (!oriented.turned.empty()) left = left_after(conformed, set, oriented) + conformed.drift.places;
    if (result_.model.faces.empty() || left < result_.unresolved) {
      result_.unresolved = left;
      result_.drifted = conformed.drift.places;
      result_.drifted_at = lattice_.origin + lattice_.pitch * conformed.drift.first;
      put_together(set);
    }
    log_.lap("coplanar");
    if (left == 0 || oriented.turned.empty()) return true;
    go_on_with(std::move(triangles), set);
    return false;
  }

  [[nodiscard]] std::size_t left_after(const Conformed& conformed, const PlanarTriangles& set,
                                       const Oriented& oriented) const {
    const std::vector<Violation> violations =
        conformed.clean() ? violations_of(set, used_.pitches, oriented.turned) : violations_of(set, used_.pitches);
    return violations.size() + broken_rules(*oriented.context);
  }

  Oriented turn_triangles(PlanarTriangles& set, scene::Scene& triangles) {
    Oriented oriented = orient(triangles, no_issues_, tolerance_);
    turn(set, oriented.turned);
    log_.record("orient", "turn-face", oriented.turned.size(), 0, 0.0);
    log_.lap("orient");
    return oriented;
  }

  void put_together(const PlanarTriangles& set) {
    result_.model = maximal_faces(set, input_, lattice_, used_);
    remains_.emplace(set, input_.faces.size());
    if (options_.stage) result_.stage = stage_scene(result_.model, set, input_);
  }

  // Some of the filters, at T itself and once: what is not clean after them is for those that follow.
  void run_some() {
    const Soup soup = soup_of(context_of_scene());
    note_area("input", area_of(soup));
    const ConformSteps steps{asked(Filter::Grouper), asked(Filter::Isect)};
    Conformed conformed = conform(soup, used_.pitches, options_.progress, steps);
    add_times(conformed.timings);
    note_area("grouper", conformed.grouped_area);
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
    PlanarTriangles set =
        resolves ? resolved(conformed) : repair::planar_triangles(conformed, scene_, Overlaps::Kept, used_.pitches);
    log_.lap("coplanar");
    if (asked(Filter::Orient) && resolves) turn_result(set);
    result_.model = maximal_faces(set, input_, lattice_, used_);
    if (order_) remains_.emplace(set, input_.faces.size());
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
    result_.model = maximal_faces(set, input_, lattice_, used_);
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

  // Triangles name the face of the input, through those of the passes before.
  void name_sources(PlanarTriangles& set) const {
    if (origin_.empty()) return;
    for (PlanarTriangles::Member& member : set.members) {
      const scene::TriangleOrigin& before = origin_[member.source];
      member.source = before.source;
      member.won = member.won || before.won;
    }
  }

  void go_on_with(scene::Scene triangles, const PlanarTriangles& set) {
    origin_.clear();
    for (const PlanarTriangles::Member& member : set.members) origin_.push_back({member.source, member.won});
    context_.reset();
    scene_ = std::move(triangles);
  }

  const scene::Scene& input_;
  scene::Scene scene_;
  std::vector<scene::TriangleOrigin> origin_;  ///< per face of scene_; empty while that is the input
  const scene::ReadIssues& issues_;
  const scene::ReadIssues no_issues_;
  const RepairOptions& options_;
  std::optional<geom::ToleranceRequest> tolerance_;
  std::optional<validate::Context> context_;  ///< of scene_
  std::optional<SurfaceOrder> order_;
  CoplanarLog covered_;
  std::optional<Remains> remains_;
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
