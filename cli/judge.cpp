#include "cli/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>

#include "config/sidecar.h"
#include "validate/rules.h"
#include "validate/tool_finding.h"

namespace rad::cli {

namespace {

std::uint64_t size_of(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

bool is_finite(const scene::dvec3& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

geom::Box box_of(const scene::Scene& scene) {
  geom::Box box;
  for (const scene::VertexId corner : scene.corners) {
    if (is_finite(scene.vertices[corner])) box.add(scene.vertices[corner]);
  }
  return box;
}

/// The rules chosen, and RL001: a file of which nothing could be read must not pass for want of rules.
validate::LintOptions with_parse_errors(validate::LintOptions options) {
  for (const validate::Rule* rule : validate::all_rules()) {
    const bool chosen = std::ranges::find(options.rules, rule) != options.rules.end();
    if (rule->reports == scene::ReadIssueKind::ParseError && !chosen) options.rules.insert(options.rules.begin(), rule);
  }
  return options;
}

void apply(const ModelOptions& options, scene::Scene& scene, report::InputReport& report) {
  using report::ValueSource;
  if (scene.metres_per_unit) report.units_source = ValueSource::Declared;
  if (options.metres_per_unit) {
    scene.metres_per_unit = options.metres_per_unit;
    report.units_source = ValueSource::Given;
  }
  if (scene.up != scene::UpAxis::Unknown) report.up_source = ValueSource::Declared;
  if (options.up != scene::UpAxis::Unknown) {
    scene.up = options.up;
    report.up_source = ValueSource::Given;
  }
  report.metres_per_unit = scene.metres_per_unit;
  report.up = scene.up;
}

void describe(Model& model, const std::string& path, const ModelOptions& options) {
  scene::Scene& scene = model.content.scene;
  model.report.path = path;
  model.report.format = scene.format;
  model.report.read = !scene.faces.empty() || !model.content.issues.any(scene::ReadIssueKind::ParseError);
  model.report.box = box_of(scene);
  apply(options, scene, model.report);
}

}  // namespace

Model read_model(const std::string& path, const ModelOptions& options) {
  Model model;
  const auto start = std::chrono::steady_clock::now();
  model.content = readers::read_file(path == kStream ? "/dev/stdin" : path, {}, options.reading);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (path == kStream) model.content.scene.path = path;
  describe(model, path, options);
  model.report.bytes = size_of(path);
  model.report.result.timings.emplace_back("read", taken.count());
  return model;
}

Model read_model_text(std::string_view text, const ModelOptions& options) {
  Model model;
  readers::Input input;
  input.path = kStream;
  input.bytes = text;
  model.content = readers::read_bytes(input);
  describe(model, input.path, options);
  model.report.bytes = text.size();
  return model;
}

Model model_of(scene::Scene scene, const std::string& path) {
  Model model;
  model.content.scene = std::move(scene);
  model.content.scene.path = path;
  describe(model, path, {});
  return model;
}

void judge(Model& model, const validate::LintOptions& options) {
  validate::LintResult result = validate::lint(model.content.scene, model.content.issues,
                                               model.report.read ? options : with_parse_errors(options));
  const validate::Timings& reading = model.report.result.timings;
  result.timings.insert(result.timings.begin(), reading.begin(), reading.end());
  model.report.result = std::move(result);
}

void judge_with_waivers(Model& model, validate::LintOptions options) {
  const std::string sidecar = config::sidecar_path(model.report.path);
  // What stands nearest to the fault is said to have silenced it.
  std::vector<scene::Waiver> waivers = model.content.waivers;
  std::ranges::move(config::read_sidecar(sidecar), std::back_inserter(waivers));
  std::ranges::move(options.waivers, std::back_inserter(waivers));
  options.waivers = std::move(waivers);
  model.content.companions.emplace_back(sidecar);
  judge(model, options);
}

report::InputReport undecided(const std::string& path, const std::string& why, const validate::LintOptions& options) {
  report::InputReport report;
  report.path = path;
  report.bytes = size_of(path);
  report.result.incomplete = why;
  scene::Where where;
  where.file = path;
  report.result.findings.push_back(validate::tool_finding(validate::undecided, why, std::move(where)));
  report.result.findings.back().severity = validate::severity_of_tool_rule(validate::undecided, options);
  return report;
}

std::string error_rules(std::span<const scene::Finding> findings) {
  std::map<std::string, std::size_t> rules;
  for (const scene::Finding& finding : findings) {
    if (finding.severity == scene::Severity::Error) ++rules[fmt::format("{} {}", finding.rule, finding.alias)];
  }
  std::string text;
  for (const auto& [rule, count] : rules) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, rule);
  }
  return text;
}

}  // namespace rad::cli
