#include "report/leak_line.h"

#include <fmt/format.h>

#include "report/text_layout.h"
#include "validate/rules.h"

namespace rad::report {

std::string leak_lines(const Report& report) {
  std::string out = "# lines of sight from lit space to the backs of invalid facades, found by radlint\n";
  std::size_t vertices = 0;
  for (const InputReport& input : report.inputs) {
    out += fmt::format("# {}\n", printable(input.path));
    for (const scene::Finding& finding : input.result.findings) {
      if (finding.rule != validate::invalid_facade.id || !finding.where.segment) continue;
      out += fmt::format("o {}-{}\n", finding.rule, finding.fingerprint);
      for (const geom::dvec3& end : *finding.where.segment) out += fmt::format("v {} {} {}\n", end.x, end.y, end.z);
      out += fmt::format("l {} {}\n", vertices + 1, vertices + 2);
      vertices += 2;
    }
  }
  return out;
}

}  // namespace rad::report
