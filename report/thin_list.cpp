#include "report/thin_list.h"

#include <algorithm>

#include "validate/rules.h"

namespace rad::report {

std::vector<scene::Finding> thin_features(const InputReport& input) {
  std::vector<scene::Finding> thin;
  const auto add = [&](const scene::Finding& finding) {
    if (finding.rule == validate::thin_feature.id) thin.push_back(finding);
  };
  std::ranges::for_each(input.result.findings, add);
  for (const validate::SuppressedFinding& suppressed : input.result.suppressed) add(suppressed.finding);
  return thin;
}

}  // namespace rad::report
