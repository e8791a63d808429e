#include "validate/lint.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "validate/context.h"
#include "validate/grouping.h"
#include "validate/rule_run.h"
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

void run_rules(Context& context, const LintOptions& options, LintResult& result, Stopwatch& stopwatch) {
  RuleRun run(context, options);
  for (const Rule* rule : options.rules) {
    if (run.run(*rule)) stopwatch.lap(std::string(rule->id));
  }
  run.finish(result);
}

// Says among the findings too what was not judged to the end.
void finish(const LintOptions& options, const scene::Scene& scene, LintResult& result) {
  if (!result.incomplete.empty() && std::ranges::find(options.rules, &undecided) != options.rules.end()) {
    scene::Where where;
    where.file = scene.path;
    result.findings.push_back(tool_finding(undecided, result.incomplete, std::move(where)));
    result.findings.back().severity = severity_of_tool_rule(undecided, options);
  }
  sort_findings(result.findings);
  number_equal_fingerprints(result.findings);
}

}  // namespace

scene::Severity severity_of_tool_rule(const Rule& rule, const LintOptions& options) {
  const auto given = options.severities.find(&rule);
  return given == options.severities.end() ? rule.severity : given->second;
}

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
