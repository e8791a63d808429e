#include "report/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/place_text.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

constexpr std::size_t kListedOfRule = 10;    // findings of a rule in a file's table
constexpr std::size_t kRoomForRemark = 200;  // bytes

std::string headline(const Report& report) {
  const Counts sum = counts(report);
  const std::uint64_t known = known_findings(report), suppressed = suppressed_findings(report);
  return fmt::format("<!-- {0}-report -->\n## {0}: {1}\n\n{2} in {3} at stage `{4}`.\n", report.tool,
                     sum.errors == 0 ? "pass" : "**FAIL**", counts_text(sum), counted(report.inputs.size(), "file"),
                     validate::name(report.stage)) +
         (known > 0 ? fmt::format("{} in the baseline and not listed.\n", counted(known, "finding is", "findings are"))
                    : std::string()) +
         (suppressed > 0
              ? fmt::format("{} suppressed and not listed.\n", counted(suppressed, "finding is", "findings are"))
              : std::string());
}

std::string rule_table(const Report& report) {
  const std::vector<RuleTotal> totals = rule_totals(report);
  if (totals.empty()) return {};
  std::string out = "\n| Severity | Rule | What | Findings | Places | Repair |\n|---|---|---|--:|--:|---|\n";
  for (const scene::Severity severity : {scene::Severity::Error, scene::Severity::Warning, scene::Severity::Note}) {
    for (const RuleTotal& total : totals) {
      if (total.severity != severity) continue;
      const validate::Rule* rule = validate::find_rule(total.rule);
      out += fmt::format("| {} | {} `{}` | {} | {} | {} | {} |\n", scene::name(severity), total.rule,
                         rule != nullptr ? rule->alias : "", markdown_text(rule != nullptr ? rule->title : ""),
                         total.findings, total.places,
                         rule != nullptr ? fix_text({rule->fix, rule->fix_operation}) : std::string());
    }
  }
  return out;
}

std::string file_row(const InputReport& input) {
  const Counts sum = counts(input);
  return fmt::format("| {} | {} | {} | {} |\n", markdown_code(input.path), sum.errors, sum.warnings, sum.notes);
}

std::string finding_row(const scene::Finding& finding) {
  std::string where = markdown_code(place_text(finding.where));
  if (const std::string point = point_text(finding.where); !point.empty()) where += " at " + point;
  return fmt::format("| {} | {} | {} | {} |\n", scene::name(finding.severity), finding.rule, where,
                     markdown_text(finding.message));
}

std::string finding_table(const InputReport& input) {
  std::string out =
      fmt::format("\n### {}\n\n| Severity | Rule | Where | What |\n|---|---|---|---|\n", markdown_code(input.path));
  std::map<std::string_view, std::size_t> listed;
  std::size_t more = 0;
  for (const scene::Finding& finding : input.result.findings) {
    if (++listed[finding.rule] > kListedOfRule) {
      ++more;
    } else {
      out += finding_row(finding);
    }
  }
  if (more > 0) out += fmt::format("\n… and {} of the same rules.\n", counted(more, "finding"));
  return out;
}

void append_incomplete(std::string& out, const Report& report, std::size_t limit) {
  for (const InputReport& input : report.inputs) {
    if (input.result.incomplete.empty() || out.size() + kRoomForRemark > limit) continue;
    out += fmt::format("\n{} was judged in part: {}\n", markdown_code(input.path),
                       markdown_text(shortened(printable(input.result.incomplete), kRoomForRemark / 2)));
  }
}

void append_file_table(std::string& out, const Report& report, std::size_t limit) {
  if (report.inputs.size() < 2) return;
  out += "\n| File | Errors | Warnings | Notes |\n|---|--:|--:|--:|\n";
  std::size_t left_out = 0;
  for (const InputReport& input : report.inputs) {
    const std::string row = file_row(input);
    if (left_out > 0 || out.size() + row.size() + kRoomForRemark > limit) {
      ++left_out;
    } else {
      out += row;
    }
  }
  if (left_out > 0) out += fmt::format("\n{} left out of this table.\n", counted(left_out, "file"));
}

void append_findings_of_files(std::string& out, const Report& report, std::size_t limit) {
  std::size_t left_out = 0;
  for (const InputReport& input : report.inputs) {
    if (input.result.findings.empty()) continue;
    const std::string table = finding_table(input);
    if (out.size() + table.size() + kRoomForRemark > limit) {
      ++left_out;
    } else {
      out += table;
    }
  }
  if (left_out > 0) out += fmt::format("\nThe findings of {} are left out here.\n", counted(left_out, "file"));
}

}  // namespace

std::string markdown(const Report& report, std::size_t limit) {
  std::string out = headline(report) + rule_table(report);
  append_incomplete(out, report, limit);
  append_file_table(out, report, limit);
  append_findings_of_files(out, report, limit);
  return out;
}

}  // namespace rad::report
