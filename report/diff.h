// Two judgements of the same models compared: the data that text, Markdown, JSON and HTML are made of.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "report/matching.h"
#include "report/report.h"

namespace rad::report {

enum class DiffStatus : std::uint8_t {
  New,
  Changed,    ///< another severity, number of violations or measure
  Fixed,      ///< not there any more
  Unchanged,  ///< the same, moved with its object or not
  Format,     ///< on one side only, and what the formats can hold differs: says nothing about the model
};
inline constexpr std::array kDiffStatuses = {DiffStatus::New, DiffStatus::Changed, DiffStatus::Fixed,
                                             DiffStatus::Unchanged, DiffStatus::Format};

std::string_view name(DiffStatus status);  ///< "new", "changed", "fixed", "unchanged", "format"

/// One fault. Findings belong to the two reports.
struct DiffRow {
  DiffStatus status = DiffStatus::Unchanged;
  std::vector<const scene::Finding*> old;  ///< mostly one; none of what is new
  std::vector<const scene::Finding*> now;  ///< mostly one; none of what is fixed
  std::string change;                      ///< "2 places before, 5 now"; empty where nothing changed
  bool worse = false;                      ///< changed to a higher severity or more violations
  double moved = 0;                        ///< file units, how far the place went; 0 within 64 T

  /// The finding that stands for the row: the present one, else the old.
  [[nodiscard]] const scene::Finding& shown() const { return now.empty() ? *old.front() : *now.front(); }
};

/// One model; a side is null where there is no such file.
struct DiffFile {
  const InputReport* old = nullptr;
  const InputReport* now = nullptr;
  std::vector<DiffRow> rows;  ///< by status, then in the order of the reports

  [[nodiscard]] const InputReport& shown() const { return now != nullptr ? *now : *old; }
};

struct Diff {
  const Report* old = nullptr;  ///< both outlive this
  const Report* now = nullptr;
  std::vector<DiffFile> files;
};

struct DiffCounts {
  std::array<std::uint64_t, kDiffStatuses.size()> of{};

  [[nodiscard]] std::uint64_t operator[](DiffStatus status) const { return of[static_cast<std::size_t>(status)]; }
};

Diff diff_of(const Report& old, const Report& now);

DiffCounts counts(const DiffFile& file);
DiffCounts counts(const Diff& diff);

/// Findings that are new, and changed ones that are worse, by severity: what fails a comparison.
Counts regressions(const Diff& diff);

/// Files of which a side was judged in part, as sentences.
std::vector<std::string> gaps(const Diff& diff);

}  // namespace rad::report
