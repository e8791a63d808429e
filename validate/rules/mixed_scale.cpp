#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "validate/component_members.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"accuracy", "1", 0.002, 1e-6, 0.05, "how near to the factor between two units a ratio has to be"},
    Parameter{"min-faces", "faces", 12, 4, 1e6, "parts of fewer faces are alike by chance"},
};

struct Factor {
  double value;
  std::string_view words;
};

// Between any two units that models are drawn in, but 10 and 100, by which one also scales on purpose.
constexpr std::array<Factor, 6> kFactors{{
    {25.4, "25.4 times, as inches read as millimetres"},
    {1000, "1000 times, as metres read as millimetres"},
    {304.8, "304.8 times, as feet read as millimetres"},
    {1 / 0.0254, "39.37 times, as metres read as inches"},
    {1 / 0.3048, "3.2808 times, as metres read as feet"},
    {2.54, "2.54 times, as inches read as centimetres"},
}};

/// What two copies of one thing have in common at any size: counts, and proportions of box and area.
struct Shape {
  std::uint32_t component = 0;
  std::array<std::uint32_t, 2> counts{};  ///< faces, subedges
  std::array<double, 3> proportions{};    ///< box sides over diagonal, the shortest first; area over diagonal²
  double diagonal = 0;                    ///< pitches
};

Shape shape_of(std::uint32_t id, const Component& component) {
  const auto side = [](std::int32_t low, std::int32_t high) { return static_cast<double>(high) - low; };
  std::array<double, 3> sides{side(component.low.x, component.high.x), side(component.low.y, component.high.y),
                              side(component.low.z, component.high.z)};
  std::ranges::sort(sides);
  const double diagonal = std::hypot(sides[0], sides[1], sides[2]);
  return {id,
          {component.faces, component.subedges},
          {sides[0] / diagonal, sides[1] / diagonal, component.area / (diagonal * diagonal)},
          diagonal};
}

bool similar(const Shape& a, const Shape& b, double accuracy) {
  for (std::size_t i = 0; i < a.proportions.size(); ++i) {
    if (std::abs(a.proportions[i] - b.proportions[i]) > accuracy) return false;
  }
  return true;
}

const Factor* unit_factor(double ratio, double accuracy) {
  const auto found = std::ranges::find_if(
      kFactors, [&](const Factor& factor) { return std::abs(ratio / factor.value - 1) <= accuracy; });
  return found == kFactors.end() ? nullptr : &*found;
}

// Of equal counts, by size; those with the least and the most faces of all come in any order.
std::map<std::array<std::uint32_t, 2>, std::vector<Shape>> shapes_by_counts(const Context& context) {
  const double fewest = context.parameter(mixed_scale, "min-faces");
  std::map<std::array<std::uint32_t, 2>, std::vector<Shape>> shapes;
  const auto& components = context.topology.components;
  for (std::uint32_t id = 0; id < components.size(); ++id) {
    if (components[id].faces < fewest) continue;
    const Shape shape = shape_of(id, components[id]);
    if (shape.diagonal > 0) shapes[shape.counts].push_back(shape);
  }
  for (auto& [counts, alike] : shapes) std::ranges::stable_sort(alike, {}, &Shape::diagonal);
  return shapes;
}

struct Pair {
  std::uint32_t small = 0, large = 0;
  double ratio = 1;
  const Factor* factor = nullptr;
};

// Each of the larger with the smallest that it may be a copy of: one pair for each distinct size is enough.
std::vector<Pair> copies_in_other_units(const Context& context) {
  const double accuracy = context.parameter(mixed_scale, "accuracy");
  std::vector<Pair> pairs;
  for (const auto& [counts, alike] : shapes_by_counts(context)) {
    for (const Shape& large : alike) {
      for (const Factor& factor : kFactors) {
        const double wanted = large.diagonal / factor.value;
        auto small = std::ranges::lower_bound(alike, wanted * (1 - accuracy), {}, &Shape::diagonal);
        if (small == alike.end() || !unit_factor(large.diagonal / small->diagonal, accuracy)) continue;
        if (!similar(*small, large, accuracy)) continue;
        pairs.push_back({small->component, large.component, large.diagonal / small->diagonal, &factor});
        break;
      }
    }
  }
  return pairs;
}

void check(const Context& context, Violations& out) {
  if (context.topology.components.size() < 2) return;
  const std::vector<Pair> pairs = copies_in_other_units(context);
  if (pairs.empty()) return;
  const ComponentMembers members = members_of_components(context);
  for (const Pair& pair : pairs) {
    const FaceId large = first_face(context, members.faces[pair.large]);
    out.add({.faces = {large, first_face(context, members.faces[pair.small])},
             .point = context.centre(large),
             .measure = pair.ratio,
             .cluster = kPerParticipants,
             .detail = pair.factor->words});
  }
}

}  // namespace

constinit const Rule mixed_scale{
    .id = "RL504",
    .alias = "mixed-scale",
    .title = "Copies of one part differ by the factor between two units",
    .message = "{n} part{s} {repeats|repeat} another of the same shape{object} at {detail}",
    .requirement = Requirement::Units,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"ratio of sizes", MeasureUnit::Ratio},
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "Two parts have the same shape, and one is larger by just the factor between two units: 25.4, "
                    "1000, 304.8, 39.37, 3.2808 or 2.54.",
            .why = "Parts that were drawn in different units were put into one model. One of them is a giant or a "
                   "grain of dust, and patches, light and the tolerance suffer.",
            .how = "Connected parts of at least 12 faces with the same numbers of faces and edges, the same "
                   "proportions of their boxes and the same area over diagonal squared, to 0.2 %, whose diagonals "
                   "differ by such a factor to 0.2 %.",
            .fix = "Scale the part that is wrong before export.",
            .modeller = "SketchUp: Tape Measure, resize the component. Rhino: Scale by the factor named. Blender: "
                        "apply the unit scale at import. Revit: check the import units of linked CAD.",
            .limits = "Parts that have no copy in the right size are not noticed: RL502 judges the model as a whole. "
                      "Factors of 10 and 100 are left out, since one also scales by them on purpose."},
    .parameters = kParameters,
    .check = &check,
};

}  // namespace rad::validate
