#include "cli/repair_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/written_faces.h"
#include "repair/monotone.h"
#include "validate/promises.h"
#include "validate/registry.h"

namespace rad::cli {
namespace {

using scene::Filter;
using scene::FilterSet;

class Run {
 public:
  Run(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
      const InterruptWatch& watch, const RepairFunction& repair)
      : input_(model.content.scene),
        issues_(model.content.issues),
        command_(command),
        target_(target),
        line_(line),
        watch_(watch),
        repair_(repair) {}

  RepairRun run() {
    FilterSet filters = command_.filters.common(scene::kRepairFilters);
    const bool any = !filters.empty();
    while (true) {
      repair_with(filters);
      const std::vector<repair::Rise> worse = what_got_worse();
      if (worse.empty()) break;
      roll_back(filters, worse);
      if (any && filters.empty()) {
        result_.all_rolled_back = true;
        break;
      }
    }
    result_.done = filters;
    auto& ledger = result_.repaired.ledger;
    ledger.insert(ledger.end(), roll_backs_.begin(), roll_backs_.end());
    return std::move(result_);
  }

 private:
  void repair_with(const FilterSet& filters) {
    repair::RepairOptions options;
    options.tolerance = command_.model.tolerance;
    options.filters = filters;
    options.coplanar = command_.coplanar;
    options.stage = target_.stage;
    options.progress = [&](const char* step, std::size_t left) {
      line_.show(left > 0 ? fmt::format("repair: {}, {} left", step, left) : fmt::format("repair: {}", step));
      return !watch_.interrupted();
    };
    result_.repaired = repair_(input_, issues_, options);
    choose_pieces();
  }

  [[nodiscard]] geom::ToleranceRequest tolerance() const {
    return {result_.repaired.model.tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
  }

  void choose_pieces() {
    const repair::Repaired& repaired = result_.repaired;
    result_.input_as_it_was = !target_.triangles && (repaired.untouched || repaired.turned);
    if (target_.stage && repaired.stage) {
      result_.pieces = {*repaired.stage, {}, {}};
    } else if (result_.input_as_it_was) {
      result_.pieces = {repaired.turned ? *repaired.turned : input_, {}, {}};
    } else {
      result_.pieces = pieces_of_model();
    }
  }

  // What is not cut where faces meet is judged by those that follow.
  [[nodiscard]] scene::PiecesOfModel pieces_of_model() const {
    const scene::ConformingModel& model = result_.repaired.model;
    if (target_.triangles) return scene::pieces_of(model, input_, std::vector<bool>(model.faces.size(), true));
    if (result_.repaired.interrupted || leaves_work_to_coplanar()) {
      return scene::pieces_of(model, input_, faces_with_inner_edges(model));
    }
    return faces_to_write(model, input_);
  }

  // What is not cut or lies in layers is at fault whatever it is written as.
  [[nodiscard]] bool leaves_work_to_coplanar() const {
    const bool begun = command_.filters.has(Filter::Grouper) || command_.filters.has(Filter::Isect);
    return begun && !command_.filters.has(Filter::Coplanar);
  }

  // Nothing where the second lint of a whole run has found nothing: that asks for more than this.
  std::vector<repair::Rise> what_got_worse() {
    const repair::Repaired& repaired = result_.repaired;
    const bool proven = repaired.unresolved == 0 && !command_.partial;
    if (repaired.untouched || repaired.model.faces.empty() || repaired.interrupted || proven) return {};
    line_.show("repair: judging");
    if (!before_) before_ = repair::error_counts(input_, tolerance());
    std::vector<repair::Rise> worse = repair::rises(*before_, repair::error_counts(result_.pieces.scene, tolerance()));
    std::erase_if(worse, [&](const repair::Rise& rise) {
      return command_.partial && validate::is_awaited(validate::find_rule(rise.rule)->requirement, command_.filters);
    });
    return worse;
  }

  // The filter that came last is taken out. Where Grouper goes, orientation alone may still be of use.
  void roll_back(FilterSet& filters, const std::vector<repair::Rise>& worse) {
    Filter last = Filter::Orient;
    for (const Filter filter : scene::kFilters) {
      if (filters.has(filter)) last = filter;
    }
    filters.remove(last);
    if (last == Filter::Grouper && command_.filters.has(Filter::Orient)) filters.add(Filter::Orient);
    std::string why;
    scene::LedgerEntry entry{std::string(scene::name(last)), "roll-back", {}, 1, 0, std::nullopt};
    for (const repair::Rise& rise : worse) {
      entry.rules.emplace_back(rise.rule);
      why += fmt::format("{}{} from {} to {}", why.empty() ? "" : ", ", rise.rule, rise.before, rise.after);
    }
    roll_backs_.push_back(std::move(entry));
    result_.rolled_back.push_back(fmt::format("{} is rolled back: it would raise {}", scene::name(last), why));
  }

  const scene::Scene& input_;
  const scene::ReadIssues& issues_;
  const FixCommand& command_;
  RepairTarget target_;
  LiveLine& line_;
  const InterruptWatch& watch_;
  const RepairFunction& repair_;
  std::optional<repair::BrokenCounts> before_;
  scene::Ledger roll_backs_;
  RepairRun result_;
};

}  // namespace

RepairRun run_repair(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
                     const InterruptWatch& watch, const RepairFunction& repair) {
  return Run(model, command, target, line, watch, repair).run();
}

}  // namespace rad::cli
