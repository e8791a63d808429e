#include "cli/contracts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/written_faces.h"
#include "repair/monotone.h"
#include "repair/repair.h"
#include "validate/promises.h"
#include "validate/registry.h"

namespace rad::cli {
namespace {

using scene::Filter;
using scene::FilterSet;
using validate::Requirement;

constexpr std::size_t kRequirements = static_cast<std::size_t>(Requirement::Ziplocking) + 1;

std::string_view name(validate::Cell cell) {
  switch (cell) {
    case validate::Cell::Required:
      return "required";
    case validate::Cell::Generated:
      return "generated";
    case validate::Cell::PassThrough:
      return "passed";
    case validate::Cell::Blank:
      break;
  }
  return "";
}

// Rules that show a requirement to be broken: not those that only ask or inform.
bool tests_a_requirement(const validate::Rule& rule) {
  return static_cast<std::size_t>(rule.requirement) < kRequirements && rule.kind == scene::FindingKind::Fail &&
         rule.severity != scene::Severity::Note;
}

using Broken = std::map<Requirement, std::size_t>;

class Contracts {
 public:
  Contracts(const Model& model, const FixCommand& command, LiveLine& line, const InterruptWatch& watch)
      : model_(model), command_(command), line_(line), watch_(watch) {}

  std::vector<report::ContractCheck> run() {
    scene::Scene input = model_.content.scene;
    Broken before = broken_in(input);
    if (command_.filters.has(Filter::Orient)) {
      const repair::Repaired turned = repair_with(input, {Filter::Orient});
      if (turned.turned) input = *turned.turned;
      before = broken_in(input);
    }
    FilterSet done;
    for (const Filter filter : scene::kFilters) {
      if (!command_.filters.has(filter) || filter > Filter::Emesh || watch_.interrupted()) continue;
      done.add(filter);
      const Broken after = broken_in(result_of(input, done, filter));
      compare(filter, before, after);
      before = after;
    }
    return std::move(checks_);
  }

 private:
  repair::Repaired repair_with(const scene::Scene& scene, const FilterSet& filters) {
    line_.show("contracts: " + scene::names(filters));
    repair::RepairOptions options;
    options.tolerance = command_.model.tolerance;
    options.filters = filters;
    options.progress = [&](const char*, std::size_t) { return !watch_.interrupted(); };
    return repair::repair(scene, model_.content.issues, options);
  }

  scene::Scene result_of(const scene::Scene& input, const FilterSet& done, Filter last) {
    if (last > Filter::Orient) {
      FixCommand command = command_;
      command.filters = done;
      return make_product(model_, command, {true, false}, line_, watch_).scene;
    }
    const repair::Repaired repaired = repair_with(input, done);
    if (repaired.untouched) return input;
    if (repaired.turned) return *repaired.turned;
    return scene::pieces_of(repaired.model, input, faces_with_inner_edges(repaired.model)).scene;
  }

  Broken broken_in(const scene::Scene& scene) {
    Broken broken;
    for (const auto& [id, count] : repair::broken_counts(scene, command_.model.tolerance, &tests_a_requirement)) {
      broken[validate::find_rule(id)->requirement] += count;
    }
    return broken;
  }

  void compare(Filter filter, const Broken& before, const Broken& after) {
    for (std::size_t row = 0; row < kRequirements; ++row) {
      const auto requirement = static_cast<Requirement>(row);
      const validate::Cell cell = validate::table_two(filter, requirement);
      const bool tested = std::ranges::any_of(validate::all_rules(), [&](const validate::Rule* rule) {
        return rule->requirement == requirement && tests_a_requirement(*rule);
      });
      if (cell == validate::Cell::Blank || !tested) continue;
      report::ContractCheck check{std::string(scene::name(filter)), std::string(validate::code(requirement)),
                                  std::string(name(cell)),          count_in(before, requirement),
                                  count_in(after, requirement),     true};
      check.holds = cell == validate::Cell::Required    ? check.before == 0
                    : cell == validate::Cell::Generated ? check.after == 0
                                                        : check.after <= check.before;
      checks_.push_back(std::move(check));
    }
  }

  static std::uint64_t count_in(const Broken& broken, Requirement requirement) {
    const auto found = broken.find(requirement);
    return found == broken.end() ? 0 : found->second;
  }

  const Model& model_;
  const FixCommand& command_;
  LiveLine& line_;
  const InterruptWatch& watch_;
  std::vector<report::ContractCheck> checks_;
};

std::string_view title_of(std::string_view code) {
  for (std::size_t row = 0; row < kRequirements; ++row) {
    if (validate::code(static_cast<Requirement>(row)) == code) return validate::title(static_cast<Requirement>(row));
  }
  return "";
}

}  // namespace

std::vector<report::ContractCheck> check_contracts(const Model& model, const FixCommand& command, LiveLine& line,
                                                   const InterruptWatch& watch) {
  return Contracts(model, command, line, watch).run();
}

std::string broken_contracts(const std::vector<report::ContractCheck>& checks) {
  std::string text;
  for (const report::ContractCheck& check : checks) {
    if (check.holds) continue;
    const std::string what = fmt::format("{} ({})", check.requirement, title_of(check.requirement));
    if (!text.empty()) text += "; ";
    if (check.cell == "required") {
      text += fmt::format("{} requires {}, which {} places break", check.stage, what, check.before);
    } else if (check.cell == "generated") {
      text += fmt::format("{} does not generate {}: {} places are left", check.stage, what, check.after);
    } else {
      text +=
          fmt::format("{} does not pass {} through: {} places become {}", check.stage, what, check.before, check.after);
    }
  }
  return text;
}

}  // namespace rad::cli
