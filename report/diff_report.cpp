#include "report/diff_report.h"

#include <fmt/format.h>

#include <array>

#include "report/html/diff_page.h"
#include "report/text_layout.h"
#include "report/units.h"

namespace rad::report {

namespace {

constexpr std::array<DiffFormat, 4> kFormats = {{
    {"text", [](const Diff& diff, const WriteOptions& options) { return diff_text(diff, options.text); }},
    {"json", [](const Diff& diff, const WriteOptions&) { return diff_json(diff); }},
    {"markdown", [](const Diff& diff, const WriteOptions&) { return diff_markdown(diff); }},
    {"html", [](const Diff& diff, const WriteOptions&) { return html::page(diff); }},
}};

}  // namespace

std::span<const DiffFormat> diff_formats() { return kFormats; }

bool fails(const Diff& diff) { return reaches(regressions(diff), diff.now->fail_on); }

std::string diff_counts_text(const DiffCounts& counts) {
  std::string text;
  for (const DiffStatus status : kDiffStatuses) {
    if (counts[status] == 0) continue;
    const std::string_view word = status == DiffStatus::Format ? "of the format" : name(status);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[status], word);
  }
  return text.empty() ? "no findings on either side" : text;
}

std::string diff_paths_text(const DiffFile& file) {
  if (file.now == nullptr) return printable(file.old->path) + " (gone)";
  if (file.old == nullptr) return printable(file.now->path) + " (was not there before)";
  if (file.old->path == file.now->path) return printable(file.now->path);
  return fmt::format("{} → {}", printable(file.old->path), printable(file.now->path));
}

std::string diff_tolerance_text(const DiffFile& file) {
  if (file.old == nullptr || file.now == nullptr) return {};
  const auto& old = file.old->result.tolerance;
  const auto& now = file.now->result.tolerance;
  if (!old || !now || old->length == now->length) return {};
  return fmt::format("T was {} {}, is {} {}: findings near a threshold may come and go", short_number(old->length),
                     unit_label(file.old->metres_per_unit), short_number(now->length),
                     unit_label(file.now->metres_per_unit));
}

}  // namespace rad::report
