#include "cli/offender_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "cli/annotated_scene.h"
#include "cli/convert_faces.h"
#include "scene/bad_faces.h"
#include "validate/registry.h"

namespace rad::cli {

namespace {

using geom::dvec3;
using scene::FaceId;

// Reds for errors, yellows for warnings, blues for notes; also told apart by lightness.
constexpr std::array<std::array<dvec3, 4>, 3> kColours = {{
    {{{0.05, 0.25, 0.80}, {0.15, 0.50, 0.90}, {0.02, 0.12, 0.45}, {0.30, 0.35, 0.75}}},
    {{{0.90, 0.55, 0.02}, {0.95, 0.75, 0.15}, {0.60, 0.35, 0.01}, {0.75, 0.65, 0.25}}},
    {{{0.80, 0.03, 0.02}, {0.90, 0.20, 0.25}, {0.50, 0.01, 0.08}, {0.70, 0.05, 0.35}}},
}};
constexpr dvec3 kRest{0.60, 0.60, 0.60};

/// Faces that findings of one rule and severity name.
struct Offenders {
  scene::Severity severity = scene::Severity::Note;
  std::string_view alias;
  std::vector<FaceId> faces;
};

std::map<std::string_view, Offenders> offenders_of(const std::vector<scene::Finding>& findings) {
  std::map<std::string_view, Offenders> rules;
  for (const scene::Finding& finding : findings) {
    Offenders& offenders = rules[finding.rule];
    offenders.severity = std::max(offenders.severity, finding.severity);
    offenders.alias = finding.alias;
    offenders.faces.insert(offenders.faces.end(), finding.where.face_ids.begin(), finding.where.face_ids.end());
  }
  for (auto& [rule, offenders] : rules) {
    std::ranges::sort(offenders.faces);
    const auto [first, last] = std::ranges::unique(offenders.faces);
    offenders.faces.erase(first, last);
  }
  return rules;
}

/// The model with its faces divided among sorts.
class OffenderScene {
 public:
  explicit OffenderScene(const scene::Scene& original) : original_(original), scene_(original) {
    scene_.faces.clear();
    scene_.smoothing_groups.clear();
  }

  void add_rules(const std::map<std::string_view, Offenders>& rules) {
    std::vector<bool> named(original_.faces.size(), false);
    std::array<std::size_t, 3> used{};
    for (const auto& [id, offenders] : rules) {
      if (offenders.faces.empty()) continue;
      const auto level = static_cast<std::size_t>(offenders.severity);
      const validate::Rule* rule = validate::find_rule(id);
      sorts.push_back({fmt::format("{} {}", id, offenders.alias),
                       fmt::format("{}: {}", scene::name(offenders.severity), rule != nullptr ? rule->title : ""),
                       kColours[level][used[level]++ % kColours[level].size()]});
      for (const FaceId face : offenders.faces) {
        add(face);
        named[face] = true;
      }
    }
    sorts.push_back({"no finding", "no rule names these faces", kRest});
    for (FaceId face = 0; face < named.size(); ++face) {
      if (!named[face]) add(face);
    }
  }

  /// Faces that no file can hold are left out.
  scene::Scene take() {
    put_into_sorts(scene_, sorts, sort_of_face_);
    scene::drop_bad_faces(scene_);
    return std::move(scene_);
  }

  std::vector<FaceSort> sorts;

 private:
  void add(FaceId face) {
    scene_.faces.push_back(original_.faces[face]);
    sort_of_face_.push_back(sorts.size() - 1);
  }

  const scene::Scene& original_;
  scene::Scene scene_;
  std::vector<std::size_t> sort_of_face_;
};

}  // namespace

std::string write_offenders(const std::string& path, const Model& model,
                            const std::optional<geom::ToleranceRequest>& tolerance) {
  OffenderScene scene(model.content.scene);
  scene.add_rules(offenders_of(model.report.result.findings));
  const ConvertedFaces shown = faces_for(scene.take(), true, tolerance);
  if (!shown.problem.empty()) return path + ": not written: " + shown.problem;
  if (shown.scene.faces.empty()) return path + ": not written, the model has no face to show";
  return write_annotated(path, shown.scene, scene.sorts, std::nullopt);
}

std::string annotate(const LintCommand& command, RunSettings& settings, const report::Report& report) {
  if (report.inputs.size() != 1) return "--annotate shows one model; name one file";
  const std::string& path = report.inputs.front().path;
  const auto asked = settings.of(path);
  Model model = read_model(path, asked->model);
  judge_with_waivers(model, asked->lint);
  std::set<std::string> shown;
  for (const scene::Finding& finding : report.inputs.front().result.findings) shown.insert(finding.fingerprint);
  std::erase_if(model.report.result.findings,
                [&](const scene::Finding& finding) { return !shown.contains(finding.fingerprint); });
  return write_offenders(command.annotate, model, asked->model.tolerance);
}

}  // namespace rad::cli
