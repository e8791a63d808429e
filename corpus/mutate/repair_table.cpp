#include "corpus/mutate/repair_table.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "corpus/generate/models.h"
#include "corpus/judge/fidelity.h"
#include "corpus/mutate/run_radfix.h"
#include "readers/reader.h"
#include "validate/context.h"
#include "validate/lint.h"
#include "writers/obj.h"
#include "writers/whole_file.h"

namespace rad::corpus {
namespace {

using scene::Finding;
using scene::Scene;

constexpr std::string_view kInvalidFacade = "RL113";
constexpr std::string_view kPlantedObject = "\"planted\"";  // as messages name it
constexpr double kMovementBound = 4, kMergeBound = 8;       // T; docs/repair.md
// Of distances measured in doubles, and of coordinates written with the digits that read back the same.
constexpr double kRounding = 1e-3;  // T

// Planar faces that are not maximal: what a polygon cannot say goes out as triangles. Counted, not held against radfix.
constexpr std::string_view kSeam = "RL120";

struct Subject {
  std::string name;
  Scene scene;
};

std::vector<Subject> subjects(const std::vector<std::string>& wanted) {
  constexpr std::size_t kSphereTriangles = 180, kTerrainCells = 8, kCityBlocks = 3;
  std::vector<Subject> all;
  for (const Model& model : kept_models()) {
    if (model.clean) all.push_back({std::string(model.name), model.make()});
  }
  all.push_back({"sphere", clean_sphere(kSphereTriangles)});
  all.push_back({"terrain", clean_terrain(kTerrainCells)});
  all.push_back({"city", clean_city(kCityBlocks)});
  if (!wanted.empty()) {
    std::erase_if(all, [&](const Subject& subject) { return std::ranges::find(wanted, subject.name) == wanted.end(); });
  }
  return all;
}

std::vector<Finding> findings_in(const Scene& scene) {
  validate::LintOptions options;
  options.group = false;
  return validate::lint(scene, {}, options).findings;
}

/// A scene as its triangles, with what each material has of area and outline.
struct Measured {
  std::vector<PlacedTriangle> triangles;
  std::map<std::string, double> area, perimeter;

  explicit Measured(const Scene& scene) {
    std::string refusal;
    const auto context = validate::build_context(scene, {}, std::nullopt, refusal);
    if (!context) return;
    for (const auto& t : context->triangles.triangles) {
      const PlacedTriangle places{context->position(t.points[0]), context->position(t.points[1]),
                                  context->position(t.points[2])};
      const std::string& material = scene.materials[scene.faces[t.face].material].name;
      area[material] += glm::length(glm::cross(places[1] - places[0], places[2] - places[0])) / 2;
      for (std::size_t i = 0; i < 3; ++i) perimeter[material] += glm::distance(places[i], places[(i + 1) % 3]);
      triangles.push_back(places);
    }
    for (scene::FaceId face = 0; face < scene.faces.size(); ++face) {
      if (!context->is_sound(face)) area[scene.materials[scene.faces[face].material].name] += fan_area(*context, face);
    }
  }

 private:
  // What a face whose outline crosses itself may stand for, at most.
  static double fan_area(const validate::Context& context, scene::FaceId face) {
    const scene::Loop& loop = context.scene.loops[context.scene.faces[face].first_loop];
    const auto ring = context.model.corners_of(loop);
    double sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const dvec3 a = context.position(ring[0]), b = context.position(ring[i]), c = context.position(ring[i + 1]);
      sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
  }
};

bool in_region(const geom::Box& region, const dvec3& p) {
  return region.empty() || p == glm::clamp(p, region.low, region.high);
}

// Whether radfix promises that the rule does not speak in a model: it has a safe fix, and is an error at one of the two
// stages of that promise.
bool is_repairable(std::string_view id) {
  for (const validate::Rule* rule : validate::all_rules()) {
    if (rule->id != id || rule->fix != scene::FixClass::Safe || rule->fix_operation == "pmesh") continue;
    return validate::severity_at(*rule, validate::Stage::Model) == scene::Severity::Error ||
           validate::severity_at(*rule, validate::Stage::Display) == scene::Severity::Error;
  }
  return false;
}

std::set<std::string> rules_in(const Scene& scene) {
  std::set<std::string> rules;
  for (const Finding& finding : findings_in(scene)) rules.insert(std::string(finding.rule));
  return rules;
}

class TrialFolder {
 public:
  TrialFolder() : path_(std::filesystem::temp_directory_path() / ("rad_mutants_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TrialFolder() { std::filesystem::remove_all(path_); }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;

  [[nodiscard]] std::filesystem::path at(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// One clean model, and what of it a repaired mutant is compared with.
class Trials {
 public:
  Trials(const Subject& subject, const RepairTrials& options, const TrialFolder& folder, RepairTable& table)
      : subject_(subject),
        options_(options),
        folder_(folder),
        table_(table),
        survey_(subject.scene),
        clean_(subject.scene) {
    clean_rules_ = rules_in(subject.scene);
  }

  void plant(const Mutator& mutator, RepairScore& score) {
    for (std::uint64_t seed = 1; seed <= options_.seeds; ++seed) {
      Random random(seed);
      const auto mutant = mutator.plant(survey_, random);
      if (!mutant) continue;
      ++score.planted;
      label_ = fmt::format("{}, {}, seed {}", subject_.name, mutator.name, seed);
      try_mutant(mutator, *mutant, score);
    }
  }

  void plant(const TextMutator& mutator, RepairScore& score) {
    const std::string obj = writers::obj_text(subject_.scene, "model.mtl").obj;
    for (std::uint64_t seed = 1; seed <= options_.seeds; ++seed) {
      Random random(seed);
      const auto mutant = mutator.plant(obj, random);
      if (!mutant) continue;
      ++score.planted;
      label_ = fmt::format("{}, {}, seed {}", subject_.name, mutator.name, seed);
      writers::write_whole_file(folder_.at("model.obj"), mutant->obj);
      writers::write_whole_file(folder_.at("model.mtl"), writers::obj_text(subject_.scene, "model.mtl").mtl);
      const RadfixRun run = run_radfix(options_.radfix, folder_.at("model.obj"), folder_.at("fixed.obj"));
      settle(run, score) ? ++score.gone : ++score.refused;
    }
  }

 private:
  void fail(const std::string& what) { table_.failures.push_back(label_ + ": " + what); }

  // True where something was written.
  bool settle(const RadfixRun& run, const RepairScore& score) {
    if (run.exit_code < 0) fail("radfix could not be run, or crashed");
    if (run.wrote && run.exit_code > 1) fail(fmt::format("exit {}, yet a file was written", run.exit_code));
    if (!run.wrote && score.repairable) fail(fmt::format("exit {}, nothing written", run.exit_code));
    return run.wrote;
  }

  void try_mutant(const Mutator& mutator, const Mutant& mutant, RepairScore& score) {
    const writers::Output output{.scene = mutant.scene};
    if (const auto written = writers::write_obj(output, folder_.at("model.obj")); !written.ok()) {
      return fail(written.problem);
    }
    const RadfixRun run = run_radfix(options_.radfix, folder_.at("model.obj"), folder_.at("fixed.obj"));
    if (!settle(run, score)) {
      ++score.refused;
      return;
    }
    const Scene fixed = readers::read_file(folder_.at("fixed.obj")).scene;
    if (score.repairable && run.exit_code != 0) fail(fmt::format("radfix ends with {}", run.exit_code));
    judge_findings(mutator, mutant, fixed, score);
    judge_ledger(run, score);
    const bool moved = mutant.planted.whole_model && !mutant.planted.region.empty();
    if (!moved) judge_geometry(mutator, mutant, Measured(fixed), run.tolerance, score);
  }

  void judge_findings(const Mutator& mutator, const Mutant& mutant, const Scene& fixed, RepairScore& score) {
    const std::set<std::string> broken_rules = rules_in(mutant.scene);
    const geom::Box region = widened(mutant.planted.region);
    bool named = false;
    std::size_t seams = 0;
    std::set<std::string> fresh;
    for (const Finding& finding : findings_in(fixed)) {
      const std::string rule(finding.rule);
      const bool here = finding.where.point && in_region(region, *finding.where.point);
      if (rule == mutator.rule && here) named |= !region.empty() || !clean_rules_.contains(rule);
      // Facades are judged in conforming models only: the back of an open face that was planted is seen all along.
      const bool planted_back = rule == kInvalidFacade && finding.message.find(kPlantedObject) != std::string::npos;
      const bool known = clean_rules_.contains(rule) || broken_rules.contains(rule) || planted_back;
      if (rule == kSeam) ++seams;
      if (finding.severity != scene::Severity::Note && !known && rule != kSeam)
        fresh.insert(rule + " " + finding.message);
    }
    for (const std::string& finding : fresh) fail("new finding " + finding);
    score.seams += seams;
    named ? ++score.named : ++score.gone;
    if (named && score.repairable) fail(fmt::format("{} still speaks", mutator.rule));
  }

  // A planted place that is flat must hold points in spite of rounding.
  [[nodiscard]] geom::Box widened(geom::Box region) const {
    if (region.empty()) return region;
    const dvec3 slack(survey_.grain() / 10);
    region.low -= slack;
    region.high += slack;
    return region;
  }

  void judge_ledger(const RadfixRun& run, RepairScore& score) {
    for (const LedgerRow& row : run.ledger) {
      const double moved = row.largest_movement / run.tolerance;
      score.moved = std::max(score.moved, moved);
      if (moved > (row.operation == "merge-points" ? kMergeBound : kMovementBound)) {
        fail(fmt::format("{} moved a point by {:.2f} T", row.operation, moved));
      }
    }
  }

  void judge_geometry(const Mutator& mutator, const Mutant& mutant, const Measured& fixed, double tolerance,
                      RepairScore& score) {
    const double bound = 1 + mutator.noise + kRounding;
    const geom::Box region = widened(mutant.planted.region);
    const double lost = farthest_deep_point(clean_.triangles, fixed.triangles, tolerance, region) / tolerance;
    const double added = farthest_point(fixed.triangles, clean_.triangles, region) / tolerance;
    if (lost > bound) fail(fmt::format("{:.2f} T of the clean model lost", lost));
    if (added > bound) fail(fmt::format("{:.2f} T from the clean model added", added));
    score.lost = std::max(score.lost, lost);
    score.added = std::max(score.added, added);
    judge_areas(Measured(mutant.scene), fixed, tolerance, score);
  }

  // A material may lose to a planted one what that has.
  void judge_areas(const Measured& broken, const Measured& fixed, double tolerance, RepairScore& score) {
    double foreign = 0;
    for (const auto& [material, area] : broken.area) foreign += clean_.area.contains(material) ? 0 : area;
    for (const auto& [material, area] : clean_.area) {
      const double planted = std::abs(area_of(broken, material) - area) + foreign;
      const double change = std::abs(area_of(fixed, material) - area);
      const double beyond = std::max(0.0, change - planted) / (clean_.perimeter.at(material) * tolerance);
      score.area = std::max(score.area, beyond);
      if (beyond > 1)
        fail(fmt::format("area of {} changed by {:.3g}, {:.3g} of it planted", material, change, planted));
    }
  }

  static double area_of(const Measured& measured, const std::string& material) {
    const auto found = measured.area.find(material);
    return found == measured.area.end() ? 0 : found->second;
  }

  const Subject& subject_;
  const RepairTrials& options_;
  const TrialFolder& folder_;
  RepairTable& table_;
  Survey survey_;
  Measured clean_;
  std::set<std::string> clean_rules_;
  std::string label_;
};

std::vector<Mutator> all_mutators() {
  std::vector<Mutator> all(mutators().begin(), mutators().end());
  all.insert(all.end(), model_mutators().begin(), model_mutators().end());
  return all;
}

constexpr std::string_view kIntroduction =
    R"(# Planted defects and what radfix makes of them

Written by `rad_mutator_table --radfix bin/radfix > docs/mutators.md`; do not edit. Each defect is planted into clean
models: the kept ones, a sphere, a terrain and a city. `radfix` repairs the OBJ, and the OBJ that it wrote is compared with
the clean model.

- *must go*: the rule has a safe fix and is an error at stage model or display. Other defects may go, stay named or be
  refused, but nothing else may change for them.
- *seams*: edges between coplanar faces of one material that nothing else needs (RL120), in all results together: a
  polygon has no place for an edge inside it, and noise within T may leave two planes of one.
- *lost*, *added*: how far the clean model and the result are from each other outside of the planted place, in T; at
  most 1, and as much more as the defect moves of the model.
- *area*: change of the area of a material beyond what was planted, over perimeter times T; at most 1.
- *moved*: the largest movement in the ledger, in T; at most 4, a merge 8.

)";

constexpr std::string_view kHead =
    "| defect | rule | must go | planted | gone | named | refused | seams | lost, T | added, T | area | moved, T |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string row_start(const RepairScore& score) {
  return fmt::format("| {} | {} | {} |", score.mutator, score.rule, score.repairable ? "yes" : "");
}

std::vector<RepairScore> empty_scores() {
  std::vector<RepairScore> scores;
  const auto add = [&](const auto& mutator) {
    scores.push_back({std::string(mutator.name), std::string(mutator.rule), is_repairable(mutator.rule)});
  };
  for (const Mutator& mutator : all_mutators()) add(mutator);
  for (const TextMutator& mutator : text_mutators()) add(mutator);
  return scores;
}

}  // namespace

RepairTable measure_repairs(const RepairTrials& options) {
  RepairTable table{empty_scores(), {}};
  const TrialFolder folder;
  for (const Subject& subject : subjects(options.models)) {
    Trials trials(subject, options, folder, table);
    std::size_t row = 0;
    for (const Mutator& mutator : all_mutators()) trials.plant(mutator, table.scores[row++]);
    for (const TextMutator& mutator : text_mutators()) trials.plant(mutator, table.scores[row++]);
  }
  return table;
}

std::vector<std::string> clean_subjects() {
  std::vector<std::string> names;
  for (const Subject& subject : subjects({})) names.push_back(subject.name);
  return names;
}

std::string markdown(const RepairTable& table) {
  std::string text(kIntroduction);
  text += kHead;
  std::size_t planted = 0;
  for (const RepairScore& s : table.scores) {
    text += row_start(s) + fmt::format(" {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", s.planted,
                                       s.gone, s.named, s.refused, s.seams, s.lost, s.added, s.area, s.moved);
    planted += s.planted;
  }
  text += fmt::format("\n{} planted in all, {} failures.\n", planted, table.failures.size());
  return text;
}

std::string fault_of_form(std::string_view document) {
  if (document.find(kHead) == std::string_view::npos) return "has not the head of the table";
  for (const RepairScore& score : empty_scores()) {
    if (document.find(row_start(score)) == std::string_view::npos) return "has no row for '" + score.mutator + "'";
  }
  return "";
}

}  // namespace rad::corpus
