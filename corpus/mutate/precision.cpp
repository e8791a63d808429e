#include "corpus/mutate/precision.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "corpus/generate/models.h"
#include "corpus/mutate/mutator.h"
#include "readers/reader.h"
#include "validate/lint.h"

namespace rad::corpus {
namespace {

using scene::Finding;
using Findings = std::vector<Finding>;

Findings findings_in(const scene::Scene& scene, const scene::ReadIssues& issues) {
  validate::LintOptions options;
  options.group = false;
  return validate::lint(scene, issues, options).findings;
}

// What a finding is, apart from its wording: the same before and after an edit elsewhere.
std::string identity(const Finding& finding) {
  std::array<char, 160> text{};
  const dvec3 p = finding.where.point.value_or(dvec3{0, 0, 0});
  // Millimetres: coarser than what a new vertex far away does to the lattice, finer than any feature.
  std::snprintf(text.data(), text.size(), "%.5s %.0f %.0f %.0f %s", finding.rule.data(), p.x * 1e3, p.y * 1e3,
                p.z * 1e3, finding.where.point ? "" : finding.message.substr(0, 80).c_str());
  return text.data();
}

bool in_region(const geom::Box& region, const dvec3& p, double slack) {
  return p.x >= region.low.x - slack && p.x <= region.high.x + slack && p.y >= region.low.y - slack &&
         p.y <= region.high.y + slack && p.z >= region.low.z - slack && p.z <= region.high.z + slack;
}

bool at_planted_place(const Finding& finding, const Planted& planted, double slack) {
  const auto& lines = planted.lines;
  if (planted.whole_model && !finding.where.point) return true;
  if (!lines.empty()) return std::find(lines.begin(), lines.end(), finding.where.line) != lines.end();
  return finding.where.point && in_region(planted.region, *finding.where.point, slack);
}

/// One mutator on one model.
struct Trial {
  std::string_view rule;
  std::span<const std::string_view> implied;
  const Planted& planted;
  double slack;
  std::string label;
};

void judge(const Trial& trial, const Findings& before, const Findings& after, Score& score,
           std::vector<std::string>& failures) {
  std::set<std::string> known;
  for (const Finding& finding : before) known.insert(identity(finding));
  ++score.planted;
  bool found = false;
  for (const Finding& finding : after) {
    if (known.contains(identity(finding))) continue;
    const bool here = at_planted_place(finding, trial.planted, trial.slack);
    if (here && finding.rule == trial.rule) {
      found = true;
      continue;
    }
    if (finding.rule != trial.rule && finding.severity != scene::Severity::Error) continue;
    if (here && std::find(trial.implied.begin(), trial.implied.end(), finding.rule) != trial.implied.end()) continue;
    ++score.false_findings;
    failures.push_back(trial.label + ": false " + identity(finding) + " " + finding.message);
  }
  if (found) {
    ++score.found;
  } else {
    failures.push_back(trial.label + ": " + std::string(trial.rule) + " missed");
  }
}

struct Subject {
  std::string name;
  scene::Scene scene;
};

class Measurement {
 public:
  explicit Measurement(std::uint64_t seeds) : seeds_(seeds) {
    for (const Mutator& mutator : mutators()) add_score(mutator);
    for (const TextMutator& mutator : text_mutators()) add_score(mutator);
    for (const PhotometryMutator& mutator : photometry_mutators()) add_score(mutator);
  }

  void try_scene(const Subject& subject) {
    const Survey survey(subject.scene);
    const Findings before = findings_in(subject.scene, {});
    report_errors(subject.name, before);
    for (std::size_t i = 0; i < mutators().size(); ++i) {
      const Mutator& mutator = mutators()[i];
      for (std::uint64_t seed = 1; seed <= seeds_; ++seed) {
        Random random(seed);
        const auto mutant = mutator.plant(survey, random);
        if (!mutant) continue;
        const Trial trial{mutator.rule, mutator.implied, mutant->planted, survey.grain() / 10,
                          label(subject.name, mutator.name, seed)};
        judge(trial, before, findings_in(mutant->scene, {}), report.scores[i], report.failures);
      }
    }
  }

  void try_text(const std::string& name, const std::string& obj, const std::filesystem::path& folder) {
    const Findings before = findings_of_text(name, ".obj", obj, folder);
    for (std::size_t i = 0; i < text_mutators().size(); ++i) {
      const TextMutator& mutator = text_mutators()[i];
      for (std::uint64_t seed = 1; seed <= seeds_; ++seed) {
        Random random(seed);
        const auto mutant = mutator.plant(obj, random);
        if (!mutant) continue;
        const Trial trial{mutator.rule, mutator.implied, mutant->planted, 0, label(name, mutator.name, seed)};
        judge(trial, before, findings_of_text(name, ".obj", mutant->obj, folder), report.scores[mutators().size() + i],
              report.failures);
      }
    }
  }

  void try_photometry() {
    std::size_t row = mutators().size() + text_mutators().size();
    for (const PhotometryMutator& mutator : photometry_mutators()) {
      for (std::uint64_t seed = 1; seed <= seeds_; ++seed) {
        Random first(seed), again(seed);
        const Findings before = findings_of_text("lamp", mutator.suffix, mutator.sound(first), ".");
        report_errors("lamp" + std::string(mutator.suffix), before);
        Planted planted;
        planted.whole_model = true;
        const Trial trial{mutator.rule, {}, planted, 0, label("lamp", mutator.name, seed)};
        judge(trial, before, findings_of_text("lamp", mutator.suffix, mutator.spoiled(again), "."), report.scores[row],
              report.failures);
      }
      ++row;
    }
  }

  PrecisionReport report;

 private:
  template <typename Any>
  void add_score(const Any& mutator) {
    report.scores.push_back({std::string(mutator.name), std::string(mutator.rule), 0, 0, 0});
  }

  static std::string label(std::string_view model, std::string_view mutator, std::uint64_t seed) {
    return std::string(model) + ", " + std::string(mutator) + ", seed " + std::to_string(seed);
  }

  static Findings findings_of_text(const std::string& name, std::string_view suffix, const std::string& text,
                                   const std::filesystem::path& folder) {
    const readers::ReadResult read = readers::read_bytes({name + std::string(suffix), folder, text, {}});
    return findings_in(read.scene, read.issues);
  }

  void report_errors(const std::string& name, const Findings& findings) {
    for (const Finding& finding : findings) {
      if (finding.severity == scene::Severity::Error) {
        report.failures.push_back(name + ", clean: " + identity(finding) + " " + finding.message);
      }
    }
  }

  std::uint64_t seeds_;
};

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

bool PrecisionReport::perfect() const {
  const bool all_found = std::all_of(scores.begin(), scores.end(), [](const Score& score) {
    return score.found == score.planted && score.planted > 0;
  });
  return all_found && failures.empty();
}

PrecisionReport measure_precision(const std::filesystem::path& models, std::uint64_t seeds) {
  constexpr std::size_t kSphereTriangles = 720, kTerrainCells = 16, kCityBlocks = 5;
  Measurement measurement(seeds);
  for (const Model& model : kept_models()) {
    if (!model.clean) continue;
    const std::string name(model.name);
    const std::filesystem::path file = models / (name + ".obj");
    measurement.try_scene({name, model.make()});
    measurement.try_scene({name + " as read", readers::read_file(file).scene});
    measurement.try_text(name, bytes_of(file), models);
  }
  measurement.try_photometry();
  measurement.try_scene({"sphere", clean_sphere(kSphereTriangles)});
  measurement.try_scene({"terrain", clean_terrain(kTerrainCells)});
  measurement.try_scene({"city", clean_city(kCityBlocks)});
  return std::move(measurement.report);
}

std::string table(const PrecisionReport& report) {
  std::array<char, 160> line{};
  std::string text;
  const auto add = [&](auto... values) {
    std::snprintf(line.data(), line.size(), values...);
    text += line.data();
  };
  add("%-6s %-30s %8s %6s %8s %6s\n", "rule", "defect", "planted", "found", "recall", "false");
  for (const Score& score : report.scores) {
    const double recall =
        score.planted == 0 ? 0 : 100.0 * static_cast<double>(score.found) / static_cast<double>(score.planted);
    add("%-6s %-30s %8zu %6zu %7.1f%% %6zu\n", score.rule.c_str(), score.mutator.c_str(), score.planted, score.found,
        recall, score.false_findings);
  }
  return text;
}

}  // namespace rad::corpus
