#include "report/listed_findings.h"

#include <map>

namespace rad::report {

std::vector<const scene::Finding*> listed_findings(const InputReport& input, std::size_t max_issues) {
  std::vector<const scene::Finding*> findings;
  std::map<std::string_view, std::size_t> listed;
  for (const scene::Finding& finding : input.result.findings) {
    if (max_issues == 0 || ++listed[finding.rule] <= max_issues) findings.push_back(&finding);
  }
  return findings;
}

}  // namespace rad::report
