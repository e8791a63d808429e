#include "report/thin_list.h"

#include <algorithm>
#include <iterator>

#include "validate/rules.h"

namespace rad::report {

std::vector<scene::Finding> thin_features(const InputReport& input) {
  std::vector<scene::Finding> thin;
  std::ranges::copy_if(input.result.findings, std::back_inserter(thin),
                       [](const scene::Finding& finding) { return finding.rule == validate::thin_feature.id; });
  return thin;
}

}  // namespace rad::report
