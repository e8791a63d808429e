#include "repair/repair.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "repair/conform.h"
#include "repair/fitness.h"
#include "repair/input_soup.h"
#include "repair/maximal_faces.h"
#include "repair/orientation.h"
#include "scene/repaired_scene.h"

namespace rad::repair {
namespace {

// Where the work at T does not end clean it starts again from the input at a little more, while lint stays at T.
constexpr std::array kScales{1.0, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4};
// Where this many scales in a row leave no less, the rest are not tried.
constexpr int kAttemptsInVain = 2;
// Turning faces of the result may make two of them overlap: then it is repaired once more.
constexpr int kPasses = 3;

PlanarTriangles planar_triangles(const Conformed& conformed) {
  const Complex& complex = *conformed.complex;
  PlanarTriangles set;
  set.points.assign(complex.points().begin(), complex.points().end());
  for (const Cluster& cluster : complex.clusters()) set.planes.push_back(cluster.plane);
  for (const Triangle& triangle : conformed.triangulation.triangles()) {
    set.members.push_back(
        {triangle.points, triangle.cluster, triangle.along, complex.pieces()[triangle.winner].source});
  }
  return set;
}

// One face for each triangle, in order, with what its source face has of names and materials.
scene::Scene scene_of(const PlanarTriangles& set, const scene::Scene& origin, const validate::Context& context) {
  scene::Scene scene = scene::without_geometry(origin);
  scene.recorded = scene::RecordedLattice{context.model.lattice, context.tolerance.length};
  for (const LatticePoint& point : set.points) scene.vertices.push_back(context.model.lattice.position(point));
  for (const auto& member : set.members) {
    scene::Face face = origin.faces[member.source];
    face.first_loop = static_cast<std::uint32_t>(scene.loops.size());
    face.loop_count = 1;
    scene.faces.push_back(face);
    scene.loops.push_back({static_cast<std::uint32_t>(scene.corners.size()), 3});
    scene.corners.insert(scene.corners.end(), member.points.begin(), member.points.end());
  }
  return scene;
}

void turn(PlanarTriangles& set, const std::vector<scene::FaceId>& faces) {
  for (const scene::FaceId face : faces) {
    std::swap(set.members[face].points[1], set.members[face].points[2]);
    set.members[face].along = !set.members[face].along;
  }
}

class Repairer {
 public:
  Repairer(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options)
      : input_(scene), scene_(scene), issues_(issues), options_(options), tolerance_(options.tolerance) {}

  Repaired run() {
    // Faces are turned and cut here; what their corners have is looked up in the input.
    scene_.attributes = {};
    if (!fix_tolerance()) return std::move(result_);
    if (options_.as_it_is) {
      result_.untouched = take_as_it_is();
      return std::move(result_);
    }
    const std::vector<scene::FaceId> turned_faces = orient(scene_, issues_, tolerance_);
    record("orient", "turn-face", turned_faces.size(), 0);
    lap("orient");
    if (take_as_it_is()) {
      result_.untouched = turned_faces.empty();
      return std::move(result_);
    }
    lap("grouper");
    for (int pass = 0; pass < kPasses && !result_.interrupted; ++pass) {
      if (repair_once()) break;
    }
    return std::move(result_);
  }

 private:
  std::optional<validate::Context> context_of(const scene::Scene& scene) {
    return validate::build_context(scene, issues_, tolerance_, result_.refusal);
  }

  // A share of the diagonal must not change its meaning when points move. False where T is refused.
  bool fix_tolerance() {
    const auto context = context_of(scene_);
    if (context && tolerance_) {
      tolerance_ = {context->tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
    }
    return context.has_value();
  }

  bool take_as_it_is() {
    const auto context = context_of(scene_);
    const PlanarTriangles set = repair::planar_triangles(*context);
    if (!options_.as_it_is && !is_fit(scene_, set, *context)) return false;
    result_.model = maximal_faces(set, input_, context->model.lattice, context->tolerance);
    return true;
  }

  void lap(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    add_time(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

  void add_time(const char* stage, double seconds) {
    const auto found = std::ranges::find(result_.timings, stage, &std::pair<std::string, double>::first);
    if (found == result_.timings.end()) {
      result_.timings.emplace_back(stage, seconds);
    } else {
      found->second += seconds;
    }
  }

  void record(const char* stage, const char* operation, std::size_t count, double movement) {
    if (count > 0) result_.ledger.push_back({stage, operation, count, movement});
  }

  bool is_fit(const scene::Scene& scene, const PlanarTriangles& set, const validate::Context& context) {
    const auto crosses = [](validate::FaceCondition condition) {
      return condition == validate::FaceCondition::RingCrosses;
    };
    return std::ranges::none_of(context.triangles.condition, crosses) &&
           violations_of(set, context.tolerance.pitches).empty() && broken_rules(scene, issues_, tolerance_) == 0;
  }

  // The first scale that ends clean, or the one that leaves the least.
  Conformed conform_at_some_scale(const validate::Context& context) {
    const Soup soup = input_soup(context);
    std::optional<Conformed> best;
    int in_vain = 0;
    for (const double scale : kScales) {
      Conformed attempt = conform(soup, context.tolerance.pitches, scale, options_.progress);
      add_time("grouper", attempt.timings.grouper);
      add_time("isect", attempt.timings.isect);
      const bool better = !best || attempt.clean() ||
                          (attempt.sound >= best->sound && attempt.violations.size() < best->violations.size());
      if (better) best = std::move(attempt);
      in_vain = better ? 0 : in_vain + 1;
      if (best->clean() || best->interrupted || in_vain == kAttemptsInVain) break;
    }
    result_.interrupted = best->interrupted;
    return std::move(*best);
  }

  void record_all(const ConformCounts& counts, double pitch) {
    record("grouper", "weld", counts.welded, counts.largest_weld * pitch);
    record("grouper", "snap-to-plane", counts.snapped.moved, counts.snapped.largest * pitch);
    record("grouper", "drop-collapsed", counts.collapsed, 0);
    record("grouper", "insert-t-vertex", counts.t_vertices, 0);
    record("isect", "add-point", counts.complex.new_points, 0);
    record("isect", "split-edge", counts.complex.splits - counts.t_vertices, 0);
    record("isect", "imprint", counts.complex.imprints, 0);
    record("isect", "merge-points", counts.complex.merges, counts.complex.largest_merge * pitch);
    record("isect", "add-steiner-point", counts.residual.steiner_points, 0);
    record("coplanar", "move-to-plane", counts.residual.rehomed, 0);
  }

  void record_coplanar(const Conformed& conformed) {
    std::size_t covered = 0;
    for (const Triangle& triangle : conformed.triangulation.triangles()) {
      const auto& cover = conformed.triangulation.cover_of(triangle);
      const auto same = std::ranges::count_if(
          cover, [&](PieceId id) { return conformed.complex->pieces()[id].along == triangle.along; });
      covered += static_cast<std::size_t>(same - 1);
    }
    record("coplanar", "remove-covered-cell", covered, 0);
  }

  // True where nothing is left to do, or nothing more can be done. Of several passes the one that leaves the least
  // counts.
  bool repair_once() {
    const auto context = context_of(scene_);
    const Conformed conformed = conform_at_some_scale(*context);
    last_ = std::chrono::steady_clock::now();
    record_all(conformed.counts, context->model.lattice.pitch);
    record_coplanar(conformed);
    PlanarTriangles set = planar_triangles(conformed);
    name_sources(set);
    scene::Scene triangles = scene_of(set, input_, *context);
    lap("coplanar");
    const std::vector<scene::FaceId> turned_faces = orient(triangles, {}, tolerance_);
    turn(set, turned_faces);
    record("orient", "turn-face", turned_faces.size(), 0);
    lap("orient");
    const std::size_t left =
        violations_of(set, context->tolerance.pitches).size() + broken_rules(triangles, {}, tolerance_);
    if (result_.model.faces.empty() || left < result_.unresolved) {
      result_.unresolved = left;
      result_.model = maximal_faces(set, input_, context->model.lattice, context->tolerance);
    }
    lap("coplanar");
    if (left == 0 || turned_faces.empty()) return true;
    go_on_with(std::move(triangles), set);
    return false;
  }

  // Triangles name the face of the input, through those of the passes before.
  void name_sources(PlanarTriangles& set) const {
    if (origin_.empty()) return;
    for (auto& member : set.members) member.source = origin_[member.source];
  }

  void go_on_with(scene::Scene triangles, const PlanarTriangles& set) {
    origin_.clear();
    for (const auto& member : set.members) origin_.push_back(member.source);
    scene_ = std::move(triangles);
  }

  const scene::Scene& input_;
  scene::Scene scene_;
  std::vector<scene::FaceId> origin_;  ///< per face of scene_; empty while that is the input
  const scene::ReadIssues& issues_;
  const RepairOptions& options_;
  std::optional<geom::ToleranceRequest> tolerance_;
  Repaired result_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Repaired repair(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options) {
  return Repairer(scene, issues, options).run();
}

}  // namespace rad::repair
