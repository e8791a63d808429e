#include "validate/tool_finding.h"

#include <stdexcept>

#include "validate/fingerprint.h"
#include "validate/message.h"

namespace rad::validate {

scene::Finding tool_finding(const Rule& rule, std::string_view detail, scene::Where where) {
  if (!rule.of_tool) throw std::logic_error("not a rule about the run");
  scene::Finding finding = finding_frame(rule, rule.severity);
  finding.where = std::move(where);
  finding.message = message_of(rule, finding, detail);
  finding.fingerprint = fingerprint_of(finding, 0, 0);
  return finding;
}

}  // namespace rad::validate
