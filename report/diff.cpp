#include "report/diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "report/pair_inputs.h"
#include "report/text_layout.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

using scene::Finding;
using Findings = std::vector<const Finding*>;

constexpr double kMovedInTolerances = 64;

bool holds_triangles_only(const InputReport& input) {
  return input.format == "glb" || input.format == "gltf" || input.format == "stl";
}

/// Whether a rule judges how a file says things, or faces as a format cuts them up, more than what the model is.
bool judges_format(std::string_view id) {
  const validate::Rule* rule = validate::find_rule(id);
  if (rule == nullptr) return false;
  switch (rule->requirement) {
    case validate::Requirement::MaximalPlanarFaces:
    case validate::Requirement::SimpleFaces:
    case validate::Requirement::WellShapedFaces:
    case validate::Requirement::Input:
    case validate::Requirement::Units:
      return true;
    default:
      return false;
  }
}

/// Whether files of a format have names for objects and materials.
bool knows_names(const InputReport& input) {
  return input.format != "ply" && input.format != "stl" && input.format != "off";
}

/// Whether a rule judges faces by the object or material that they belong to.
bool judges_names(std::string_view id) {
  const validate::Rule* rule = validate::find_rule(id);
  return rule != nullptr && (rule->requirement == validate::Requirement::SolidModel ||
                             rule->requirement == validate::Requirement::Materials);
}

std::optional<geom::dvec3> place_of(const Finding& finding) {
  if (!finding.where.bounds) return finding.where.point;
  return ((*finding.where.bounds)[0] + (*finding.where.bounds)[1]) * 0.5;
}

double extent_of(const Finding& finding) {
  return finding.where.bounds ? glm::distance((*finding.where.bounds)[0], (*finding.where.bounds)[1]) : 0;
}

std::uint64_t violations_in(const Findings& findings) {
  std::uint64_t sum = 0;
  for (const Finding* finding : findings) sum += finding->count;
  return sum;
}

scene::Severity highest(const Findings& findings) {
  return (*std::ranges::max_element(findings, {}, [](const Finding* finding) { return finding->severity; }))->severity;
}

/// What a movement of vertices within T makes of a measure.
double noise_of(const scene::Measure& measure, const Finding& finding, double tolerance) {
  if (measure.unit.ends_with("²")) return tolerance * std::max(extent_of(finding), std::sqrt(std::abs(measure.value)));
  if (measure.unit.ends_with("³")) return tolerance * std::pow(std::max(extent_of(finding), tolerance), 2);
  return measure.unit == "1" ? 1e-3 : tolerance;
}

bool measure_changed(const Finding& old, const Finding& now, double tolerance) {
  constexpr double kShare = 0.1;
  if (!old.measure || !now.measure) return false;
  const double apart = std::abs(old.measure->value - now.measure->value);
  const double larger = std::max(std::abs(old.measure->value), std::abs(now.measure->value));
  return apart > kShare * larger && apart > noise_of(*now.measure, now, tolerance);
}

/// Compares one model with itself.
class FileDiff {
 public:
  FileDiff(const InputReport& old, const InputReport& now)
      : old_(old),
        now_(now),
        same_kind_(holds_triangles_only(old) == holds_triangles_only(now)),
        names_lost_(knows_names(old) != knows_names(now)) {
    for (const InputReport* input : {&old, &now}) {
      if (input->result.tolerance) tolerance_ = std::max(tolerance_, input->result.tolerance->length);
    }
  }

  std::vector<DiffRow> rows() const {
    Matching matching = match_findings(old_.result.findings, now_.result.findings, tolerance_, names_lost_);
    std::vector<DiffRow> rows;
    for (Match& match : matching.matches) rows.push_back(row_of(std::move(match)));
    for (const Finding* finding : matching.only_now)
      rows.push_back({status(*finding, DiffStatus::New), {}, {finding}, {}});
    for (const Finding* finding : matching.only_old)
      rows.push_back({status(*finding, DiffStatus::Fixed), {finding}, {}, {}});
    return rows;
  }

 private:
  [[nodiscard]] DiffStatus status(const Finding& finding, DiffStatus of_model) const {
    const bool of_format =
        (old_.format != now_.format && judges_format(finding.rule)) || (names_lost_ && judges_names(finding.rule));
    return of_format ? DiffStatus::Format : of_model;
  }

  [[nodiscard]] DiffRow row_of(Match match) const {
    DiffRow row{DiffStatus::Unchanged, std::move(match.old), std::move(match.now), {}};
    describe_change(row);
    if (!row.change.empty()) row.status = DiffStatus::Changed;
    const auto before = place_of(*row.old.front());
    const auto after = place_of(*row.now.front());
    if (before && after && row.old.size() == 1 && row.now.size() == 1) {
      const double way = glm::distance(*before, *after);
      row.moved = way > kMovedInTolerances * tolerance_ ? way : 0;
    }
    return row;
  }

  // Numbers of faces, pairs of them and shares of their areas depend on how a format cuts faces up.
  void describe_change(DiffRow& row) const {
    const scene::Severity was = highest(row.old);
    const scene::Severity is = highest(row.now);
    const bool comparable = same_kind_ && !(old_.format != now_.format && judges_format(row.now.front()->rule));
    const bool format_decides =
        (!same_kind_ && judges_format(row.now.front()->rule)) || row.old.front()->rule != row.now.front()->rule;
    if (was != is && !format_decides) {
      row.change = fmt::format("{} before, {} now", scene::name(was), scene::name(is));
      row.worse = is > was;
    } else if (comparable && violations_in(row.old) != violations_in(row.now)) {
      row.change = fmt::format("{} before, {} now", counted(violations_in(row.old), "place"), violations_in(row.now));
      row.worse = violations_in(row.now) > violations_in(row.old);
    } else if (comparable && measure_changed(*row.old.front(), *row.now.front(), tolerance_)) {
      row.change =
          fmt::format("{} {} before, {} now", row.now.front()->measure->name,
                      short_number(row.old.front()->measure->value), short_number(row.now.front()->measure->value));
    }
  }

  const InputReport& old_;
  const InputReport& now_;
  bool same_kind_;
  bool names_lost_;
  double tolerance_ = 0;
};

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
    file.rows = FileDiff(*old, *now).rows();
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
