#include "validate/lint.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "validate/context.h"
#include "validate/grouping.h"
#include "validate/rules.h"
#include "validate/tool_finding.h"

namespace rad::validate {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(Timings& timings) : timings_(timings) {}

  void lap(std::string step) {
    const auto now = std::chrono::steady_clock::now();
    timings_.emplace_back(std::move(step), std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  Timings& timings_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

ModelFigures figures_of(const Context& context) {
  ModelFigures figures;
  figures.vertices = context.scene.vertices.size();
  figures.faces = context.scene.faces.size();
  figures.triangles = context.triangles.triangles.size();
  figures.objects = context.topology.components.size();
  std::set<scene::MaterialId> used;
  for (const scene::Face& face : context.scene.faces) {
    used.insert(face.material);
    if (context.scene.materials[face.material].emits()) ++figures.emitters;
  }
  figures.materials = used.size();
  return figures;
}

std::vector<scene::Finding> findings_of(const Rule& rule, const Severities& severities, const Context& context,
                                        bool group) {
  if (rule.reports) return findings_of_issues(rule, severities.usual, context.scene, context.issues);
  Violations violations;
  rule.check(context, violations);
  return group_violations(rule, severities, context, violations, group);
}

std::optional<scene::Severity> severity_of(const Rule& rule, Stage stage, const scene::Scene& scene) {
  const auto severity = severity_at(rule, stage);
  if (severity && rule.note_where_triangles_only && scene.triangles_only) return scene::Severity::Note;
  return severity;
}

void run_rules(const Context& context, const LintOptions& options, LintResult& result, Stopwatch& stopwatch) {
  for (const Rule* rule : options.rules) {
    const auto severity = severity_of(*rule, options.stage, context.scene);
    if (!severity || rule->of_tool) continue;
    result.checked.push_back(rule);
    const Severities severities{*severity, options.light ? *grave_severity_at(*rule, options.stage) : *severity};
    auto findings = findings_of(*rule, severities, context, options.group);
    result.findings.insert(result.findings.end(), std::make_move_iterator(findings.begin()),
                           std::make_move_iterator(findings.end()));
    stopwatch.lap(std::string(rule->id));
  }
}

// Says among the findings too what was not judged to the end.
void finish(const LintOptions& options, const scene::Scene& scene, LintResult& result) {
  if (!result.incomplete.empty() && std::ranges::find(options.rules, &undecided) != options.rules.end()) {
    scene::Where where;
    where.file = scene.path;
    result.findings.push_back(tool_finding(undecided, result.incomplete, std::move(where)));
  }
  sort_findings(result.findings);
  number_equal_fingerprints(result.findings);
}

}  // namespace

LintResult lint(const scene::Scene& scene, const scene::ReadIssues& issues, const LintOptions& options) {
  LintResult result;
  Stopwatch stopwatch(result.timings);
  const auto lap = [&](std::string_view step) { stopwatch.lap(std::string(step)); };
  std::optional<Context> context = build_context(scene, issues, options.tolerance, result.refusal, lap);
  if (!context) return result;
  context->parameters = options.parameters;
  if (!context->model.points.empty()) {
    result.tolerance = context->tolerance;
    result.pitch = context->model.lattice.pitch;
    result.lattice_origin = context->model.lattice.origin;
  }
  if (context->contacts.truncated) {
    result.incomplete =
        "faces crowd so densely that not every pair was tested: the rules on contacts and connectivity "
        "may have missed some";
  }
  result.figures = figures_of(*context);
  run_rules(*context, options, result, stopwatch);
  finish(options, scene, result);
  return result;
}

}  // namespace rad::validate
