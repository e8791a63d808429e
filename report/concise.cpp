#include "report/concise.h"

#include <fmt/format.h>

#include "report/place_text.h"
#include "report/text.h"
#include "report/text_layout.h"

namespace rad::report {

namespace {

std::string line_of(const scene::Finding& finding) {
  const std::string point = point_text(finding.where);
  return fmt::format("{}: {}: {}{} [{} {}]\n", place_text(finding.where), scene::name(finding.severity),
                     printable(finding.message), point.empty() ? "" : " at " + point, finding.rule, finding.alias);
}

}  // namespace

std::string concise(const Report& report) {
  std::string out;
  for (const InputReport& input : report.inputs) {
    for (const scene::Finding& finding : input.result.findings) out += line_of(finding);
    if (input.result.incomplete.empty()) continue;
    out += fmt::format("{}: judged in part: {}\n", printable(input.path), printable(input.result.incomplete));
  }
  return out + fmt::format("{} in {}\n", counts_text(counts(report)), counted(report.inputs.size(), "file"));
}

}  // namespace rad::report
