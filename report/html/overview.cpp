#include "report/html/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/html/escape.h"
#include "report/html/markup.h"
#include "report/next_step.h"
#include "report/requirements.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/promises.h"
#include "validate/stage.h"

namespace rad::report::html {
namespace {

using validate::Requirement;
using validate::Stage;

constexpr std::array kTableOne = {Stage::Preprocess, Stage::Solve, Stage::Display};

std::string lines_as_code(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const std::size_t remark = line.find("   (");
    out += fmt::format("<li><code>{}</code>{}</li>", escaped(line.substr(0, remark)),
                       remark == std::string_view::npos ? std::string() : " " + escaped(line.substr(remark + 3)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string count_badge(std::string_view severity, Sign shape, std::uint64_t count, std::string_view noun) {
  return fmt::format(R"(<li class="{} {}" data-count="{}">{}<b>{}</b> {}{}</li>)", severity,
                     count == 0 ? "none" : "some", count, sign(shape), count, noun, count == 1 ? "" : "s");
}

struct StatusText {
  std::string_view css_class;
  Sign shape;
  std::string_view word;
};

StatusText text_of(RequirementStatus status) {
  switch (status) {
    case RequirementStatus::Pass:
      return {"pass", Sign::Tick, "holds"};
    case RequirementStatus::Note:
      return {"note", Sign::Disc, "note"};
    case RequirementStatus::Warning:
      return {"warning", Sign::Triangle, "warning"};
    case RequirementStatus::Fail:
      return {"error", Sign::Diamond, "broken"};
    case RequirementStatus::NotAsked:
      return {"blank", Sign::Blank, "not asked"};
    case RequirementStatus::NotChecked:
      break;
  }
  return {"blank", Sign::Blank, "not checked"};
}

/// Table 1's cell.
std::string_view demand_at(Requirement requirement, Stage stage) {
  validate::Rule any;
  any.requirement = requirement;
  const auto severity = validate::severity_at(any, stage);
  if (!severity) return "–";
  constexpr std::array<std::string_view, 3> kWords{"generated", "desired", "required"};
  return kWords[static_cast<std::size_t>(*severity)];
}

/// The filters that Table 2 says generate it.
std::string made_by(Requirement requirement) {
  std::string text;
  for (const scene::Filter filter : scene::kFilters) {
    if (validate::table_two(filter, requirement) != validate::Cell::Generated) continue;
    text += fmt::format("{}<code>{}</code>", text.empty() ? "" : " ", scene::name(filter));
  }
  return text.empty() ? "the author" : text;
}

/// Counts behind their signs, in words for who does not see these.
std::string tallies(const Counts& sum) {
  std::string out;
  const auto add = [&](std::string_view severity, Sign shape, std::uint64_t count) {
    if (count == 0) return;
    out += fmt::format(R"(<span class="{0}" role="img" aria-label="{1}">{2}{3}</span>)", severity,
                       counted(count, severity), sign(shape), count);
  };
  add("error", Sign::Diamond, sum.errors);
  add("warning", Sign::Triangle, sum.warnings);
  add("note", Sign::Disc, sum.notes);
  return out;
}

std::string requirement_row(const RequirementSummary& summary) {
  const StatusText status = text_of(summary.status);
  std::string row = fmt::format(
      R"(<tr><th scope="row"><span class="code">{}</span> {}</th><td class="{}" data-status="{}">{}{}</td><td class="tallies">{}</td>)",
      validate::code(summary.requirement), escaped(validate::title(summary.requirement)), status.css_class,
      name(summary.status), sign(status.shape), status.word, tallies(summary.counts));
  for (const Stage stage : kTableOne) row += fmt::format("<td>{}</td>", demand_at(summary.requirement, stage));
  return row + fmt::format("<td>{}</td></tr>\n", made_by(summary.requirement));
}

std::string file_row(const InputReport& input, std::size_t index) {
  const Counts sum = counts(input);
  const bool pass = sum.errors == 0;
  return fmt::format(R"(<tr><th scope="row"><a href="#model-{}">{}</a></th><td class="{}">{}{}</td>)"
                     "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
                     "<td class=\"number\">{}</td></tr>\n",
                     index, escaped(input.path), pass ? "pass" : "error", sign(pass ? Sign::Tick : Sign::Diamond),
                     pass ? "passes" : "fails", sum.errors, sum.warnings, sum.notes, input.result.figures.faces);
}

}  // namespace

std::string verdict(const Report& report) {
  const Counts sum = counts(report);
  const bool pass = sum.errors == 0;
  std::string out = fmt::format(R"(<section class="verdict {}" aria-labelledby="verdict">)"
                                "\n<h2 id=\"verdict\" data-verdict=\"{}\">{}{}</h2>\n",
                                pass ? "pass" : "fail", pass ? "pass" : "fail", sign(pass ? Sign::Tick : Sign::Diamond),
                                pass ? "Passes" : "Fails");
  out += fmt::format("<p>{} at stage <code>{}</code>{}</p>\n", pass ? "No error" : "Not fit for a radiosity solution",
                     validate::name(report.stage),
                     pass && reaches(sum, report.fail_on)
                         ? fmt::format("; the run fails at severity {} (<code>--fail-on</code>)", name(report.fail_on))
                         : std::string());
  out += "<ul class=\"counts\">" + count_badge("error", Sign::Diamond, sum.errors, "error") +
         count_badge("warning", Sign::Triangle, sum.warnings, "warning") +
         count_badge("note", Sign::Disc, sum.notes, "note") + "</ul>\n";
  return out + fmt::format("<ul class=\"next\" aria-label=\"What to do next\">{}</ul>\n</section>\n",
                           lines_as_code(next_step(report)));
}

std::string requirement_table(const Report& report) {
  std::string out =
      "<section aria-labelledby=\"requirements\">\n<h2 id=\"requirements\">Requirements of radiosity</h2>\n"
      "<div class=\"scroll\"><table class=\"requirements\">\n<thead><tr><th scope=\"col\" "
      "rowspan=\"2\">Requirement</th>";
  out += fmt::format(
      "<th scope=\"col\" rowspan=\"2\">At stage {}</th><th scope=\"col\" rowspan=\"2\">Findings</th>"
      "<th scope=\"colgroup\" colspan=\"3\">Asked for by</th><th scope=\"col\" rowspan=\"2\">Made by</th></tr>\n<tr>",
      validate::name(report.stage));
  for (const Stage stage : kTableOne) out += fmt::format("<th scope=\"col\">{}</th>", validate::name(stage));
  out += "</tr></thead>\n<tbody>\n";
  for (const RequirementSummary& summary : requirement_summaries(report.inputs, report.stage)) {
    out += requirement_row(summary);
  }
  return out +
         "</tbody></table></div>\n<p class=\"remark\">After Tables 1 and 2 of Baum et al., <cite>Making radiosity "
         "usable</cite> (1991). <code>radfix</code> runs the filters.</p>\n</section>\n";
}

std::string file_table(const Report& report) {
  if (report.inputs.size() < 2) return {};
  std::string out =
      "<section aria-labelledby=\"files\">\n<h2 id=\"files\">Files</h2>\n<div class=\"scroll\"><table "
      "class=\"files\">\n"
      "<thead><tr><th scope=\"col\">File</th><th scope=\"col\">Verdict</th><th scope=\"col\">Errors</th>"
      "<th scope=\"col\">Warnings</th><th scope=\"col\">Notes</th><th scope=\"col\">Faces</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < report.inputs.size(); ++i) out += file_row(report.inputs[i], i);
  return out + "</tbody></table></div>\n</section>\n";
}

}  // namespace rad::report::html
