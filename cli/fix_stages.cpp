#include "cli/fix_stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bake/display_scene.h"
#include "bake/vertex_light.h"
#include "cli/exit_code.h"
#include "cli/written_faces.h"
#include "mesh/element_mesh.h"
#include "mesh/element_views.h"
#include "mesh/emesh.h"
#include "mesh/pmesh.h"
#include "mesh/statistics.h"
#include "repair/fitness.h"
#include "scene/repaired_scene.h"
#include "solve/light.h"
#include "solve/solver.h"

namespace rad::cli {

namespace {

// Receivers are to be denser than radiators (paper 3.4): by default four times along an edge.
constexpr double kElementShare = 0.25;

// After so many rounds what is at fault is written and named.
constexpr int kMeshRounds = 3;

constexpr const char* kNoEmitter =
    "no material emits light, so there is nothing to solve. Give one a radiant exitance in W/m2: a line \"Ke 100 100 "
    "100\" in the MTL file, or emissiveFactor in glTF";
constexpr const char* kNoEmitterLeft =
    "no face that emits light is left: those of the input have no area or lie under other faces";

class Stages {
 public:
  Stages(const Model& model, const FixCommand& command, bool triangles_only, LiveLine& line,
         const InterruptWatch& watch)
      : origin_(model.content.scene),
        issues_(model.content.issues),
        command_(command),
        triangles_only_(triangles_only),
        line_(line),
        watch_(watch) {}

  Product run() {
    if (can_be_solved() && repair() && command_.mesh) mesh();
    return std::move(product_);
  }

 private:
  bool stop(int exit_code, std::string problem) {
    product_.exit_code = exit_code;
    product_.problem = std::move(problem);
    return false;
  }

  // Adds to the stage where it has run before.
  void lap(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    const auto known = std::ranges::find(product_.timings, stage, &std::pair<std::string, double>::first);
    if (known == product_.timings.end()) {
      product_.timings.emplace_back(stage, seconds);
    } else {
      known->second += seconds;
    }
    last_ = now;
  }

  // Asked before the work, so that nobody waits for a mesh to learn that there is no light.
  bool can_be_solved() {
    if (!command_.solve) return true;
    if (const std::string problem = solve::light_problem(origin_.materials); !problem.empty()) {
      return stop(kUsage, problem);
    }
    const bool shines = std::ranges::any_of(origin_.faces, [&](const scene::Face& face) {
      return face.material < origin_.materials.size() && origin_.materials[face.material].emits();
    });
    return shines || stop(kUsage, kNoEmitter);
  }

  bool repair() {
    repair::RepairOptions options;
    options.tolerance = command_.model.tolerance;
    options.as_it_is = !command_.repair;
    options.progress = [&](const char* step, std::size_t left) {
      line_.show(left > 0 ? fmt::format("repair: {}, {} left", step, left) : fmt::format("repair: {}", step));
      return !watch_.interrupted();
    };
    repair::Repaired repaired = repair::repair(origin_, issues_, options);
    if (!repaired.refusal.empty()) return stop(kUsage, repaired.refusal);
    if (repaired.model.faces.empty()) return stop(kRefused, "no surface in it; nothing was written");
    product_.repair = !command_.repair     ? report::RepairDone::Skipped
                      : repaired.untouched ? report::RepairDone::NotNeeded
                                           : report::RepairDone::Done;
    product_.incomplete = repaired.interrupted;
    product_.ledger = std::move(repaired.ledger);
    product_.timings = std::move(repaired.timings);
    product_.lattice = {repaired.model.lattice, repaired.model.tolerance.length};
    last_ = std::chrono::steady_clock::now();
    model_ = std::move(repaired.model);
    if (command_.mesh) return !product_.incomplete || stop(kIncomplete, "interrupted; nothing was written");
    const bool as_it_was = repaired.untouched && !triangles_only_;
    product_.scene = as_it_was         ? origin_
                     : triangles_only_ ? scene::repaired_scene(model_, origin_, scene::Pieces::Triangles)
                                       : faces_to_write(model_, origin_);
    return true;
  }

  bool mesh() {
    line_.show("mesh: patches");
    mesh::PatchOptions options;
    options.longest_edge = command_.patch_size.value_or(mesh::default_patch_length(model_));
    options.materials = origin_.materials;
    const double element_size = command_.element_size.value_or(kElementShare * options.longest_edge);
    for (int round = 0;; ++round) {
      const mesh::PatchOutcome patches = mesh::pmesh(model_, options);
      if (!patches.mesh) return stop(kRefused, patches.problem);
      lap("pmesh");
      line_.show("mesh: elements");
      mesh::ElementMesh elements(*patches.mesh);
      mesh::emesh(elements, element_size);
      lap("emesh");
      const mesh::DisplayMesh display = mesh::display_mesh(elements);
      product_.scene = bake::display_scene(display, model_.lattice, origin_);
      line_.show("mesh: judging");
      const bool more = round < kMeshRounds && command_.repair && keep_faults_whole(elements, display, options);
      lap("emesh");
      if (more) continue;
      note_mesh(*patches.mesh, elements, options.longest_edge, element_size);
      return !command_.solve || solve(elements, display);
    }
  }

  // Where faces come so near to each other that their division is at fault, they keep the triangles that repair has
  // proven. False where nothing is at fault, or nothing more can be kept.
  bool keep_faults_whole(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display,
                         mesh::PatchOptions& options) {
    const geom::ToleranceRequest tolerance{model_.tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
    scene::Scene judged = product_.scene;
    judged.recorded = product_.lattice;
    const std::size_t known = options.whole_faces.size();
    for (const scene::FaceId face : repair::faces_at_fault(judged, tolerance, validate::Stage::Solve)) {
      options.whole_faces.push_back(elements.source(display.faces[face].patch).origin);
    }
    std::sort(options.whole_faces.begin(), options.whole_faces.end());
    const auto last = std::unique(options.whole_faces.begin(), options.whole_faces.end());
    options.whole_faces.erase(last, options.whole_faces.end());
    return options.whole_faces.size() > known;
  }

  void note_mesh(const mesh::PatchMesh& patches, const mesh::ElementMesh& elements, double patch_size,
                 double element_size) {
    const mesh::PatchStatistics patch = mesh::patch_statistics(patches);
    const mesh::ElementStatistics element = mesh::element_statistics(elements);
    product_.mesh = report::MeshFigures{model_.faces.size(), patch.triangles + patch.quads,
                                        element.leaves,      element.nodes,
                                        patch_size,          element_size,
                                        patch.shape.median,  patch.shape.first};
  }

  bool solve(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display) {
    const mesh::RadiosityMesh receivers = mesh::radiosity_mesh(elements);
    if (!solve::has_emitters(receivers, origin_.materials)) return stop(kUsage, kNoEmitterLeft);
    solve::SolveOptions options;
    options.metres_per_unit = origin_.metres_per_unit.value_or(1);
    solve::Progress progress([&](const solve::ProgressState& state) {
      line_.show(solve_line(state, options.unshot_limit));
      return !watch_.interrupted();
    });
    const mesh::RadiosityField field = solve::solve(receivers, origin_.materials, options, progress);
    lap("solve");
    product_.light = bake::vertex_light(display, receivers, origin_.materials, field, command_.exposure);
    product_.solution = report::SolutionFigures{field.energy, field.shots, field.complete, product_.light->exposure};
    product_.incomplete = !field.complete;
    lap("bake");
    return true;
  }

  // Unshot energy falls about exponentially: from what it fell so far follows what is left.
  static std::string solve_line(const solve::ProgressState& state, double limit) {
    const std::string now =
        fmt::format("solve: {} shots, {:.2f} % of the light unshot", state.shots, 100 * state.unshot_share);
    const double fallen = -std::log(state.unshot_share), wanted = -std::log(limit);
    if (!(fallen > 0)) return now;
    const double left = state.elapsed_seconds * std::max(0.0, wanted / fallen - 1);
    return fmt::format("{}, about {:.0f} s left", now, left);
  }

  const scene::Scene& origin_;
  const scene::ReadIssues& issues_;
  const FixCommand& command_;
  bool triangles_only_;
  LiveLine& line_;
  const InterruptWatch& watch_;
  scene::ConformingModel model_;
  Product product_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Product make_product(const Model& model, const FixCommand& command, bool triangles_only, LiveLine& line,
                     const InterruptWatch& watch) {
  return Stages(model, command, triangles_only, line, watch).run();
}

}  // namespace rad::cli
