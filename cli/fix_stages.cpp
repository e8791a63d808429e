#include "cli/fix_stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bake/display_scene.h"
#include "bake/vertex_light.h"
#include "cli/exit_code.h"
#include "cli/mesh_stage.h"
#include "mesh/element_mesh.h"
#include "mesh/element_views.h"
#include "repair/fitness.h"
#include "scene/mesh_attributes.h"
#include "scene/repaired_scene.h"
#include "solve/light.h"
#include "solve/solver.h"

namespace rad::cli {

namespace {

// After so many rounds what is at fault is written and named.
constexpr int kMeshRounds = 8;

constexpr const char* kNoEmitter =
    "no material emits light, so there is nothing to solve. Give one a radiant exitance in W/m2: a line \"Ke 100 100 "
    "100\" in the MTL file, or emissiveFactor in glTF";
constexpr const char* kNoEmitterLeft =
    "no face that emits light is left: those of the input have no area or lie under other faces";

class Stages {
 public:
  Stages(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
         const InterruptWatch& watch)
      : model_(model), origin_(model.content.scene), command_(command), target_(target), line_(line), watch_(watch) {}

  Product run() {
    if (can_be_solved() && repair() && command_.meshes()) mesh();
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
    if (!command_.solves()) return true;
    if (const std::string problem = solve::light_problem(origin_.materials); !problem.empty()) {
      return stop(kUsage, problem);
    }
    const bool shines = std::ranges::any_of(origin_.faces, [&](const scene::Face& face) {
      return face.material < origin_.materials.size() && origin_.materials[face.material].emits();
    });
    return shines || stop(kUsage, kNoEmitter);
  }

  bool repair() {
    product_.work =
        run_repair(model_, command_, {target_.triangles || command_.meshes(), target_.stage}, line_, watch_);
    RepairRun& work = product_.work;
    const repair::Repaired& repaired = work.repaired;
    if (!repaired.refusal.empty()) return stop(kUsage, repaired.refusal);
    if (!repaired.impossible.empty()) return stop(kRefused, repaired.impossible);
    if (repaired.model.faces.empty()) return stop(kRefused, "no surface in it; nothing was written");
    product_.repair = !command_.repairs()  ? report::RepairDone::Skipped
                      : repaired.untouched ? report::RepairDone::NotNeeded
                                           : report::RepairDone::Done;
    product_.incomplete = repaired.interrupted;
    product_.timings = repaired.timings;
    product_.lattice = {repaired.model.lattice, repaired.model.tolerance.length};
    last_ = std::chrono::steady_clock::now();
    if (work.all_rolled_back) return stop(kRefused, "every filter would make it worse; nothing was written");
    if (command_.meshes()) return !product_.incomplete || stop(kIncomplete, "interrupted; nothing was written");
    product_.scene = std::move(work.pieces.scene);
    return true;
  }

  bool mesh() {
    line_.show("mesh: patches");
    const scene::ConformingModel& model = product_.work.repaired.model;
    std::string problem;
    mesh::PatchOptions options = patch_options(command_, model, origin_, problem);
    if (!problem.empty()) return stop(kUsage, problem);
    const mesh::EmeshOptions dense = emesh_options(command_, options.longest_edge, origin_);
    mesh::PatchMemory memory;
    for (int round = 0;; ++round) {
      const mesh::PatchOutcome patches = mesh::pmesh(model, options, memory);
      if (!patches.mesh) return stop(kRefused, patches.problem);
      lap("pmesh");
      line_.show("mesh: elements");
      mesh::ElementMesh elements(*patches.mesh);
      if (command_.filters.has(scene::Filter::Emesh)) problem = mesh::emesh(elements, dense).problem;
      if (!problem.empty()) return stop(kUsage, problem);
      lap("emesh");
      mesh::DisplayMesh display = show(elements);
      line_.show("mesh: judging");
      const bool more = round < kMeshRounds && command_.repairs() && keep_faults_whole(elements, display, options);
      lap("emesh");
      if (more) continue;
      if (command_.drawn_mesh == DrawnMesh::Patches) {
        const mesh::ElementMesh whole(*patches.mesh);
        product_.patches = rad::bake::display_scene(mesh::display_mesh(whole), model.lattice, origin_);
      }
      std::optional<mesh::RadiosityField> field;
      if (command_.solves()) {
        if (!(field = solve(elements, dense.shadow_edge))) return false;
        display = show(elements);
      }
      product_.mesh = mesh_figures(*patches.mesh, elements, options, dense);
      product_.mesh->faces = model.faces.size();
      note_faces(elements, display);
      return !field || bake(elements, display, *field, dense.shadow_edge);
    }
  }

  mesh::DisplayMesh show(const mesh::ElementMesh& elements) {
    mesh::DisplayMesh display = mesh::display_mesh(elements);
    product_.scene = rad::bake::display_scene(display, product_.work.repaired.model.lattice, origin_);
    carry_attributes(elements, display);
    return display;
  }

  // Under a solution the light is the colour of the vertices, reflectance included: an image would count twice.
  void carry_attributes(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display) {
    if (command_.solves()) {
      for (scene::Material& material : product_.scene.materials) material.texture.reset();
      return;
    }
    std::vector<std::uint32_t> model_face;
    for (const mesh::DisplayFace& face : display.faces) model_face.push_back(elements.source(face.patch).origin);
    scene::carry_attributes(product_.scene, model_face, product_.work.repaired.model, origin_);
  }

  // Where faces come so near to each other that their division is at fault, they keep the triangles that repair has
  // proven. False where nothing is at fault, or nothing more can be kept.
  bool keep_faults_whole(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display,
                         mesh::PatchOptions& options) {
    const std::size_t known = options.whole_faces.size();
    known_faults_ = patches_at_fault(display, product_.scene);
    for (const mesh::PatchId patch : known_faults_) options.whole_faces.push_back(elements.source(patch).origin);
    std::sort(options.whole_faces.begin(), options.whole_faces.end());
    const auto last = std::unique(options.whole_faces.begin(), options.whole_faces.end());
    options.whole_faces.erase(last, options.whole_faces.end());
    return options.whole_faces.size() > known;
  }

  // What is shown must be ziplocked as well, whoever shows it.
  std::vector<scene::FaceId> faces_at_fault(scene::Scene judged) const {
    judged.recorded = product_.lattice;
    const geom::ToleranceRequest tolerance{product_.lattice.tolerance, geom::ToleranceRequest::Measure::FileUnits};
    return repair::faces_at_fault(judged, tolerance, {validate::Stage::Solve, validate::Stage::Display});
  }

  // Ascending, with repetitions.
  std::vector<mesh::PatchId> patches_at_fault(const mesh::DisplayMesh& display, const scene::Scene& shown) const {
    std::vector<mesh::PatchId> patches;
    for (const scene::FaceId face : faces_at_fault(shown)) patches.push_back(display.faces[face].patch);
    std::sort(patches.begin(), patches.end());
    return patches;
  }

  // Of a mesh that was divided further.
  std::vector<mesh::PatchId> new_patches_at_fault(const mesh::ElementMesh& elements) const {
    const mesh::DisplayMesh display = mesh::display_mesh(elements);
    std::vector<mesh::PatchId> patches =
        patches_at_fault(display, rad::bake::display_scene(display, product_.work.repaired.model.lattice, origin_));
    std::erase_if(patches, [&](mesh::PatchId patch) { return std::ranges::binary_search(known_faults_, patch); });
    return patches;
  }

  void note_faces(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display) {
    std::vector<std::uint32_t>& face = product_.work.pieces.face;
    face.clear();
    for (const auto& shown : display.faces) face.push_back(elements.source(shown.patch).origin);
    product_.work.pieces.triangle.assign(face.size(), scene::PiecesOfModel::kWhole);
    product_.work.input_as_it_was = false;
  }

  // Divides the elements where the light on them bends or steps.
  std::optional<mesh::RadiosityField> solve(mesh::ElementMesh& elements, double finest) {
    if (!solve::has_emitters(mesh::radiosity_mesh(elements), origin_.materials)) {
      stop(kUsage, kNoEmitterLeft);
      return std::nullopt;
    }
    solve::SolveOptions options;
    options.metres_per_unit = origin_.metres_per_unit.value_or(1);
    solve::Progress progress([&](const solve::ProgressState& state) {
      line_.show(solve_line(state, options.unshot_limit));
      return !watch_.interrupted();
    });
    const std::size_t leaves = elements.leaves().size();
    solve::RefineOptions refine = refine_options(command_, elements, finest);
    if (command_.repairs())
      refine.at_fault = [&](const mesh::ElementMesh& refined) { return new_patches_at_fault(refined); };
    const mesh::RadiosityField field = solve::solve(elements, origin_.materials, options, refine, progress);
    lap("solve");
    product_.solution = report::SolutionFigures{field.energy, field.shots, field.complete, std::nullopt};
    product_.solution->elements_added = elements.leaves().size() - leaves;
    product_.incomplete = !field.complete;
    return field;
  }

  bool bake(const mesh::ElementMesh& elements, const mesh::DisplayMesh& display, const mesh::RadiosityField& field,
            double finest_element) {
    if (!command_.filters.has(scene::Filter::Bake)) return true;
    const mesh::RadiosityMesh nodes = mesh::radiosity_mesh(elements);
    product_.light =
        rad::bake::vertex_light(display, nodes, origin_.materials, field, command_.exposure, command_.curve);
    product_.solution->exposure = product_.light->exposure;
    const bool baked = !command_.maps_light() || map_light({nodes, field, display, elements.lattice(), product_.scene,
                                                            finest_element, product_.light->exposure});
    lap("bake");
    return baked;
  }

  bool map_light(const SolvedMesh& solved) {
    product_.light_map = bake_light_map(command_, solved, [&](const std::string& what) { line_.show(what); });
    if (!product_.light_map->problem.empty()) return stop(kUsage, product_.light_map->problem);
    product_.solution->light_map = product_.light_map->figures;
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

  const Model& model_;
  const scene::Scene& origin_;
  const FixCommand& command_;
  RepairTarget target_;
  LiveLine& line_;
  const InterruptWatch& watch_;
  Product product_;
  std::vector<mesh::PatchId> known_faults_;  ///< of the mesh before it is solved
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Product make_product(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
                     const InterruptWatch& watch) {
  return Stages(model, command, target, line, watch).run();
}

}  // namespace rad::cli
