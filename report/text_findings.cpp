#include "report/text_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "report/place_text.h"
#include "report/text.h"

namespace rad::report {

namespace {

using scene::Finding;

std::string point_of(const scene::Where& where) { return where.point ? "at " + point_text(where) : std::string(); }

std::uint64_t places_in(std::span<const Finding> group) {
  std::uint64_t places = 0;
  for (const Finding& finding : group) places += finding.count;
  return places;
}

void append_rule_header(std::string& out, std::span<const Finding> group, const Paint& paint) {
  const Finding& first = group.front();
  const std::string severity = paint(ink_of(first.severity), scene::name(first.severity));
  const std::string rule = paint(Ink::Bold, fmt::format("{} {}", first.rule, first.alias));
  out += fmt::format("\n{} {}  {}  {}, {}\n", severity, rule, first.requirement, counted(group.size(), "finding"),
                     counted(places_in(group), "place"));
}

/// The words of a finding.
struct Entry {
  explicit Entry(const Finding& finding)
      : place(place_text(finding.where)), point(point_of(finding.where)), message(printable(finding.message)) {}

  std::string place;
  std::string point;
  std::string message;
};

// Place and point stand in columns; the message follows on the same line where the width allows it for all.
void append_list(std::string& out, std::span<const Finding> listed, std::size_t width) {
  const std::vector<Entry> entries(listed.begin(), listed.end());
  std::size_t place_width = 0;
  std::size_t point_width = 0;
  std::size_t message_width = 0;
  for (const Entry& entry : entries) {
    place_width = std::max(place_width, columns(entry.place));
    point_width = std::max(point_width, columns(entry.point));
    message_width = std::max(message_width, columns(entry.message));
  }
  const std::size_t lead = 2 + place_width + (point_width > 0 ? 2 + point_width : 0);
  const bool one_line = lead + 2 + message_width <= width;
  for (const Entry& entry : entries) {
    std::string head = "  " + entry.place;
    if (!entry.point.empty()) head = padded(head, 2 + place_width) + "  " + entry.point;
    if (one_line) {
      out.append(padded(head, lead)).append("  ").append(entry.message) += '\n';
    } else {
      out.append(head) += '\n';
      append_wrapped(out, entry.message, 4, width);
    }
  }
}

void append_group(std::string& out, std::span<const Finding> group, const FindingLayout& layout) {
  append_rule_header(out, group, layout.paint);
  const std::size_t listed = layout.listed == 0 ? group.size() : std::min(layout.listed, group.size());
  append_list(out, group.first(listed), layout.width);
  if (listed < group.size()) {
    out += fmt::format("  … {} more ({})\n", group.size() - listed, layout.elsewhere);
  }
  if (const std::string fix = fix_text(group.front().fix); !fix.empty()) out += fmt::format("  fix: {}\n", fix);
}

}  // namespace

Ink ink_of(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::Error:
      return Ink::Red;
    case scene::Severity::Warning:
      return Ink::Yellow;
    case scene::Severity::Note:
      return Ink::Cyan;
  }
  return Ink::Plain;
}

void append_findings(std::string& out, std::span<const Finding> findings, const FindingLayout& layout) {
  while (!findings.empty()) {
    const Finding& first = findings.front();
    const auto end = std::ranges::find_if(findings, [&](const Finding& finding) {
      return finding.rule != first.rule || finding.severity != first.severity;
    });
    const auto size = static_cast<std::size_t>(end - findings.begin());
    append_group(out, findings.first(size), layout);
    findings = findings.subspan(size);
  }
}

}  // namespace rad::report
