#include "report/repair_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "report/changes_text.h"
#include "report/text.h"
#include "report/text_findings.h"
#include "report/text_header.h"
#include "report/text_layout.h"
#include "report/thin_list.h"
#include "report/units.h"

namespace rad::report {

namespace {

constexpr std::size_t kOperationWidth = 44;

// The JSON report has them all.
constexpr std::size_t kListedThin = 10;

// Ledger names in a reader's words; the count follows each.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kOperationWords{{
    {"drop-bad-faces", "faces left out that cannot be kept"},
    {"cap-opening", "flat openings closed, as asked"},
    {"add-twin", "faces doubled, as asked"},
    {"weld", "vertices welded to a neighbour"},
    {"snap-to-plane", "vertices moved onto planes"},
    {"drop-collapsed", "pieces of faces that lost their width"},
    {"drop-degenerate", "faces that had no area at T left out"},
    {"close-face", "narrow faces closed to lines"},
    {"flatten-plate", "pairs of sides of plates made one plane"},
    {"close-slit", "pairs of sides of slits made one plane"},
    {"insert-t-vertex", "vertices put into edges they lie on"},
    {"add-point", "vertices made where faces meet"},
    {"split-edge", "edges divided there"},
    {"imprint", "contacts drawn into faces"},
    {"merge-points", "vertices merged that stood in the way"},
    {"add-steiner-point", "vertices added to keep triangles wide"},
    {"move-to-plane", "triangles moved to a plane they lay on"},
    {"remove-covered-cell", "coplanar pieces under others removed"},
}};

// The letters of scene::CoplanarRemoval in a reader's words.
constexpr std::array<std::pair<char, std::string_view>, 6> kRuleWords{{
    {'a', "which has priority"},
    {'b', "which emits light"},
    {'c', "the smaller surface"},
    {'d', "the same material"},
    {'e', "a tie"},
    {'f', "by the order of the file"},
}};
// The JSON report has them all.
constexpr std::size_t kListedRemovals = 10;
constexpr std::string_view kRollBack = "roll-back";

std::string listed(const std::vector<std::string>& rules) { return fmt::format("{}", fmt::join(rules, ", ")); }

std::string words_for(const std::string& operation) {
  if (operation == "turn-face") return "faces turned";
  const auto found = std::ranges::find(kOperationWords, operation, &decltype(kOperationWords)::value_type::first);
  return found == kOperationWords.end() ? operation : std::string(found->second);
}

class RepairText {
 public:
  RepairText(const RepairReport& report, const RepairTextOptions& options)
      : report_(report), options_(options), paint_(options.color), before_(report.before.inputs.front()) {}

  std::string run() {
    append_header(out_, before_, paint_, options_.width);
    append_judged(before_, report_.before.stage);
    thin();
    repaired();
    resolved();
    if (options_.diff) append_changes(out_, report_, paint_, options_.width);
    if (report_.contracts) append_contracts(out_, *report_.contracts, paint_);
    if (report_.mesh) meshed(*report_.mesh);
    if (report_.solution) solved(*report_.solution);
    written(*report_.after);
    return std::move(out_);
  }

 private:
  void line(const std::string& text) { append_wrapped(out_, text, 2, options_.width); }
  void heading(std::string_view text) { out_ += fmt::format("\n{}\n", paint_(Ink::Bold, text)); }

  void append_judged(const InputReport& input, validate::Stage stage) {
    line(fmt::format("judged at stage {}: {}", validate::name(stage), counts_text(counts(input))));
  }

  void thin() {
    const std::vector<scene::Finding> features = thin_features(before_);
    if (!features.empty())
      append_findings(out_, features, {paint_, options_.width, kListedThin, "--report json=PATH lists all"});
  }

  // A ledger may name an operation once for every pass.
  [[nodiscard]] scene::Ledger merged_ledger() const {
    scene::Ledger merged;
    for (const scene::LedgerEntry& entry : report_.ledger) {
      if (entry.operation == kRollBack) continue;
      const auto same = std::ranges::find(merged, entry.operation, &scene::LedgerEntry::operation);
      if (same == merged.end()) {
        merged.push_back(entry);
        continue;
      }
      same->count += entry.count;
      same->largest_movement = std::max(same->largest_movement, entry.largest_movement);
    }
    return merged;
  }

  void repaired() {
    if (report_.repair == RepairDone::Skipped) return heading("repair left out, as asked");
    const bool untouched = report_.repair == RepairDone::NotNeeded;
    if (untouched && report_.ledger.empty()) return heading("nothing to repair");
    heading(untouched ? "nothing else to repair" : "repaired");
    const double tolerance = before_.result.tolerance ? before_.result.tolerance->length : 0;
    for (const scene::LedgerEntry& entry : merged_ledger()) {
      out_ += fmt::format("  {} {:>9}", padded(words_for(entry.operation), kOperationWidth), entry.count);
      if (entry.largest_movement > 0 && tolerance > 0) {
        out_ += fmt::format("  by at most {:.1f} T", entry.largest_movement / tolerance);
      }
      out_ += '\n';
      if (!entry.places.empty()) {
        append_wrapped(out_, "largest: " + place_text(entry.places.front()), 4, options_.width);
      }
    }
    for (const scene::LedgerEntry& entry : report_.ledger) {
      if (entry.operation == kRollBack)
        line(fmt::format("{} rolled back: it made {} worse", entry.stage, listed(entry.rules)));
    }
    if (report_.changes && !report_.changes->merged.empty()) {
      const MergedRegion& worst = report_.changes->merged.front();
      line(fmt::format("{} moved farther than 4 T, up to {} at ({}, {}, {})",
                       counted(report_.changes->merged.size(), "region"), short_number(worst.distance),
                       short_number(worst.at.x), short_number(worst.at.y), short_number(worst.at.z)));
    }
  }

  static std::string at(const geom::dvec3& point) {
    return fmt::format("({}, {}, {})", short_number(point.x), short_number(point.y), short_number(point.z));
  }

  [[nodiscard]] std::string area_text(double area) const {
    return fmt::format("{} {}²", short_number(area), unit_label(before_.metres_per_unit));
  }

  [[nodiscard]] std::string place_text(const scene::LedgerPlace& place) const {
    return fmt::format("{} at {}, {}", printable(place.face.ref), at(place.point), area_text(place.area));
  }

  void resolved() {
    if (report_.removals.empty()) return;
    heading("overlaps in one plane");
    const std::size_t listed = std::min(report_.removals.size(), kListedRemovals);
    for (const scene::CoplanarRemoval& removal : std::span(report_.removals).first(listed)) line(removal_text(removal));
    if (listed < report_.removals.size()) {
      line(fmt::format("… {} more (--report json=PATH lists all)", report_.removals.size() - listed));
    }
    const auto ties = std::ranges::count_if(report_.removals, &scene::CoplanarRemoval::tie);
    if (ties == 0) return;
    line(fmt::format("{} nothing but names decided {}: --priority GLOB says who is to be seen",
                     paint_(Ink::Yellow, "warning:"), ties == 1 ? "the tie" : fmt::format("{} ties", ties)));
  }

  static std::string name_of(const scene::CoplanarRemoval::Side& side) {
    return fmt::format("\"{}\" of \"{}\"", printable(side.material), printable(side.object));
  }

  [[nodiscard]] std::string removal_text(const scene::CoplanarRemoval& removal) const {
    const auto why = std::ranges::find(kRuleWords, removal.rule, &decltype(kRuleWords)::value_type::first);
    return fmt::format("{} before {}, {}: {}, {}, largest at {}", name_of(removal.winner), name_of(removal.loser),
                       why->second, counted(removal.count, "cell"), area_text(removal.area), at(removal.point));
  }

  void meshed(const MeshFigures& figures) {
    const std::string unit = unit_label(before_.metres_per_unit);
    heading("meshed");
    line(fmt::format("{} to {} with edges up to {} {}", counted(figures.faces, "face"),
                     counted(figures.patches, "patch", "patches"), short_number(figures.patch_size), unit));
    line(fmt::format("and {} with edges up to {} {}, {}", counted(figures.elements, "element"),
                     short_number(figures.element_size), unit, counted(figures.nodes, "node")));
    line(fmt::format("shape of patches, 1 is best: median {:.2f}, 99 % above {:.2f}", figures.shape_median,
                     figures.shape_first_percentile));
  }

  void solved(const SolutionFigures& figures) {
    const auto sum = [](const geom::dvec3& rgb) { return rgb.x + rgb.y + rgb.z; };
    const double emitted = sum(figures.energy.emitted);
    heading(figures.complete ? "solved" : "solved in part");
    line(fmt::format("{}, {:.2g} % of the light not yet shot", counted(figures.shots, "shot"),
                     100 * figures.energy.unshot_share()));
    if (figures.elements_added > 0) {
      line(fmt::format("{} of the elements were added where the light bends or steps", figures.elements_added));
    }
    if (emitted <= 0) return;
    // Escaped power has the error of integration in it: a closed room may lose a little less than nothing.
    const auto percent = [&](double power) { return std::max(0.0, std::round(100 * power / emitted)); };
    line(fmt::format("of {} W emitted (all channels) {} % is absorbed and {} % leaves the model", short_number(emitted),
                     percent(sum(figures.energy.absorbed)), percent(sum(figures.energy.escaped))));
  }

  void light_map(const LightMapFigures& figures) {
    if (figures.files.empty()) return;
    const std::size_t pages = (figures.files.size() - 1) / 2;
    out_ += fmt::format("  light map {}, {}, {}\n  with texels of {:.4g} units\n", printable(figures.files.front()),
                        counted(figures.charts, "chart"), counted(pages, "page"), figures.texel);
  }

  void written(const Report& after) {
    const InputReport& output = after.inputs.front();
    const Counts left = counts(output);
    const bool clean = left.errors == report_.awaited && output.result.refusal.empty() && !report_.incomplete;
    heading((report_.dry_run ? "dry run, nothing written" : "written ") +
            (report_.dry_run ? std::string() : printable(output.path)));
    line(fmt::format("{}{}, {}", report_.dry_run ? std::string() : byte_size(output.bytes) + ", ",
                     counted(output.result.figures.faces, "face"),
                     counted(output.result.figures.vertices, "vertex", "vertices")));
    if (!options_.twin.empty()) {
      out_ += fmt::format("  compressed twin {}, {}, decoded to the same\n", printable(options_.twin),
                          byte_size(options_.twin_bytes));
    }
    if (report_.solution && report_.solution->light_map) light_map(*report_.solution->light_map);
    if (!options_.picture.empty()) out_ += fmt::format("  picture {}\n", printable(options_.picture));
    if (!options_.viewer.empty()) out_ += fmt::format("  page {}\n", printable(options_.viewer));
    if (!options_.annotated.empty()) out_ += fmt::format("  annotated model {}\n", printable(options_.annotated));
    out_ += fmt::format("\n{}  {}: {} at stage {}{}{}\n", clean ? paint_(Ink::Green, "pass") : paint_(Ink::Red, "FAIL"),
                        report_.dry_run ? "would be" : "read back", counts_text(left), validate::name(after.stage),
                        report_.awaited > 0 ? fmt::format(", {} of them for later stages", report_.awaited) : "",
                        report_.incomplete ? "; stopped before the end" : "");
    if (report_.dry_run) return;
    const std::string again =
        after.stage == validate::Stage::Model ? std::string() : fmt::format("--stage {} ", validate::name(after.stage));
    if (left.errors > 0) out_ += fmt::format("next: radlint {}{}\n", again, printable(output.path));
  }

  const RepairReport& report_;
  const RepairTextOptions& options_;
  Paint paint_;
  const InputReport& before_;
  std::string out_;
};

}  // namespace

std::string text(const RepairReport& report, const RepairTextOptions& options) {
  return RepairText(report, options).run();
}

}  // namespace rad::report
