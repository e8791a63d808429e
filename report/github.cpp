#include "report/github.h"

#include <fmt/format.h>

#include <array>

#include "report/place_text.h"
#include "report/printable.h"

namespace rad::report {

namespace {

constexpr std::size_t kShownOfEach = 10;  // annotations of one severity that GitHub shows for a step

// The escapes of a workflow command: of its message, and of the values of its parameters besides.
std::string escaped(std::string_view text, bool parameter) {
  std::string out;
  for (const char c : printable(text)) {
    if (c == '%' || (parameter && (c == ',' || c == ':'))) {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out;
}

std::string_view command_of(scene::Severity severity) {
  if (severity == scene::Severity::Error) return "error";
  return severity == scene::Severity::Warning ? "warning" : "notice";
}

std::string annotation(const scene::Finding& finding, std::string_view root) {
  const scene::Where& where = finding.where;
  std::string out =
      fmt::format("::{} file={}", command_of(finding.severity), escaped(relative_path(where.file, root), true));
  if (where.line > 0) out += fmt::format(",line={}", where.line);
  out += fmt::format(",title={}::{}", escaped(fmt::format("{} {}", finding.rule, finding.alias), true),
                     escaped(finding.message, false));
  if (where.line == 0 && !where.pointer.empty()) out += fmt::format(" in {}", escaped(where.pointer, false));
  if (where.point) out += fmt::format(" at {}", point_text(where));
  return out + '\n';
}

// A path at the start of a line must not be taken for a command.
std::string without_commands(std::string text) {
  for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at + 2)) {
    if (at == 0 || text[at - 1] == '\n') text.insert(at, 1, ' ');
  }
  return text;
}

}  // namespace

std::string github(const Report& report, const WriteOptions& options) {
  std::string out;
  for (const scene::Severity severity : {scene::Severity::Error, scene::Severity::Warning, scene::Severity::Note}) {
    std::size_t shown = 0;
    for (const InputReport& input : report.inputs) {
      for (const scene::Finding& finding : input.result.findings) {
        if (finding.severity == severity && shown++ < kShownOfEach) out += annotation(finding, options.root);
      }
    }
  }
  return out + without_commands(text(report, options.text));
}

}  // namespace rad::report
