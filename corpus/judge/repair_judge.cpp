#include "corpus/judge/repair_judge.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "corpus/judge/exact_lint.h"
#include "corpus/judge/fidelity.h"
#include "corpus/judge/glb_bytes.h"
#include "corpus/judge/scene_variants.h"
#include "repair/repair.h"
#include "scene/repaired_scene.h"
#include "validate/context.h"
#include "validate/lint.h"

namespace rad::corpus {
namespace {

using repair::Repaired;
using scene::Scene;

// docs/repair.md, in T.
constexpr double kMovementBound = 4, kMergeBound = 8, kFidelityBound = 8;
constexpr double kDepth = 1;  // half of 2 T, below which a part may close to a line
// Bounds hold for the numbers of the lattice; a millionth of T is for the rounding of measures here.
constexpr double kRounding = 1e-6;
// Repair proves distances at 0.99 T (kContactShare); the exact lint asks a little below, for it rounds.
constexpr double kExactShare = 0.98;

geom::ToleranceRequest in_file_units(double length) { return {length, geom::ToleranceRequest::Measure::FileUnits}; }

Repaired repaired(const Scene& scene, double tolerance, int threads, double slow_seconds) {
  repair::RepairOptions options;
  options.tolerance = in_file_units(tolerance);
  const auto start = std::chrono::steady_clock::now();
  bool stopped = false;
  options.progress = [&](const char*, std::size_t) {
    stopped = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > slow_seconds;
    return !stopped;
  };
  Repaired result;
  tbb::task_arena arena(threads);
  arena.execute([&] { result = repair::repair(scene, {}, options); });
  result.interrupted |= stopped;
  return result;
}

std::vector<PlacedTriangle> triangles_of(const scene::ConformingModel& model) {
  std::vector<PlacedTriangle> all;
  const auto at = [&](scene::PointId id) { return model.lattice.position(model.points[id]); };
  for (const auto& ids : model.triangles) all.push_back({at(ids[0]), at(ids[1]), at(ids[2])});
  return all;
}

/// What the faces of the input stand for. Of a face whose outline crosses itself that is open: any fan over it may be
/// meant.
struct InputTriangles {
  std::vector<PlacedTriangle> certain, possible;
};

void add_fans(const validate::Context& context, const scene::Face& face, std::vector<PlacedTriangle>& fans) {
  for (const scene::Loop& loop : context.scene.loops_of(face)) {
    const auto ring = context.model.corners_of(loop);
    const auto at = [&](std::size_t i) { return context.position(ring[i % ring.size()]); };
    for (std::size_t start = 0; start < ring.size(); ++start) {
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) fans.push_back({at(start), at(start + i), at(start + i + 1)});
    }
  }
}

InputTriangles input_triangles(const Scene& scene, double tolerance) {
  std::string refusal;
  const auto context = validate::build_context(scene, {}, in_file_units(tolerance), refusal);
  InputTriangles all;
  if (!context) return all;
  const auto at = [&](scene::PointId id) { return context->position(id); };
  for (const auto& t : context->triangles.triangles) {
    all.certain.push_back({at(t.points[0]), at(t.points[1]), at(t.points[2])});
  }
  all.possible = all.certain;
  for (scene::FaceId face = 0; face < scene.faces.size(); ++face) {
    if (!context->is_sound(face) && !context->model.left_out[face]) add_fans(*context, scene.faces[face], all.possible);
  }
  return all;
}

/// Triangles by place with their material, ascending, `shift` and `scale` undone.
using NamedPlaces = std::vector<std::pair<std::array<std::array<double, 3>, 3>, std::string>>;
NamedPlaces named_places(const scene::ConformingModel& model, const Scene& origin, const geom::dvec3& shift,
                         double scale) {
  NamedPlaces all;
  for (const scene::ConformingFace& face : model.faces) {
    for (const auto& ids : model.triangles_of(face)) {
      std::array<std::array<double, 3>, 3> places;
      for (std::size_t i = 0; i < 3; ++i) {
        const geom::dvec3 p = (model.lattice.position(model.points[ids[i]]) - shift) / scale;
        places[i] = {p.x, p.y, p.z};
      }
      std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
      all.emplace_back(places, origin.materials[face.material].name);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string errors_in(const Scene& written, double tolerance) {
  for (const validate::Stage stage : {validate::Stage::Model, validate::Stage::Display}) {
    validate::LintOptions options;
    options.stage = stage;
    options.tolerance = in_file_units(tolerance);
    for (const scene::Finding& finding : validate::lint(written, {}, options).findings) {
      if (finding.severity != scene::Severity::Error) continue;
      return fmt::format("{} x{}: {}", finding.rule, finding.count, finding.message);
    }
  }
  return "";
}

class Judge {
 public:
  Judge(const Scene& scene, double tolerance, const JudgeOptions& options)
      : scene_(scene), asked_(tolerance), options_(options) {}

  RepairVerdict run() {
    const auto start = std::chrono::steady_clock::now();
    result_ = repaired(scene_, asked_, 1, options_.slow_seconds);
    verdict_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    verdict_.was_clean = result_.untouched;
    tolerance_ = result_.model.tolerance.length;
    for (const scene::LedgerEntry& entry : result_.ledger) {
      verdict_.movement = std::max(verdict_.movement, entry.largest_movement / tolerance_);
    }
    make("ends", [&] { return unfinished(result_); });
    if (result_.model.triangles.empty() || result_.interrupted) return std::move(verdict_);
    judge_file();
    judge_fidelity();
    if (options_.variants) judge_variants();
    return std::move(verdict_);
  }

 private:
  [[nodiscard]] bool asks(std::string_view check) const {
    if (!options_.only.empty()) return options_.only == check;
    return std::ranges::find(options_.skipped, check) == options_.skipped.end();
  }
  [[nodiscard]] NamedPlaces places_of_result() const { return named_places(result_.model, scene_, {0, 0, 0}, 1); }

  template <typename Ask>
  void make(std::string_view check, Ask ask) {
    if (!asks(check)) return;
    if (std::string what = ask(); !what.empty()) verdict_.faults.push_back({check, std::move(what)});
  }

  std::string unfinished(const Repaired& result) const {
    if (!result.refusal.empty()) return "refused: " + result.refusal;
    if (result.interrupted) return fmt::format("not done after {} s", options_.slow_seconds);
    if (result.unresolved > 0) return fmt::format("{} violations unresolved", result.unresolved);
    return "";
  }

  void judge_file() {
    const Scene triangles = scene::repaired_scene(result_.model, scene_, scene::Pieces::Triangles);
    bytes_ = glb_bytes(triangles);
    const Scene written = scene_of_glb(bytes_);
    const auto exact = lattice_triangles(written, result_.model.lattice);
    make("file", [&]() -> std::string {
      if (!exact) return "a vertex is not on the lattice";
      if (written.faces.size() == triangles.faces.size()) return "";
      return fmt::format("{} triangles written, {} read", triangles.faces.size(), written.faces.size());
    });
    make("lint", [&] { return errors_in(written, tolerance_); });
    make("exact", [&]() -> std::string {
      if (!exact) return "";
      const ExactCounts c = exact_lint(*exact, kExactShare * static_cast<double>(result_.model.tolerance.pitches));
      if (c.clean()) return "";
      return fmt::format("degenerate {} duplicates {} intersections {} overlaps {} t-vertices {}; {}", c.degenerate,
                         c.duplicates, c.intersections, c.overlaps, c.t_vertices, c.first);
    });
    judge_second_repair(written);
  }

  void judge_second_repair(const Scene& written) {
    if (!asks("again") && !asks("bytes")) return;
    const Repaired again = repaired(written, tolerance_, 1, options_.slow_seconds);
    make("again", [&]() -> std::string {
      if (!again.untouched) return "the file is repaired once more";
      const bool same = named_places(again.model, written, {0, 0, 0}, 1) == places_of_result();
      return same ? "" : "nothing to repair in the file, yet other triangles";
    });
    make("bytes", [&]() -> std::string {
      if (!again.untouched || !keeps_lattice(again)) return "";
      const Scene triangles = scene::repaired_scene(again.model, written, scene::Pieces::Triangles);
      return glb_bytes(triangles) == bytes_ ? "" : "nothing to repair in the file, yet other bytes";
    });
  }

  // A T beyond kLargestRecordedShare of the diagonal is not taken over from a file, nor is its lattice.
  [[nodiscard]] bool keeps_lattice(const Repaired& again) const {
    return again.model.lattice.pitch == result_.model.lattice.pitch &&
           again.model.lattice.origin == result_.model.lattice.origin;
  }

  void judge_fidelity() {
    const InputTriangles before = input_triangles(scene_, tolerance_);
    const auto after = triangles_of(result_.model);
    const auto beyond = [](double distance, double bound) { return distance > bound + kRounding; };
    make("lost", [&]() -> std::string {
      verdict_.lost = farthest_deep_point(before.certain, after, kDepth * tolerance_) / tolerance_;
      return beyond(verdict_.lost, kFidelityBound) ? fmt::format("{:.1f} T of an input face", verdict_.lost) : "";
    });
    make("added", [&]() -> std::string {
      verdict_.added = farthest_point(after, before.possible) / tolerance_;
      return beyond(verdict_.added, kFidelityBound) ? fmt::format("{:.1f} T away from the input", verdict_.added) : "";
    });
    make("movement", [&]() -> std::string {
      for (const scene::LedgerEntry& entry : result_.ledger) {
        const double bound = entry.operation == "merge-points" ? kMergeBound : kMovementBound;
        if (!beyond(entry.largest_movement / tolerance_, bound)) continue;
        return fmt::format("{} moved a point by {:.2f} T", entry.operation, entry.largest_movement / tolerance_);
      }
      return "";
    });
  }

  void judge_variants() {
    make("threads", [&] { return other_bytes(scene_, 2); });
    make("order", [&] { return other_bytes(rewritten(scene_, kShuffle), 1); });
    make("moved", [&]() -> std::string {
      if (scene_.recorded) return "";
      const Scene larger = scaled(scene_, kExponent);
      const double factor = std::ldexp(1.0, kExponent);
      if (differs(larger, {0, 0, 0}, factor)) return "another result for the scene scaled by a power of two";
      const auto shifted = moved(scene_);
      if (!shifted) return "";
      const geom::dvec3 by = shifted->vertices[0] - scene_.vertices[0];
      return differs(*shifted, by, 1) ? "another result for the scene moved by powers of two" : "";
    });
    make("mirrored", [&]() -> std::string {
      if (scene_.recorded) return "";
      const Repaired other = repaired(mirrored(scene_), asked_, 1, options_.slow_seconds);
      return unfinished(other);
    });
  }

  [[nodiscard]] std::string other_bytes(const Scene& scene, int threads) const {
    const Repaired other = repaired(scene, asked_, threads, options_.slow_seconds);
    if (glb_bytes(scene::repaired_scene(other.model, scene, scene::Pieces::Triangles)) == bytes_) return "";
    const bool same =
        named_places(other.model, scene, {0, 0, 0}, 1) == named_places(result_.model, scene_, {0, 0, 0}, 1);
    return same ? "the same triangles, yet other bytes" : "other triangles";
  }

  [[nodiscard]] bool differs(const Scene& scene, const geom::dvec3& shift, double scale) const {
    const Repaired other = repaired(scene, asked_ * scale, 1, options_.slow_seconds);
    return named_places(other.model, scene, shift, scale) != places_of_result();
  }

  static constexpr std::uint32_t kShuffle = 7;
  static constexpr int kExponent = 5;

  const Scene& scene_;
  double asked_;
  double tolerance_ = 0;  // as repair rounded it
  const JudgeOptions& options_;
  Repaired result_;
  std::string bytes_;
  RepairVerdict verdict_;
};

}  // namespace

RepairVerdict judge_repair(const Scene& scene, double tolerance, const JudgeOptions& options) {
  return Judge(scene, tolerance, options).run();
}

std::vector<std::string_view> repair_checks() {
  return {"ends",  "file",     "lint",    "exact", "again", "bytes",   "lost",
          "added", "movement", "threads", "order", "moved", "mirrored"};
}

}  // namespace rad::corpus
