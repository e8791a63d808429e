#include "report/html/diff_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/diff_report.h"
#include "report/html/escape.h"
#include "report/html/finding_item.h"
#include "report/html/markup.h"
#include "report/html/page.h"
#include "report/html/shell.h"
#include "report/html/view_data.h"
#include "report/listed_findings.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/registry.h"
#include "validate/stage.h"

namespace rad::report::html {
namespace {

using scene::Finding;

/// One side of a model: what may be shown of it, and the numbers of its faults there.
struct Side {
  const ModelView* view = nullptr;
  std::vector<const Finding*> listed;
  std::map<const Finding*, std::size_t> numbers;

  Side(const Report& report, const InputReport* input, std::size_t& room) {
    if (input == nullptr || !input->view || size_of(*input->view) > room) return;
    room -= size_of(*input->view);
    view = input->view.get();
    listed = listed_findings(*input, report.max_issues);
    for (std::size_t i = 0; i < listed.size(); ++i) numbers.emplace(listed[i], i);
  }

  /// Number of the first of these findings that the view knows; empty for none.
  [[nodiscard]] std::string number(const std::vector<const Finding*>& findings) const {
    for (const Finding* finding : findings) {
      if (const auto found = numbers.find(finding); found != numbers.end()) return std::to_string(found->second);
    }
    return {};
  }
};

struct Pair {
  Side old;
  Side now;
};

std::string_view heading(DiffStatus status) {
  switch (status) {
    case DiffStatus::New:
      return "New";
    case DiffStatus::Changed:
      return "Changed";
    case DiffStatus::Fixed:
      return "Fixed";
    case DiffStatus::Unchanged:
      return "Unchanged";
    case DiffStatus::Format:
      break;
  }
  return "On one side only because the formats differ";
}

std::string remark_on(const DiffRow& row) {
  std::string text = row.change;
  if (row.moved > 0) text += fmt::format("{}moved by {}", text.empty() ? "" : "; ", short_number(row.moved));
  return text;
}

std::string row_item(const DiffFile& file, const DiffRow& row, const Pair& sides, std::size_t model,
                     std::size_t number) {
  const bool gone = row.now.empty();
  const std::string now = sides.now.number(row.now), old = sides.old.number(row.old);
  const Side& shown = gone ? sides.old : sides.now;
  const std::string& fault = gone ? old : now;
  ItemPlace place{.id = finding_id(model, number), .model = model, .fault = now};
  place.attributes = fmt::format(" data-status=\"{}\" data-old-fault=\"{}\"", name(row.status), old);
  place.remark = remark_on(row);
  if (!fault.empty()) place.view = &shown.view->faults[std::stoul(fault)];
  return finding_item(row.shown(), (gone ? *file.old : file.shown()).metres_per_unit, place);
}

std::string rule_line(const Finding& finding) {
  const validate::Rule* rule = validate::find_rule(finding.rule);
  return fmt::format("<h4>{} <span class=\"code\">{}</span> {}</h4>\n", severity_sign(finding.severity), finding.rule,
                     escaped(rule != nullptr ? rule->title : finding.alias));
}

/// All rows of a status. What stays as it was is folded away.
std::string status_section(const DiffFile& file, DiffStatus status, const Pair& sides, std::size_t model) {
  const std::uint64_t count = counts(file)[status];
  if (count == 0) return {};
  const bool folded = status == DiffStatus::Unchanged || status == DiffStatus::Format;
  const std::string title = fmt::format("{} ({})", heading(status), count);
  std::string out = fmt::format("<section class=\"rule\" data-status=\"{}\">\n", name(status));
  out += folded ? fmt::format("<details><summary>{}</summary>\n", title) : fmt::format("<h3>{}</h3>\n", title);
  std::string_view rule;
  for (std::size_t i = 0; i < file.rows.size(); ++i) {
    const DiffRow& row = file.rows[i];
    if (row.status != status) continue;
    if (row.shown().rule != rule) {
      if (!rule.empty()) out += "</ol>\n";
      rule = row.shown().rule;
      out += rule_line(row.shown()) + "<ol class=\"findings\">\n";
    }
    out += row_item(file, row, sides, model, i);
  }
  return out + "</ol>\n" + (folded ? "</details>" : "") + "</section>\n";
}

std::string file_section(const DiffFile& file, const Pair& sides, std::size_t model) {
  std::string out = fmt::format(
      "<section class=\"model\" id=\"model-{0}\" data-model=\"{0}\" data-path=\"{1}\" "
      "aria-labelledby=\"model-{0}-name\">\n<h2 id=\"model-{0}-name\">{1}</h2>\n<p class=\"tally\">{2}</p>\n",
      model, escaped(diff_paths_text(file)), escaped(diff_counts_text(counts(file))));
  if (const std::string text = diff_tolerance_text(file); !text.empty()) {
    out += fmt::format("<p class=\"remark\">{}</p>\n", escaped(text));
  }
  for (const DiffStatus status : kDiffStatuses) out += status_section(file, status, sides, model);
  return out + "</section>\n";
}

std::string verdict(const Diff& diff) {
  const bool pass = !fails(diff);
  const Counts worse = regressions(diff);
  std::string out = fmt::format(
      "<section class=\"verdict {}\" aria-labelledby=\"verdict\">\n<h2 id=\"verdict\" data-verdict=\"{}\">{}{}</h2>\n"
      "<p>{} at stage <code>{}</code></p>\n<ul class=\"counts\">",
      pass ? "pass" : "fail", pass ? "pass" : "fail", sign(pass ? Sign::Tick : Sign::Diamond),
      pass ? "Nothing got worse" : "Worse than before",
      worse == Counts{} ? std::string("Nothing is new or worse") : "New or worse: " + counts_text(worse),
      validate::name(diff.now->stage));
  const DiffCounts sum = counts(diff);
  for (const DiffStatus status : kDiffStatuses) {
    if (status == DiffStatus::Format && sum[status] == 0) continue;
    out += fmt::format("<li class=\"{0}\" data-status=\"{0}\" data-count=\"{1}\"><b>{1}</b> {0}</li>", name(status),
                       sum[status]);
  }
  out += "</ul>\n";
  for (const std::string& gap : gaps(diff)) out += fmt::format("<p>Judged in part: {}</p>\n", escaped(gap));
  return out + "</section>\n";
}

std::string data(const Pair& sides, std::size_t model) {
  const ModelView* leader = sides.now.view != nullptr ? sides.now.view : sides.old.view;
  std::string out;
  if (sides.old.view != nullptr)
    out += view_elements(*sides.old.view, sides.old.listed, leader->geometry, model, "old");
  if (sides.now.view != nullptr)
    out += view_elements(*sides.now.view, sides.now.listed, leader->geometry, model, "now");
  return out;
}

std::string title_of(const Diff& diff) {
  if (diff.files.size() == 1) return diff_paths_text(diff.files.front());
  return counted(diff.files.size(), "file") + " compared";
}

}  // namespace

std::string page(const Diff& diff) {
  Shell shell;
  shell.tool = diff.now->tool;
  shell.title = title_of(diff);
  shell.pass = !fails(diff);
  shell.verdict = verdict(diff);
  std::size_t room = kPageBudget;
  for (std::size_t i = 0; i < diff.files.size(); ++i) {
    const DiffFile& file = diff.files[i];
    Side now(*diff.now, file.now, room), old(*diff.old, file.old, room);
    const Pair sides{std::move(old), std::move(now)};
    shell.list += file_section(file, sides, i);
    shell.data += data(sides, i);
  }
  return whole_page(shell);
}

}  // namespace rad::report::html
