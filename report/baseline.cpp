#include "report/baseline.h"

#include <algorithm>

#include "report/comparison.h"
#include "report/json_parts.h"
#include "report/pair_inputs.h"
#include "report/place_text.h"

namespace rad::report {

namespace {

using scene::BaselineState;
using scene::Finding;

std::vector<std::string> paths_of(const Report& report) {
  std::vector<std::string> paths;
  for (const InputReport& input : report.inputs) paths.push_back(input.path);
  return paths;
}

/// Divides the findings of `now` by what `old` knows; returns what of `old` does not occur.
std::vector<std::size_t> divide(const InputReport& old, InputReport& now) {
  std::vector<Finding>& findings = now.result.findings;
  const Comparison comparison(old, now);
  const Matching matching = comparison.matching();
  std::vector<BaselineState> states(findings.size(), BaselineState::New);
  for (const Match& match : matching.matches) {
    const BaselineState state = comparison.change_of(match).worse ? BaselineState::Grown : BaselineState::Known;
    for (const Finding* finding : match.now) states[static_cast<std::size_t>(finding - findings.data())] = state;
  }
  std::vector<std::size_t> stale;
  for (const Finding* finding : matching.only_old) {
    if (comparison.is_of_format(*finding)) continue;
    stale.push_back(static_cast<std::size_t>(finding - old.result.findings.data()));
  }
  std::vector<Finding> left;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    findings[i].baseline = states[i];
    (states[i] == BaselineState::Known ? now.known : left).push_back(std::move(findings[i]));
  }
  findings = std::move(left);
  return stale;
}

// Lines, bytes and faces change with every export and decide nothing.
Report without_records(Report report, const std::string& folder) {
  report.max_issues = 0;
  for (InputReport& input : report.inputs) {
    input.path = relative_path(input.path, folder);
    for (Finding& finding : input.result.findings) {
      finding.where.file = relative_path(finding.where.file, folder);
      finding.where.line = 0;
      finding.where.byte_offset.reset();
      finding.where.faces.clear();
    }
  }
  return report;
}

}  // namespace

std::vector<BaselineUse> apply_baseline(const Report& baseline, Report& report) {
  std::vector<BaselineUse> uses;
  for (const PathPair& pair : pair_paths(paths_of(baseline), paths_of(report))) {
    if (!pair.now) continue;
    InputReport& now = report.inputs[*pair.now];
    if (pair.old) {
      uses.push_back({*pair.now, *pair.old, divide(baseline.inputs[*pair.old], now)});
    } else {
      for (Finding& finding : now.result.findings) finding.baseline = BaselineState::New;
    }
  }
  return uses;
}

Report pruned(Report baseline, const std::vector<BaselineUse>& uses) {
  for (const BaselineUse& use : uses) {
    std::vector<Finding>& findings = baseline.inputs[use.entry].result.findings;
    for (auto index = use.stale.rbegin(); index != use.stale.rend(); ++index) {
      findings.erase(findings.begin() + static_cast<std::ptrdiff_t>(*index));
    }
  }
  return baseline;
}

std::string baseline_json(const Report& report, const std::string& folder) {
  const Report plain = without_records(report, folder);
  Json head = report_json(plain, false);
  std::string lines;
  for (const Json& finding : head["findings"]) {
    lines += (lines.empty() ? "\n    " : ",\n    ") + finding.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  head["findings"] = Json::array();
  std::string text = written(head);
  if (lines.empty()) return text;
  constexpr std::string_view kEmpty = "\n  \"findings\": []";  // quotes inside of strings are escaped
  const std::size_t place = text.find(kEmpty) + kEmpty.size() - 1;
  return text.insert(place, lines + "\n  ");
}

}  // namespace rad::report
