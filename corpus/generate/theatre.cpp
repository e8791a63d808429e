// A theatre: seat rows on curved steps, faceted walls and ceiling, a stage, and catwalks with rungs under the ceiling
// that throw the finest shadows. About as many surfaces as the theatre of the paper's Table 3.
#include <cmath>
#include <numbers>

#include "corpus/generate/furniture.h"
#include "corpus/generate/models.h"

namespace rad::corpus {
namespace {

// The middle of all arcs is the origin, on the stage's edge; the house lies north of it. Angles are from north,
// clockwise, in degrees.
constexpr int kRows = 11, kFirstRow = 6500, kRowDepth = 950, kRiser = 160;
constexpr int kWallRadius = 19000, kFacets = 24, kHalfAngle = 54, kCeiling = 10500;
constexpr int kStageHalf = 9000, kStageDepth = 9000, kStageTop = 900, kCatwalk = 8200;

Planar on_arc(double radius, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {static_cast<int>(std::lround(radius * std::sin(angle))),
          static_cast<int>(std::lround(radius * std::cos(angle)))};
}

// Between two radii, faceted; counter-clockwise from above.
Outline arc_band(double inner, double outer, double from, double to, int facets) {
  Outline outline;
  for (int i = 0; i <= facets; ++i) outline.push_back(on_arc(inner, to + (from - to) * i / facets));
  for (int i = 0; i <= facets; ++i) outline.push_back(on_arc(outer, from + (to - from) * i / facets));
  return reversed(outline);
}

// A rectangle as it stands on the arc: its middle at `degrees`, its front edge facing the stage.
Outline on_row(double radius, double degrees, int left, int right, int depth_from, int depth_to) {
  const double angle = degrees * std::numbers::pi / 180;
  const auto place = [&](double u, double v) {
    return Planar{static_cast<int>(std::lround((radius + v) * std::sin(angle) + u * std::cos(angle))),
                  static_cast<int>(std::lround((radius + v) * std::cos(angle) - u * std::sin(angle)))};
  };
  return {place(left, depth_from), place(right, depth_from), place(right, depth_to), place(left, depth_to)};
}

void define_materials(Modeller& modeller) {
  define_furniture_materials(modeller);
  modeller.define_material("plaster", {0.74, 0.73, 0.7});
  modeller.define_material("carpet", {0.36, 0.12, 0.12});
  modeller.define_material("upholstery", {0.42, 0.1, 0.12});
  modeller.define_material("stage_boards", {0.42, 0.32, 0.2});
  modeller.define_material("velvet", {0.45, 0.06, 0.08});
  modeller.define_material("spot_light", {0.8, 0.8, 0.8}, {2600, 2450, 2200});
  modeller.define_material("cove_light", {0.8, 0.8, 0.8}, {180, 165, 140});
}

const Frame kPlan = plan_at({0, 0, 0});

void add_seat(Exporter& exporter, double radius, double degrees, int floor) {
  exporter.begin("seat");
  exporter.paint("upholstery");
  Modeller& modeller = exporter.modeller();
  prism(modeller, kPlan, on_row(radius, degrees, -230, 230, 120, 560), floor - kSunk, floor + 440);
  prism(modeller, kPlan, on_row(radius, degrees, -230, 230, 545, 620), floor + 395, floor + 900);
}

void add_row(Exporter& exporter, int row) {
  const double radius = kFirstRow + row * kRowDepth;
  const int floor = row * kRiser;
  exporter.begin("step");
  exporter.paint("carpet");
  // The step as boxes that each reach under the next row: their tops meet with corners in edges.
  const int facets = 8 + row % 2;
  for (int i = 0; i < facets; ++i) {
    const double from = -48 + 96.0 * i / facets, to = -48 + 96.0 * (i + 1) / facets;
    prism(exporter.modeller(), kPlan, arc_band(radius, radius + kRowDepth + 60, from, to, 1), -300, floor);
  }
  const double pitch = 690 / radius * 180 / std::numbers::pi;
  for (const double block : {-30.5, 0.0, 30.5}) {
    const double half = block == 0.0 ? 15.5 : 11.5;
    const int seats = static_cast<int>(2 * half / pitch);
    for (int seat = 0; seat < seats; ++seat)
      add_seat(exporter, radius, block + pitch * (seat - (seats - 1) / 2.0), floor);
  }
}

// A facet of the wall is three panels one above the other; those of its neighbours meet at other heights.
void add_walls(Exporter& exporter) {
  exporter.begin("wall");
  exporter.paint("plaster");
  const double step = 2.0 * kHalfAngle / kFacets;
  for (int i = 0; i < kFacets; ++i) {
    const double from = -kHalfAngle + i * step, to = from + step;
    const int radius = kWallRadius + (i % 2 == 0 ? 0 : 350);
    const Planar a = on_arc(radius, from), b = on_arc(radius, to);
    int low = -310;
    for (const int high : {2400 + 300 * (i % 3), 6300 - 200 * (i % 2), kCeiling}) {
      exporter.modeller().face(side(kPlan, a, b, low, high));
      low = high;
    }
    const Planar c = on_arc(kWallRadius + 350 - (radius - kWallRadius), to);
    if (i + 1 < kFacets) {
      exporter.modeller().face(side(kPlan, b, c, -310, kCeiling));
    }
    exporter.paint(i % 4 == 1 ? "cove_light" : "plaster");
    if (i % 4 == 1)
      exporter.modeller().face(side(kPlan, on_arc(radius - 2, from + 1), on_arc(radius - 2, to - 1), 2500, 2620));
    exporter.paint("plaster");
  }
  for (const int hand : {-1, 1}) {  // from the facets to the stage house
    const Planar end = on_arc(kWallRadius + (hand < 0 ? 0 : 350), hand * kHalfAngle), stage{hand * kStageHalf, 0};
    exporter.modeller().face(hand < 0 ? side(kPlan, stage, end, -310, kCeiling)
                                      : side(kPlan, end, stage, -310, kCeiling));
  }
}

void add_floor_and_ceiling(Exporter& exporter) {
  exporter.begin("floor");
  exporter.paint("carpet");
  exporter.sheet(kPlan, {-kWallRadius, -100}, {kWallRadius, kWallRadius + 400}, -300);
  exporter.begin("ceiling");
  exporter.paint("plaster");
  for (int i = 0; i < 6; ++i) {  // strips as exported, each with other ends
    const int from = -kWallRadius + i * kWallRadius / 3, to = from + kWallRadius / 3;
    panel(exporter.modeller(), kPlan, rectangle({from, -200 + 40 * (i % 2)}, {to, kWallRadius + 500}), kCeiling,
          Facing::Against);
  }
}

void add_stage(Exporter& exporter) {
  exporter.begin("stage");
  exporter.paint("stage_boards");
  Outline apron = arc_band(1, 4200, -60, 60, 12);
  prism(exporter.modeller(), kPlan, apron, -300, kStageTop);
  exporter.slab(plan_at({-kStageHalf, -kStageDepth, 0}), {2 * kStageHalf, kStageDepth + 30},
                {{{6000, 2500}, {8000, 4000}}}, -300, kStageTop);
  exporter.begin("stage_house");
  exporter.paint("black_lacquer");
  const Outline house = rectangle({-kStageHalf, -kStageDepth}, {kStageHalf, 0});
  for (const std::size_t i : {0U, 1U, 3U})
    exporter.modeller().face(side(kPlan, house[(i + 1) % 4], house[i], -310, kCeiling));
  panel(exporter.modeller(), kPlan, house, kCeiling, Facing::Against);
  exporter.begin("proscenium");
  exporter.paint("walnut");
  exporter.wall(moved(plan_at({-kStageHalf, 0, 0}), {0, -250}), 2 * kStageHalf, 500, kCeiling,
                {{{1800, 0}, {2 * kStageHalf - 1800, 7200}}});
  exporter.begin("curtain");
  exporter.paint("velvet");
  for (const int hand : {-1, 1}) {
    for (int fold = 0; fold < 16; ++fold) {
      const int u = hand < 0 ? -7400 + fold * 160 : 4840 + fold * 160, v = -700;
      exporter.modeller().face(
          side(kPlan, {u + 160, v + 120 * (fold % 2 == 0)}, {u, v + 120 * (fold % 2 != 0)}, kStageTop, 7300));
    }
  }
  for (int flat = 0; flat < 4; ++flat) {
    exporter.begin("flat");
    exporter.paint(flat % 2 == 0 ? "canvas" : "linen");
    exporter.box(plan_at({-6500 + flat * 3400, -4500 - 900 * (flat % 2), kStageTop}), {0, 0, -kSunk}, {2200, 60, 3600});
  }
  add_table(exporter, plan_at({-900, -2900, kStageTop}), {1800, 900}, 750);
  add_chair(exporter, turned(plan_at({300, -2950, kStageTop}), 2));
  add_chair(exporter, plan_at({-500, -2100, kStageTop}));
}

// A walk along u: two side frames of rails with rungs between them, a floor of slats, spots on the frames.
void add_catwalk(Exporter& exporter, const Frame& frame, int length) {
  constexpr int kWalk = 1100, kRail = 60, kRungs = 700;
  exporter.begin("catwalk");
  exporter.paint("steel");
  for (const int v : {0, kWalk - kRail}) {
    for (const int foot : {0, 1040}) exporter.box(frame, {0, v, foot}, {length, v + kRail, foot + kRail});
    for (int u = kRungs; u + kRungs < length; u += kRungs) {
      exporter.box(frame, {u, v + 15, kRail - 6}, {u + 30, v + kRail - 15, 1046});
    }
  }
  for (int u = 100; u + 200 < length; u += 700)
    exporter.box(frame, {u, kRail - 8, 10}, {u + 90, kWalk - kRail + 8, 45});
  for (int u = 1200; u + 600 < length; u += 2400) {
    exporter.begin("spot");
    exporter.paint("black_lacquer");
    exporter.box(frame, {u, -260, -420}, {u + 260, 10, -60});
    exporter.box(frame, {u + 110, -140, -70}, {u + 150, -100, 30});
    exporter.paint("spot_light");
    panel(exporter.modeller(), frame, rectangle({u + 30, -230}, {u + 230, -20}), -421, Facing::Against);
  }
  for (int u = 600; u < length; u += 4800) {
    exporter.begin("hanger");
    exporter.paint("steel");
    for (const int v : {10, kWalk - 50}) exporter.post(frame, {u, v}, 40, 1050, kCeiling - kCatwalk + 5);
  }
}

// Sound reflectors under the ceiling: bent plates of facets, closed solids.
void add_reflector(Exporter& exporter, int v, int height, int half) {
  exporter.begin("reflector");
  exporter.paint("white_lacquer");
  Outline outline;
  constexpr int kFacetsOfPlate = 9;
  const auto point = [&](int i, int lift) {
    const double bend = (i - kFacetsOfPlate / 2.0) / kFacetsOfPlate;
    return Planar{v + 240 * i, height + lift - static_cast<int>(std::lround(1300 * bend * bend))};
  };
  for (int i = 0; i <= kFacetsOfPlate; ++i) outline.push_back(point(i, 0));
  for (int i = kFacetsOfPlate; i >= 0; --i) outline.push_back(point(i, 90));
  prism(exporter.modeller(), facing_east({0, 0, 0}), outline, -half, half);
}

}  // namespace

scene::Scene theatre() {
  Exporter exporter("theatre.obj", 1990);
  define_materials(exporter.modeller());
  add_floor_and_ceiling(exporter);
  add_walls(exporter);
  add_stage(exporter);
  for (int row = 0; row < kRows; ++row) add_row(exporter, row);
  for (const int v : {3200, 7600, 12400}) add_catwalk(exporter, plan_at({-8400, v, kCatwalk}), 16800);
  for (int i = 0; i < 4; ++i) add_reflector(exporter, 2100 + 3600 * i, 9400 + 100 * i, 5200 + 500 * i);
  return exporter.take();
}

}  // namespace rad::corpus
