#include "report/html/finding_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "report/html/escape.h"
#include "report/html/finding_item.h"
#include "report/html/markup.h"
#include "report/listed_findings.h"
#include "report/text.h"
#include "report/text_header.h"
#include "report/text_layout.h"
#include "validate/registry.h"

namespace rad::report::html {
namespace {

using scene::Finding;

std::string explanation(const validate::Rule& rule) {
  std::string out = "<details class=\"rule-text\"><summary>What this means, and what to do</summary>";
  const auto paragraph = [&](std::string_view heading, std::string_view text) {
    out += fmt::format("<h4>{}</h4><p>{}</p>", heading, escaped(text));
  };
  paragraph("What", rule.doc.what);
  paragraph("Why it matters", rule.doc.why);
  paragraph("Fix", rule.doc.fix);
  paragraph("In your modeller", rule.doc.modeller);
  return out + fmt::format("<p class=\"remark\">More: <code>radlint rule {}</code></p></details>\n", rule.id);
}

struct Group {
  std::span<const Finding* const> listed;
  std::size_t first = 0;     ///< number of its first finding
  std::size_t findings = 0;  ///< with those that are not listed
  std::uint64_t places = 0;
};

std::string group_heading(const Group& group, const validate::Rule* rule, std::size_t input) {
  const Finding& first = *group.listed.front();
  std::string out = fmt::format(
      R"(<section class="rule" id="{}" data-rule="{}" data-severity="{}">)"
      "\n<h3>{} <span class=\"code\">{}</span> {}</h3>\n<p class=\"tally\">{} <span class=\"alias\">{}</span>{}</p>\n",
      rule_anchor(input, first), first.rule, scene::name(first.severity), severity_sign(first.severity), first.rule,
      escaped(rule != nullptr ? rule->title : first.alias),
      fmt::format("Requirement {}: {}, {}.", first.requirement, counted(group.findings, "finding"),
                  counted(group.places, "place")),
      escaped(first.alias), "");
  if (const std::string fix = fix_text(first.fix); !fix.empty()) {
    out += fmt::format("<p class=\"fix\">Fix: {}.</p>\n", escaped(fix));
  }
  if (rule != nullptr) out += explanation(*rule);
  return out;
}

std::string group_section(const InputReport& input, std::size_t input_index, const Group& group,
                          const ModelView* view) {
  std::string out = group_heading(group, validate::find_rule(group.listed.front()->rule), input_index);
  out += "<ol class=\"findings\">\n";
  for (std::size_t i = 0; i < group.listed.size(); ++i) {
    const std::size_t number = group.first + i;
    out += finding_item(*group.listed[i], input.metres_per_unit,
                        {.id = finding_id(input_index, number),
                         .model = input_index,
                         .fault = std::to_string(number),
                         .view = view != nullptr ? &view->faults[number] : nullptr});
  }
  out += "</ol>\n";
  if (group.listed.size() < group.findings) {
    out += fmt::format("<p class=\"remark\">{} more are not listed (<code>--max-issues 0</code> lists all).</p>\n",
                       group.findings - group.listed.size());
  }
  return out + "</section>\n";
}

Group group_at(const InputReport& input, std::span<const Finding* const> listed, std::size_t first) {
  const Finding& head = *listed[first];
  const auto alike = [&](const Finding& finding) {
    return finding.rule == head.rule && finding.severity == head.severity;
  };
  Group group;
  group.first = first;
  std::size_t end = first;
  while (end < listed.size() && alike(*listed[end])) ++end;
  group.listed = listed.subspan(first, end - first);
  for (const Finding& finding : input.result.findings) {
    if (!alike(finding)) continue;
    ++group.findings;
    group.places += finding.count;
  }
  return group;
}

/// The lines of the text report's header below the path.
std::string model_facts(const InputReport& input) {
  constexpr std::size_t kOneLine = 10'000;
  std::string header;
  append_header(header, input, Paint(false), kOneLine);
  std::string out = "<ul class=\"about\">";
  std::string_view rest = std::string_view(header).substr(std::min(header.find('\n'), header.size()));
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty()) out += fmt::format("<li>{}</li>", escaped(line));
    rest.remove_prefix(end);
  }
  return out + "</ul>\n";
}

std::string overview_figure(const InputReport& input, std::size_t index, const ModelView& view) {
  std::string out = fmt::format("<figure class=\"overview\" data-model=\"{}\">", index) +
                    image(view.overview, "The model with its most severe faults", "picture");
  out += "<figcaption>";
  out += input.result.findings.empty() ? "The model." : "The model with its most severe faults over it.";
  if (view.left_out > 0) {
    out += fmt::format(" The 3-D view shows {} of {} triangles: those at fault, and the largest of the others.",
                       view.triangles, view.triangles + view.left_out);
  }
  return out + "</figcaption></figure>\n";
}

}  // namespace

std::string model_section(const Report& report, std::size_t index, const ModelView* view, std::string_view room) {
  const InputReport& input = report.inputs[index];
  std::string out = fmt::format(
      "<section class=\"model\" id=\"model-{0}\" data-model=\"{0}\" data-path=\"{1}\" "
      "aria-labelledby=\"model-{0}-name\">\n"
      "<h2 id=\"model-{0}-name\">{2}</h2>\n",
      index, escaped(input.path), report.inputs.size() == 1 ? "Findings" : escaped(input.path));
  out += model_facts(input);
  if (view != nullptr) out += overview_figure(input, index, *view);
  if (!room.empty()) out += fmt::format("<p class=\"remark\">{}</p>\n", room);
  const auto listed = listed_findings(input, report.max_issues);
  if (listed.empty()) out += "<p class=\"clean\">Nothing was found.</p>\n";
  for (std::size_t first = 0; first < listed.size();) {
    const Group group = group_at(input, listed, first);
    out += group_section(input, index, group, view);
    first += group.listed.size();
  }
  return out + "</section>\n";
}

}  // namespace rad::report::html
