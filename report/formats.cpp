#include "report/formats.h"

#include <algorithm>
#include <array>

#include "report/concise.h"
#include "report/csv.h"
#include "report/github.h"
#include "report/html/page.h"
#include "report/json.h"
#include "report/junit.h"
#include "report/leak_line.h"
#include "report/markdown.h"
#include "report/sarif.h"

namespace rad::report {

namespace {

constexpr std::array<ReportFormat, 11> kFormats = {{
    {"text", "for people", Detail::Findings, false,
     [](const Report& report, const WriteOptions& options) { return text(report, options.text); }},
    {"concise", "a line for each finding, as compilers write them", Detail::Findings, false,
     [](const Report& report, const WriteOptions&) { return concise(report); }},
    {"json", "everything, report.schema.json", Detail::Faces, true,
     [](const Report& report, const WriteOptions& options) { return json(report, options.timings); }},
    {"jsonl", "the same, a line for each model", Detail::Faces, true,
     [](const Report& report, const WriteOptions& options) { return json_lines(report, options.timings); }},
    {"sarif", "SARIF 2.1.0, for code scanning", Detail::Faces, false,
     [](const Report& report, const WriteOptions& options) { return sarif(report, options); }},
    {"junit", "JUnit XML: a suite for each model, a case for each rule", Detail::Findings, false,
     [](const Report& report, const WriteOptions& options) { return junit(report, options.timings); }},
    {"github", "annotations of GitHub Actions, then text", Detail::Findings, false, github},
    {"markdown", "for a comment on a pull request", Detail::Findings, false,
     [](const Report& report, const WriteOptions&) { return markdown(report); }},
    {"html", "one page with the faults drawn over the model", Detail::Drawings, true,
     [](const Report& report, const WriteOptions&) { return html::page(report); }},
    {"csv", "a row for each finding", Detail::Faces, false,
     [](const Report& report, const WriteOptions&) { return csv(report); }},
    {"leak-line", "OBJ with the lines of sight of RL113", Detail::Findings, false,
     [](const Report& report, const WriteOptions&) { return leak_lines(report); }},
}};

}  // namespace

std::span<const ReportFormat> report_formats() { return kFormats; }

const ReportFormat* find_report_format(std::string_view name) {
  const auto* found = std::ranges::find(kFormats, name, &ReportFormat::name);
  return found == kFormats.end() ? nullptr : found;
}

std::string report_format_names() {
  std::string names;
  for (const ReportFormat& format : kFormats) {
    if (!names.empty()) names += ", ";
    names += format.name;
  }
  return names;
}

}  // namespace rad::report
