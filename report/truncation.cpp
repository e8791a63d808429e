#include "report/truncation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/text_layout.h"
#include "validate/grouping.h"
#include "validate/rules.h"
#include "validate/tool_finding.h"

namespace rad::report {

namespace {

bool is_note(const scene::Finding& finding) { return finding.rule == validate::truncated.id; }

/// Of a rule: findings that are listed, and those that are not.
struct Share {
  std::uint64_t listed = 0;
  std::uint64_t left_out = 0;
};

std::map<std::string_view, Share> shares_of(const InputReport& input, std::size_t max_issues) {
  std::map<std::string_view, Share> shares;
  for (const Unlisted& rest : unlisted_findings(input, max_issues)) shares[rest.rule].left_out += rest.findings;
  for (const scene::Finding& finding : input.result.findings) {
    const auto share = shares.find(finding.rule);
    if (share != shares.end() && (max_issues == 0 || share->second.listed < max_issues)) ++share->second.listed;
  }
  return shares;
}

}  // namespace

void note_truncation(InputReport& input, std::size_t max_issues, scene::Severity severity) {
  auto& findings = input.result.findings;
  const auto shares = shares_of(input, max_issues);
  if (shares.empty() || std::ranges::any_of(findings, is_note)) return;
  std::string what = "reports list";
  std::uint64_t left_out = 0;
  for (const auto& [rule, share] : shares) {
    what += fmt::format("{} {} of {} of {}", left_out == 0 ? "" : ",", share.listed,
                        counted(share.listed + share.left_out, "finding"), rule);
    left_out += share.left_out;
  }
  scene::Where where;
  where.file = input.path;
  scene::Finding note = validate::tool_finding(validate::truncated, what + " (--max-issues)", std::move(where));
  note.severity = severity;
  note.count = left_out;
  const bool compared = findings.front().baseline != scene::BaselineState::None;
  if (compared) note.baseline = scene::BaselineState::New;
  findings.push_back(std::move(note));
  validate::sort_findings(findings);
}

void forget_truncation(Report& report) {
  for (InputReport& input : report.inputs) std::erase_if(input.result.findings, is_note);
}

}  // namespace rad::report
