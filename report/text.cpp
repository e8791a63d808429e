#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/next_step.h"
#include "report/requirements.h"
#include "report/text_findings.h"
#include "report/text_header.h"
#include "report/text_layout.h"

namespace rad::report {

namespace {

constexpr std::size_t kListedForOneFile = 10;
constexpr std::size_t kListedForSeveralFiles = 3;

struct StatusWord {
  std::string_view word;
  Ink ink;
};

StatusWord word_of(RequirementStatus status) {
  switch (status) {
    case RequirementStatus::Pass:
      return {"pass", Ink::Green};
    case RequirementStatus::Note:
      return {"note", Ink::Cyan};
    case RequirementStatus::Warning:
      return {"warn", Ink::Yellow};
    case RequirementStatus::Fail:
      return {"FAIL", Ink::Red};
    case RequirementStatus::NotAsked:
      return {"-", Ink::Dim};
    case RequirementStatus::NotChecked:
      return {"?", Ink::Dim};
  }
  return {"?", Ink::Dim};
}

std::string remark_on(const RequirementSummary& summary, validate::Stage stage) {
  switch (summary.status) {
    case RequirementStatus::Pass:
      return {};
    case RequirementStatus::NotAsked:
      return fmt::format("not asked at stage {}", validate::name(stage));
    case RequirementStatus::NotChecked:
      return "not checked";
    default:
      return counts_text(summary.counts);
  }
}

void append_requirements(std::string& out, const Report& report, const Paint& paint) {
  const auto summaries = requirement_summaries(report.inputs, report.stage);
  std::size_t title_width = 0;
  for (const RequirementSummary& summary : summaries) {
    title_width = std::max(title_width, columns(validate::title(summary.requirement)));
  }
  out += fmt::format("\nrequirements at stage {}\n", validate::name(report.stage));
  for (const RequirementSummary& summary : summaries) {
    const StatusWord status = word_of(summary.status);
    const std::string remark = remark_on(summary, report.stage);
    out += fmt::format("  {}  {}  {}", validate::code(summary.requirement),
                       padded(validate::title(summary.requirement), title_width), paint(status.ink, status.word));
    if (!remark.empty()) out += std::string(6 - status.word.size(), ' ') + remark;
    out += '\n';
  }
}

void append_verdict(std::string& out, const Report& report, const Paint& paint) {
  const Counts sum = counts(report);
  const bool pass = sum.errors == 0;
  const std::string word = pass ? paint(Ink::Green, "pass") : paint(Ink::Red, "FAIL");
  out += fmt::format("\n{}  {} at stage {}", word, counts_text(sum), validate::name(report.stage));
  if (report.inputs.size() == 1 && report.inputs.front().result.tolerance) {
    const InputReport& input = report.inputs.front();
    out += "; " + tolerance_text(*input.result.tolerance, input.metres_per_unit);
  }
  out += '\n';
  if (pass && reaches(sum, report.fail_on)) {
    out += fmt::format("no errors, but the run fails at severity {} (--fail-on)\n", name(report.fail_on));
  }
  if (const std::uint64_t known = known_findings(report); known > 0) {
    out += fmt::format("{} in the baseline and not listed\n", counted(known, "finding is", "findings are"));
  }
  if (const std::uint64_t suppressed = suppressed_findings(report); suppressed > 0) {
    out += fmt::format("{} suppressed and not listed\n", counted(suppressed, "finding is", "findings are"));
  }
  out += fmt::format("next: {}\n", next_step(report));
}

void append_passing_line(std::string& out, const InputReport& input, const Counts& sum, const Paint& paint) {
  out += fmt::format("{}  {}  {}", paint(Ink::Green, "pass"), printable(input.path),
                     counted(input.result.figures.faces, "face"));
  if (sum.warnings + sum.notes > 0) out += ", " + counts_text(sum);
  out += '\n';
}

// A file of many gets a block of its own where it has errors or fails the run.
void append_files(std::string& out, const Report& report, const FindingLayout& layout) {
  std::size_t failing = 0;
  for (const InputReport& input : report.inputs) {
    const Counts sum = counts(input);
    const bool fails = reaches(sum, report.fail_on);
    if (sum.errors == 0 && !fails) {
      append_passing_line(out, input, sum, layout.paint);
      continue;
    }
    if (fails) ++failing;
    if (!out.empty()) out += '\n';
    append_header(out, input, layout.paint, layout.width);
    append_findings(out, input.result.findings, layout);
    out += '\n';
  }
  out += fmt::format("\n{}, {} with findings that fail the run\n", counted(report.inputs.size(), "file"), failing);
}

}  // namespace

std::string text(const Report& report, const TextOptions& options) {
  const bool several = report.inputs.size() != 1;
  FindingLayout layout{Paint(options.color), options.width, several ? kListedForSeveralFiles : kListedForOneFile};
  layout.listed = options.max_findings.value_or(layout.listed);
  std::string out;
  if (several) {
    append_files(out, report, layout);
  } else {
    append_header(out, report.inputs.front(), layout.paint, layout.width);
    append_findings(out, report.inputs.front().result.findings, layout);
  }
  append_requirements(out, report, layout.paint);
  append_verdict(out, report, layout.paint);
  return out;
}

std::string fix_text(const scene::Fix& fix) {
  const std::string operation = fix.operation.empty() ? std::string() : fmt::format(" ({})", fix.operation);
  switch (fix.applicability) {
    case scene::FixClass::Safe:
      return (fix.operation == "pmesh" ? "radfix --mesh does it" : "radfix repairs it") + operation;
    case scene::FixClass::Unsafe:
      return "not without you" + operation;
    case scene::FixClass::Manual:
      return "by hand, in the modeller";
    case scene::FixClass::None:
      break;
  }
  return {};
}

std::string counts_text(const Counts& counts) {
  std::string text;
  const auto add = [&](std::uint64_t count, std::string_view noun) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    text += counted(count, noun);
  };
  add(counts.errors, "error");
  add(counts.warnings, "warning");
  add(counts.notes, "note");
  return text.empty() ? "no findings" : text;
}

}  // namespace rad::report
