#include <fmt/format.h>

#include <algorithm>

#include "report/diff_report.h"
#include "report/place_text.h"
#include "report/text.h"
#include "report/text_findings.h"
#include "report/text_layout.h"

namespace rad::report {

namespace {

constexpr std::size_t kListed = 10;  // findings of a status and rule

Ink ink_of(DiffStatus status) {
  switch (status) {
    case DiffStatus::New:
      return Ink::Red;
    case DiffStatus::Changed:
      return Ink::Yellow;
    case DiffStatus::Fixed:
      return Ink::Green;
    default:
      return Ink::Dim;
  }
}

class DiffText {
 public:
  DiffText(const Diff& diff, const TextOptions& options)
      : diff_(diff), paint_(options.color), width_(options.width), listed_(options.max_findings.value_or(kListed)) {}

  std::string run() {
    for (const DiffFile& file : diff_.files) {
      if (diff_.files.size() == 1 || is_worth_a_block(file)) append_file(file);
    }
    if (diff_.files.size() > 1) append_quiet_files();
    for (const std::string& gap : gaps(diff_)) append_wrapped(out_, "judged in part: " + gap, 0, width_);
    append_verdict();
    return std::move(out_);
  }

 private:
  static bool is_listed(const DiffRow& row) {
    return row.status != DiffStatus::Unchanged && row.status != DiffStatus::Format;
  }
  static bool is_worth_a_block(const DiffFile& file) { return std::ranges::any_of(file.rows, is_listed); }

  void append_file(const DiffFile& file) {
    out_ += paint_(Ink::Bold, diff_paths_text(file)) + "\n";
    if (const std::string text = diff_tolerance_text(file); !text.empty()) append_wrapped(out_, text, 2, width_);
    for (auto row = file.rows.begin(); row != file.rows.end();) {
      const auto end = std::find_if(row, file.rows.end(), [&](const DiffRow& other) {
        return other.status != row->status || other.shown().rule != row->shown().rule ||
               other.shown().severity != row->shown().severity;
      });
      if (is_listed(*row)) append_rows({row, end});
      row = end;
    }
    out_ += '\n';
  }

  void append_rows(std::span<const DiffRow> rows) {
    const scene::Finding& first = rows.front().shown();
    out_ += fmt::format("\n{} {} {}  {}\n", paint_(ink_of(rows.front().status), padded(name(rows.front().status), 7)),
                        scene::name(first.severity), paint_(Ink::Bold, fmt::format("{} {}", first.rule, first.alias)),
                        counted(rows.size(), "finding"));
    const std::size_t listed = listed_ == 0 ? rows.size() : std::min(listed_, rows.size());
    for (const DiffRow& row : rows.first(listed)) append_row(row);
    if (listed < rows.size()) out_ += fmt::format("  … {} more (--max-findings 0 shows all)\n", rows.size() - listed);
  }

  void append_row(const DiffRow& row) {
    const scene::Finding& finding = row.shown();
    const std::string point = point_text(finding.where);
    out_ += fmt::format("  {}{}\n", place_text(finding.where), point.empty() ? "" : "  at " + point);
    append_wrapped(out_, printable(finding.message), 4, width_);
    if (!row.change.empty()) append_wrapped(out_, row.change, 4, width_);
  }

  void append_quiet_files() {
    const auto quiet = std::ranges::count_if(diff_.files, [](const DiffFile& file) { return !is_worth_a_block(file); });
    if (quiet > 0) out_ += fmt::format("{} without a change\n", counted(static_cast<std::uint64_t>(quiet), "file"));
  }

  void append_verdict() {
    const Counts worse = regressions(diff_);
    const bool fail = fails(diff_);
    out_ += fmt::format("{}  {}\n", fail ? paint_(Ink::Red, "FAIL") : paint_(Ink::Green, "pass"),
                        diff_counts_text(counts(diff_)));
    if (worse.errors + worse.warnings + worse.notes > 0) out_ += fmt::format("new or worse: {}\n", counts_text(worse));
    if (!fail && worse.errors + worse.warnings + worse.notes > 0) {
      out_ += fmt::format("none of them at severity {} or above (--fail-on)\n", name(diff_.now->fail_on));
    }
  }

  const Diff& diff_;
  Paint paint_;
  std::size_t width_;
  std::size_t listed_;
  std::string out_;
};

}  // namespace

std::string diff_text(const Diff& diff, const TextOptions& options) { return DiffText(diff, options).run(); }

}  // namespace rad::report
