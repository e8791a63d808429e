#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/diff_report.h"
#include "report/place_text.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

constexpr std::size_t kListed = 20;          // findings of a status and file
constexpr std::size_t kRoomForRemark = 300;  // bytes

std::string headline(const Diff& diff) {
  const Counts worse = regressions(diff);
  std::string out =
      fmt::format("<!-- radlint-diff -->\n## radlint: {}\n\n{} at stage `{}`.\n", fails(diff) ? "**FAIL**" : "pass",
                  diff_counts_text(counts(diff)), validate::name(diff.now->stage));
  if (worse.errors + worse.warnings + worse.notes > 0) out += fmt::format("New or worse: {}.\n", counts_text(worse));
  return out;
}

std::string rule_table(const Diff& diff) {
  std::map<std::string_view, DiffCounts> rules;
  for (const DiffFile& file : diff.files) {
    for (const DiffRow& row : file.rows) ++rules[row.shown().rule].of[static_cast<std::size_t>(row.status)];
  }
  if (rules.empty()) return {};
  std::string out = "\n| Rule | What | New | Changed | Fixed | Unchanged |\n|---|---|--:|--:|--:|--:|\n";
  for (const auto& [id, counts] : rules) {
    const validate::Rule* rule = validate::find_rule(id);
    out += fmt::format("| {} `{}` | {} | {} | {} | {} | {} |\n", id, rule != nullptr ? rule->alias : "",
                       markdown_text(rule != nullptr ? rule->title : ""), counts[DiffStatus::New],
                       counts[DiffStatus::Changed], counts[DiffStatus::Fixed], counts[DiffStatus::Unchanged]);
  }
  return out;
}

std::string row_text(const DiffRow& row) {
  const scene::Finding& finding = row.shown();
  std::string where = markdown_code(place_text(finding.where));
  if (const std::string point = point_text(finding.where); !point.empty()) where += " at " + point;
  std::string what = markdown_text(finding.message);
  if (!row.change.empty()) what += fmt::format(" ({})", markdown_text(row.change));
  return fmt::format("| {} | {} | {} | {} |\n", scene::name(finding.severity), finding.rule, where, what);
}

std::string list_of(const DiffFile& file, DiffStatus status) {
  const DiffCounts sum = counts(file);
  if (sum[status] == 0) return {};
  std::string title(name(status));
  title.front() = static_cast<char>(title.front() - 'a' + 'A');
  std::string out = fmt::format("\n#### {}\n\n| Severity | Rule | Where | What |\n|---|---|---|---|\n", title);
  std::size_t listed = 0;
  for (const DiffRow& row : file.rows) {
    if (row.status == status && listed++ < kListed) out += row_text(row);
  }
  if (listed > kListed) out += fmt::format("\n… and {}.\n", counted(listed - kListed, "more", "more"));
  return out;
}

std::string section_of(const DiffFile& file) {
  std::string lists;
  for (const DiffStatus status : {DiffStatus::New, DiffStatus::Changed, DiffStatus::Fixed})
    lists += list_of(file, status);
  if (lists.empty()) return {};
  std::string out = fmt::format("\n### {}\n", markdown_code(diff_paths_text(file)));
  if (const std::string text = diff_tolerance_text(file); !text.empty())
    out += fmt::format("\n{}.\n", markdown_text(text));
  return out + lists;
}

}  // namespace

std::string diff_markdown(const Diff& diff, std::size_t limit) {
  std::string out = headline(diff) + rule_table(diff);
  for (const std::string& gap : gaps(diff)) {
    if (out.size() + gap.size() + kRoomForRemark < limit)
      out += fmt::format("\nJudged in part: {}\n", markdown_text(gap));
  }
  std::size_t left_out = 0;
  for (const DiffFile& file : diff.files) {
    const std::string section = section_of(file);
    if (out.size() + section.size() + kRoomForRemark > limit) {
      ++left_out;
    } else {
      out += section;
    }
  }
  if (left_out > 0) out += fmt::format("\nThe findings of {} are left out here.\n", counted(left_out, "file"));
  return out;
}

}  // namespace rad::report
