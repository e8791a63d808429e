#include "report/html/page.h"

#include <fmt/format.h>

#include "report/html/assets.h"
#include "report/html/escape.h"
#include "report/html/finding_list.h"
#include "report/html/markup.h"
#include "report/html/overview.h"
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

std::string head(const Report& report) {
  const bool pass = counts(report).errors == 0;
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; style-src '{}'; "
      "img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"{} {}\">\n<title>{} {} – {}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n<body>\n",
      page_script().hash, page_style().hash, escaped(report.tool), tool_version(), pass ? "✓" : "✗",
      escaped(title_of(report)), escaped(report.tool), page_style().text);
}

std::string banner(const Report& report) {
  return fmt::format(
      "<a class=\"skip\" href=\"#findings\">Skip to the findings</a>\n"
      "<header class=\"banner\"><p class=\"tool\">{} {}</p><h1>{}</h1></header>\n",
      escaped(report.tool), tool_version(), escaped(title_of(report)));
}

std::size_t size_of(const ModelView& view) {
  std::size_t bytes = view.geometry.bytes.size() + view.overview.png.size();
  for (const FaultView& fault : view.faults) bytes += fault.picture.png.size();
  return bytes;
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
  std::string out = "<div class=\"list\" id=\"findings\" tabindex=\"-1\">\n";
  for (std::size_t i = 0; i < report.inputs.size(); ++i) {
    const bool left_out = views[i] == nullptr && report.inputs[i].view;
    out += model_section(report, i, views[i],
                         left_out ? "No picture of this model: the page would become too large." : "");
  }
  return out + "</div>\n";
}

std::string data(const Report& report, const std::vector<const ModelView*>& views) {
  std::string out = fmt::format("<script type=\"application/json\" id=\"report\">{}</script>\n",
                                script_json(Json::parse(json(report))));
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i] == nullptr) continue;
    const auto findings = listed_findings(report.inputs[i], report.max_issues);
    out += fmt::format("<script type=\"text/plain\" class=\"view\" data-model=\"{}\">{}</script>\n", i,
                       base64(compressed(script_json(view_json(*views[i], findings)))));
    out += fmt::format("<script type=\"text/plain\" class=\"geometry\" data-model=\"{}\">{}</script>\n", i,
                       base64(views[i]->geometry.bytes));
  }
  return out;
}

}  // namespace

std::string page(const Report& report) {
  const std::vector<const ModelView*> views = shown_views(report);
  std::string out = head(report) + banner(report) + "<main>\n";
  out += verdict(report) + requirement_table(report) + file_table(report);
  out += "<div class=\"work\">\n" + sections(report, views) + "<aside class=\"stage\" hidden></aside>\n</div>\n";
  out += "</main>\n<footer><p>Made by " + escaped(report.tool) + " " + std::string(tool_version()) +
         ". This file asks nothing of the network.</p></footer>\n";
  out += data(report, views);
  out += "<script>";
  out += page_script().text;
  out += "</script>\n</body>\n</html>\n";
  return out;
}

}  // namespace rad::report::html
