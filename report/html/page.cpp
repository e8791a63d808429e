#include "report/html/page.h"

#include <fmt/format.h>

#include "report/html/escape.h"
#include "report/html/finding_list.h"
#include "report/html/overview.h"
#include "report/html/shell.h"
#include "report/html/view_data.h"
#include "report/json.h"
#include "report/listed_findings.h"
#include "report/text_layout.h"

namespace rad::report::html {
namespace {

std::string title_of(const Report& report) {
  if (report.inputs.size() == 1) return report.inputs.front().path;
  return counted(report.inputs.size(), "file");
}

/// Views as far as the page has room for them, in the order of the inputs.
std::vector<const ModelView*> shown_views(const Report& report) {
  std::vector<const ModelView*> views;
  std::size_t room = kPageBudget;
  for (const InputReport& input : report.inputs) {
    const bool fits = input.view && size_of(*input.view) <= room;
    if (fits) room -= size_of(*input.view);
    views.push_back(fits ? input.view.get() : nullptr);
  }
  return views;
}

std::string sections(const Report& report, const std::vector<const ModelView*>& views) {
  std::string out;
  for (std::size_t i = 0; i < report.inputs.size(); ++i) {
    const bool left_out = views[i] == nullptr && report.inputs[i].view;
    out += model_section(report, i, views[i],
                         left_out ? "No picture of this model: the page would become too large." : "");
  }
  return out;
}

std::string data(const Report& report, const std::vector<const ModelView*>& views) {
  std::string out = fmt::format("<script type=\"application/json\" id=\"report\">{}</script>\n",
                                script_json(Json::parse(json(report))));
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i] == nullptr) continue;
    const auto findings = listed_findings(report.inputs[i], report.max_issues);
    out += view_elements(*views[i], findings, views[i]->geometry, i, "now");
  }
  return out;
}

}  // namespace

std::string page(const Report& report) {
  const std::vector<const ModelView*> views = shown_views(report);
  Shell shell;
  shell.tool = report.tool;
  shell.title = title_of(report);
  shell.pass = counts(report).errors == 0;
  shell.verdict = verdict(report);
  shell.overview = requirement_table(report) + file_table(report);
  shell.list = sections(report, views);
  shell.data = data(report, views);
  return whole_page(shell);
}

}  // namespace rad::report::html
