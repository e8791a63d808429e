#include "cli/filter_words.h"

#include <fmt/format.h>

#include <optional>

#include "cli/nearest.h"

namespace rad::cli {
namespace {

using scene::Filter;
using scene::FilterSet;

constexpr std::string_view kAllOfRepair = "repair";

std::string unknown(std::string_view option, const std::string& word, bool repair_too) {
  std::vector<std::string_view> names;
  for (const Filter filter : scene::kFilters) names.push_back(scene::name(filter));
  if (repair_too) names.push_back(kAllOfRepair);
  return fmt::format("{}: there is no stage '{}'{} (grouper, isect, coplanar, orient, pmesh, emesh, solve, bake{})",
                     option, word, did_you_mean(nearest(word, names)), repair_too ? "; repair: the first four" : "");
}

std::string read_only(const std::vector<std::string>& words, FilterSet& into) {
  for (const std::string& word : words) {
    const auto filter = scene::parse_filter(word);
    if (!filter) return unknown("--only", word, false);
    into.add(*filter);
  }
  return {};
}

std::string read_skip(const std::vector<std::string>& words, FilterSet& into) {
  for (const std::string& word : words) {
    const auto filter = scene::parse_filter(word);
    if (!filter && word != kAllOfRepair) return unknown("--skip", word, true);
    into.remove(filter ? FilterSet{*filter} : scene::kRepairFilters);
  }
  return {};
}

std::string read_until(const FixWords& words, FilterSet& into) {
  const auto last = scene::parse_filter(words.until);
  if (!last) return unknown("--until", words.until, false);
  if ((words.solve && *last < Filter::Bake) || (words.mesh && *last < Filter::Emesh)) {
    return fmt::format("--until {} ends before what --{} asks for; leave one of them out", words.until,
                       words.solve ? "solve" : "mesh");
  }
  into = FilterSet::until(*last);
  return {};
}

FilterSet without_words(const FixWords& words) {
  if (words.solve) return FilterSet::until(Filter::Bake);
  return words.mesh ? FilterSet::until(Filter::Emesh) : scene::kRepairFilters;
}

// What a filter works on must come from the run itself: no file holds patches, elements or a solution.
std::string missing_filter(const FilterSet& filters) {
  for (const Filter filter : {Filter::Emesh, Filter::Solve}) {
    if (filters.has(filter) && !filters.has(Filter::Pmesh)) {
      return fmt::format("{} works on the patches that pmesh makes in the same run; do not leave pmesh out",
                         scene::name(filter));
    }
  }
  if (filters.has(Filter::Bake) && !filters.has(Filter::Solve)) {
    return "bake shows what solve found in the same run; do not leave solve out";
  }
  return {};
}

}  // namespace

std::string read_filters(const FixWords& words, FixCommand& into) {
  into.filters = without_words(words);
  into.partial = !words.only.empty() || !words.until.empty();
  std::string fault;
  if (!words.only.empty()) {
    if (!words.until.empty()) return "--only and --until exclude each other";
    if (words.mesh || words.solve) {
      return fmt::format("--only names all stages that run; leave --{} out", words.solve ? "solve" : "mesh");
    }
    into.filters = {};
    fault = read_only(words.only, into.filters);
  } else if (!words.until.empty()) {
    fault = read_until(words, into.filters);
  }
  if (fault.empty()) fault = read_skip(words.skip, into.filters);
  return fault.empty() ? missing_filter(into.filters) : fault;
}

}  // namespace rad::cli
