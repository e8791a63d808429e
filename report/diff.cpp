#include "report/diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "report/comparison.h"
#include "report/pair_inputs.h"
#include "report/text_layout.h"

namespace rad::report {

namespace {

using scene::Finding;

constexpr double kMovedInTolerances = 64;

std::optional<geom::dvec3> place_of(const Finding& finding) {
  if (!finding.where.bounds) return finding.where.point;
  return ((*finding.where.bounds)[0] + (*finding.where.bounds)[1]) * 0.5;
}

DiffRow row_of(const Comparison& comparison, Match match) {
  const FaultChange change = comparison.change_of(match);
  DiffRow row{DiffStatus::Unchanged, std::move(match.old), std::move(match.now), change.words, change.worse};
  if (!row.change.empty()) row.status = DiffStatus::Changed;
  const auto before = place_of(*row.old.front());
  const auto after = place_of(*row.now.front());
  if (before && after && row.old.size() == 1 && row.now.size() == 1) {
    const double way = glm::distance(*before, *after);
    row.moved = way > kMovedInTolerances * comparison.tolerance() ? way : 0;
  }
  return row;
}

/// One model compared with itself.
std::vector<DiffRow> rows_of(const InputReport& old, const InputReport& now) {
  const Comparison comparison(old, now);
  const auto status = [&](const Finding& finding, DiffStatus of_model) {
    return comparison.is_of_format(finding) ? DiffStatus::Format : of_model;
  };
  Matching matching = comparison.matching();
  std::vector<DiffRow> rows;
  for (Match& match : matching.matches) rows.push_back(row_of(comparison, std::move(match)));
  for (const Finding* finding : matching.only_now) {
    rows.push_back({status(*finding, DiffStatus::New), {}, {finding}, {}});
  }
  for (const Finding* finding : matching.only_old) {
    rows.push_back({status(*finding, DiffStatus::Fixed), {finding}, {}, {}});
  }
  return rows;
}

std::vector<DiffRow> rows_of_one_side(const InputReport& input, DiffStatus status) {
  std::vector<DiffRow> rows;
  for (const Finding& finding : input.result.findings) {
    DiffRow& row = rows.emplace_back();
    row.status = status;
    (status == DiffStatus::New ? row.now : row.old).push_back(&finding);
  }
  return rows;
}

std::vector<std::string> paths_of(const Report& report) {
  std::vector<std::string> paths;
  for (const InputReport& input : report.inputs) paths.push_back(input.path);
  return paths;
}

DiffFile file_of(const InputReport* old, const InputReport* now) {
  DiffFile file{old, now, {}};
  if (old != nullptr && now != nullptr) {
    file.rows = rows_of(*old, *now);
  } else {
    file.rows = now != nullptr ? rows_of_one_side(*now, DiffStatus::New) : rows_of_one_side(*old, DiffStatus::Fixed);
  }
  std::ranges::stable_sort(
      file.rows, {}, [](const DiffRow& row) { return std::pair(row.status, -static_cast<int>(row.shown().severity)); });
  return file;
}

void add_gaps(const InputReport* input, std::string_view side, std::vector<std::string>& out) {
  if (input != nullptr && !input->result.incomplete.empty()) {
    out.push_back(fmt::format("{} ({}): {}", printable(input->path), side, input->result.incomplete));
  }
  if (input == nullptr) return;
  for (const Unlisted& rest : input->unlisted) {
    out.push_back(fmt::format("{} ({}): {} not listed in the report; --max-issues 0 lists all", printable(input->path),
                              side, counted(rest.findings, std::string(rest.rule) + " finding")));
  }
}

}  // namespace

std::string_view name(DiffStatus status) {
  constexpr std::array<std::string_view, kDiffStatuses.size()> kNames = {"new", "changed", "fixed", "unchanged",
                                                                         "format"};
  return kNames[static_cast<std::size_t>(status)];
}

Diff diff_of(const Report& old, const Report& now) {
  Diff diff{&old, &now, {}};
  for (const PathPair& pair : pair_paths(paths_of(old), paths_of(now))) {
    diff.files.push_back(
        file_of(pair.old ? &old.inputs[*pair.old] : nullptr, pair.now ? &now.inputs[*pair.now] : nullptr));
  }
  return diff;
}

DiffCounts counts(const DiffFile& file) {
  DiffCounts counts;
  for (const DiffRow& row : file.rows) ++counts.of[static_cast<std::size_t>(row.status)];
  return counts;
}

DiffCounts counts(const Diff& diff) {
  DiffCounts sum;
  for (const DiffFile& file : diff.files) {
    const DiffCounts of_file = counts(file);
    for (std::size_t i = 0; i < sum.of.size(); ++i) sum.of[i] += of_file.of[i];
  }
  return sum;
}

Counts regressions(const Diff& diff) {
  Counts sum;
  for (const DiffFile& file : diff.files) {
    for (const DiffRow& row : file.rows) {
      if (row.status == DiffStatus::New || row.worse) sum.add(row.shown().severity);
    }
  }
  return sum;
}

std::vector<std::string> gaps(const Diff& diff) {
  std::vector<std::string> out;
  for (const DiffFile& file : diff.files) {
    add_gaps(file.old, "old", out);
    add_gaps(file.now, "new", out);
  }
  return out;
}

}  // namespace rad::report
