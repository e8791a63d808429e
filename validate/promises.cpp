#include "validate/promises.h"

#include <algorithm>
#include <array>

namespace rad::validate {
namespace {

using scene::Filter;

constexpr Cell kBlank = Cell::Blank, kRequired = Cell::Required, kGenerated = Cell::Generated,
               kPassed = Cell::PassThrough;

// Rows 1a to 3a; columns Grouper, Isect, Coplanar, Orient, Pmesh, Emesh. Orient is the project's: the paper presupposes
// it.
constexpr std::array<std::array<Cell, 6>, 11> kTable{{
    {kPassed, kPassed, kPassed, kPassed, kPassed, kPassed},         // 1a solid model, valid facades
    {kRequired, kPassed, kRequired, kGenerated, kPassed, kPassed},  // 1b normal consistency
    {kGenerated, kRequired, kPassed, kPassed, kRequired, kBlank},   // 1c maximally connected planar faces
    {kGenerated, kPassed, kPassed, kPassed, kPassed, kPassed},      // 2a no T-vertices
    {kBlank, kGenerated, kRequired, kPassed, kPassed, kPassed},     // 2b no implicit intersections
    {kBlank, kBlank, kGenerated, kPassed, kPassed, kBlank},         // 2c no overlapping coplanar faces
    {kBlank, kBlank, kBlank, kBlank, kGenerated, kPassed},          // 2d simple mesh faces
    {kBlank, kBlank, kBlank, kBlank, kGenerated, kPassed},          // 2e well-shaped faces
    {kBlank, kBlank, kBlank, kBlank, kGenerated, kPassed},          // 2f sufficient radiator density
    {kBlank, kBlank, kBlank, kBlank, kBlank, kGenerated},           // 2g sufficient receiver density
    {kGenerated, kPassed, kPassed, kPassed, kPassed, kPassed},      // 3a ziplocking
}};

}  // namespace

Cell table_two(Filter filter, Requirement requirement) {
  const auto row = static_cast<std::size_t>(requirement), column = static_cast<std::size_t>(filter);
  return row < kTable.size() && column < kTable[row].size() ? kTable[row][column] : Cell::Blank;
}

bool is_awaited(Requirement requirement, const scene::FilterSet& done) {
  return std::ranges::any_of(scene::kFilters, [&](Filter filter) {
    return scene::kRepairFilters.has(filter) && !done.has(filter) && table_two(filter, requirement) == Cell::Generated;
  });
}

}  // namespace rad::validate
