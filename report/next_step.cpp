#include "report/next_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "report/text_layout.h"

namespace rad::report {

namespace {

const scene::Finding* first_error(const Report& report) {
  for (const InputReport& input : report.inputs) {
    const auto& findings = input.result.findings;
    if (!findings.empty() && findings.front().severity == scene::Severity::Error) return &findings.front();
  }
  return nullptr;
}

bool can_be_repaired(const InputReport& input) {
  bool safe = false;
  for (const scene::Finding& finding : input.result.findings) {
    if (finding.severity != scene::Severity::Error) continue;
    if (finding.fix.applicability != scene::FixClass::Safe) return false;
    safe = true;
  }
  return safe;
}

/// A path as a shell takes it for one word.
std::string shell_word(std::string_view path) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 ||
           std::string_view("_./+-:@%,=").find(c) != std::string_view::npos;
  };
  if (std::ranges::all_of(path, plain)) return std::string(path);
  std::string word = "'";
  for (const char c : path) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// "radfix room.obj -o room_fixed.obj", with the stage that makes what this one asks for.
std::string repair_command(const InputReport& input, validate::Stage stage) {
  const std::string path = printable(input.path);
  const std::size_t name = path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  const std::string stem = path.substr(0, dot == std::string::npos || dot < name ? path.size() : dot);
  const bool mesh = stage == validate::Stage::Solve || stage == validate::Stage::Display;
  return fmt::format("radfix {} -o {}{}", shell_word(path), shell_word(fmt::format("{}_fixed.{}", stem, input.format)),
                     mesh ? " --mesh" : "");
}

}  // namespace

std::string next_step(const Report& report) {
  if (const scene::Finding* error = first_error(report)) {
    if (report.inputs.size() != 1 || !can_be_repaired(report.inputs.front())) {
      return fmt::format("radlint rule {}   (what it means and how to repair it)", error->rule);
    }
    return fmt::format("{}   (repairs it)\n      radlint rule {}   (what it means)",
                       repair_command(report.inputs.front(), report.stage), error->rule);
  }
  const std::string path = report.inputs.size() == 1 ? shell_word(printable(report.inputs.front().path)) : "PATH…";
  switch (report.stage) {
    case validate::Stage::Preprocess:
      return fmt::format("radlint {}   (what the repaired model is held to)", path);
    case validate::Stage::Model:
      return fmt::format("radlint --stage solve {}   (what a solver asks beyond this)", path);
    case validate::Stage::Solve:
      return fmt::format("radlint --stage display {}   (what a viewer asks)", path);
    case validate::Stage::Display:
      break;
  }
  return "radlint rules   (all that was checked)";
}

}  // namespace rad::report
