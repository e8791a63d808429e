// A furnished house of two storeys: about as many surfaces as the residence of the paper's Table 3, and with the faults
// of the programs that such models come from.
#include <algorithm>

#include "corpus/generate/furniture.h"
#include "corpus/generate/models.h"

namespace rad::corpus {
namespace {

constexpr int kLength = 16000, kWidth = 11000, kOuter = 300, kInner = 120, kClear = 2700, kStorey = 3000;
constexpr int kWest = 6000, kEast = 10500;              // of the inner walls that run north
constexpr Opening kStairs{{8600, 1500}, {9700, 5900}};  // of the upper floor
constexpr int kSteps = 16;

void define_materials(Modeller& modeller) {
  define_furniture_materials(modeller);
  modeller.define_material("floorboards", {0.48, 0.36, 0.24});
  modeller.define_material("plaster", {0.78, 0.77, 0.74});
  modeller.define_material("brick", {0.46, 0.3, 0.25});
  modeller.define_material("tiles", {0.66, 0.68, 0.68});
  modeller.define_material("roof_tiles", {0.38, 0.2, 0.15});
  modeller.define_material("lawn", {0.2, 0.3, 0.14});
  modeller.define_material("wool", {0.45, 0.2, 0.17});
  modeller.define_material("sky_light", {0.8, 0.8, 0.8}, {45, 50, 60});
}

Opening window(int from, int width = 1400) { return {{from, 900}, {from + width, 2200}}; }
Opening door(int from) { return {{from, 0}, {from + 900, 2100}}; }

void add_window_frame(Exporter& exporter, const Frame& wall, const Opening& opening) {
  const Frame front = upright(wall);
  exporter.begin("window_frame");
  exporter.paint("white_lacquer");
  const auto bar = [&](Planar low, Planar high) {
    prism(exporter.modeller(), front, rectangle(low, high), -190, -130);
  };
  const auto [low, high] = opening;
  bar({low.u - 5, low.v - 5}, {low.u + 50, high.v + 5});
  bar({high.u - 50, low.v - 5}, {high.u + 5, high.v + 5});
  bar({low.u + 45, low.v - 5}, {high.u - 45, low.v + 50});
  bar({low.u + 45, high.v - 50}, {high.u - 45, high.v + 5});
  const int middle = (low.u + high.u) / 2;
  bar({middle - 25, low.v + 45}, {middle + 25, high.v - 45});
  exporter.begin("sill");
  prism(exporter.modeller(), front, rectangle({low.u - 60, low.v - 30}, {high.u + 60, low.v}), -150, 70);
  exporter.begin("daylight");  // a facade in the opening that shines inwards
  exporter.paint("sky_light");
  exporter.sheet(front, {low.u + 45, low.v + 45}, {middle - 25, high.v - 45}, -160);
  exporter.sheet(front, {middle + 25, low.v + 45}, {high.u - 45, high.v - 45}, -160);
}

void add_door(Exporter& exporter, const Frame& wall, const Opening& opening, bool open) {
  const Frame front = upright(wall);
  exporter.begin("door_frame");
  exporter.paint("white_lacquer");
  const auto [low, high] = opening;
  for (const int from : {low.u - 40, high.u - 10}) {
    prism(exporter.modeller(), front, rectangle({from, -kSunk}, {from + 50, high.v + 40}), -kInner - 12, 12);
  }
  prism(exporter.modeller(), front, rectangle({low.u + 10, high.v - 10}, {high.u - 10, high.v + 40}), -kInner - 12, 12);
  exporter.begin("door");
  exporter.paint("oak");
  Frame leaf = moved(wall, {low.u + 14, 0});
  if (open) leaf = turned(leaf, 3);
  exporter.box(leaf, {0, 20, 8}, {872, 60, 2080});
  exporter.paint("brass");
  exporter.box(leaf, {780, -35, 1010}, {840, 115, 1030});
}

// Walls run counter-clockwise, their fronts inside.
void add_outer_wall(Exporter& exporter, const Frame& plan, int length, const std::vector<Opening>& windows) {
  exporter.begin("outer_wall");
  exporter.paint("plaster");
  exporter.wall(plan, length, kOuter, kClear, windows);
  for (const Opening& opening : windows) {
    add_window_frame(exporter, plan, opening);
    add_radiator(exporter, turned(moved(plan, {opening.high.u - 60, -40}), 2), 5);
    add_curtain(exporter, moved(plan, {opening.low.u - 480, -160}), 4, 2500);
  }
}

void add_inner_wall(Exporter& exporter, const Frame& plan, int length, const std::vector<Opening>& doors) {
  exporter.begin("inner_wall");
  exporter.paint("plaster");
  exporter.wall(plan, length, kInner, kClear, doors);
  for (const Opening& opening : doors) add_door(exporter, plan, opening, exporter.random().one_in(2));
}

// Plans of walls whose fronts look north, west, south and east.
Frame wall_at(int u, int v, int floor, int quarter) { return turned(plan_at({u, v, floor}), quarter); }

void add_walls(Exporter& exporter, int floor) {
  const int inside = kWidth - 2 * kOuter;
  add_outer_wall(exporter, wall_at(kLength, kOuter, floor, 2), kLength, {window(1500), window(4000), window(12000)});
  add_outer_wall(exporter, wall_at(kLength - kOuter, kWidth - kOuter, floor, 3), inside, {window(7000)});
  add_outer_wall(exporter, wall_at(0, kWidth - kOuter, floor, 0), kLength, {window(900), window(3600), window(12600)});
  add_outer_wall(exporter, wall_at(kOuter, kOuter, floor, 1), inside, {window(1600), window(7300)});
  add_inner_wall(exporter, wall_at(kWest + kInner, kOuter, floor, 1), inside, {door(1200), door(8200)});
  add_inner_wall(exporter, wall_at(kEast + kInner, kOuter, floor, 1), inside, {door(4300), door(8600)});
  add_inner_wall(exporter, wall_at(kOuter, 5500, floor, 0), kWest - kOuter, {door(4400)});
  add_inner_wall(exporter, wall_at(kEast + kInner, 6200, floor, 0), kLength - kOuter - kEast - kInner, {door(3600)});
}

void add_shell(Exporter& exporter) {
  const Frame plan = plan_at({0, 0, 0});
  exporter.begin("ground");
  exporter.paint("lawn");
  exporter.slab(plan_at({-6000, -6000, -800}), {kLength + 12000, kWidth + 12000}, {{{6000, 6000}, {22000, 17000}}}, -50,
                0);
  exporter.begin("slab");
  exporter.paint("floorboards");
  exporter.slab(plan, {kLength, kWidth}, {}, -900, 0);
  exporter.begin("slab");
  exporter.slab(plan, {kLength, kWidth}, {kStairs}, kClear, kStorey);
  exporter.begin("slab");
  exporter.paint("plaster");
  exporter.slab(plan, {kLength, kWidth}, {}, kStorey + kClear, 2 * kStorey);
  exporter.begin("roof");  // facades: two slopes and two gables
  exporter.paint("roof_tiles");
  const int eaves = 2 * kStorey, ridge = eaves + 3300, middle = kWidth / 2;
  Modeller& modeller = exporter.modeller();
  modeller.face({{-300, 0, eaves}, {kLength + 300, 0, eaves}, {kLength + 300, middle, ridge}, {-300, middle, ridge}});
  modeller.face(
      {{kLength + 300, kWidth, eaves}, {-300, kWidth, eaves}, {-300, middle, ridge}, {kLength + 300, middle, ridge}});
  exporter.paint("brick");
  modeller.face({{0, kWidth, eaves}, {0, 0, eaves}, {0, middle, ridge}});
  modeller.face({{kLength, 0, eaves}, {kLength, kWidth, eaves}, {kLength, middle, ridge}});
}

void add_stairs(Exporter& exporter) {
  constexpr int kRise = kStorey / kSteps + 1, kGoing = 290;
  const Frame frame = moved(plan_at({0, 0, 0}), {kStairs.low.u + 30, kStairs.low.v});
  for (int step = 0; step < kSteps - 1; ++step) {
    exporter.begin("step");
    exporter.paint("oak");
    exporter.box(frame, {0, step * kGoing - 20, step * kRise + kRise - 50},
                 {1000, (step + 1) * kGoing, (step + 1) * kRise});
    exporter.paint("white_lacquer");
    for (const int side : {25, 945}) {
      exporter.post(frame, {side, step * kGoing + 120}, 30, (step + 1) * kRise - 10, (step + 1) * kRise + 880);
    }
  }
  exporter.begin("landing_rail");
  const auto& [low, high] = kStairs;
  for (int v = low.v + 100; v < high.v - 300; v += 180)
    exporter.post(plan_at({low.u - 80, v, kStorey}), {0, 0}, 30, -kSunk, 900);
  exporter.paint("oak");
  exporter.box(plan_at({low.u - 95, low.v, kStorey}), {0, 0, 895}, {60, high.v - low.v, 935});
}

void furnish_living_room(Exporter& exporter) {
  add_rug(exporter, plan_at({1500, 1500, 0}), {3000, 2200}, "wool");
  add_sofa(exporter, plan_at({2000, 4500, 0}), 3);
  add_sofa(exporter, turned(plan_at({1300, 1500, 0}), 1), 2);
  add_table(exporter, plan_at({2200, 2100, 0}), {1200, 700}, 420);
  exporter.begin("magazines");
  exporter.paint("sheet_paper");
  exporter.sheet(plan_at({2300, 2200, 0}), {0, 0}, {210, 297}, 420);
  exporter.sheet(plan_at({2440, 2300, 0}), {0, 0}, {210, 297}, 420);
  add_bookshelf(exporter, turned(plan_at({5690, 4300, 0}), 3), 900, 5);
  add_drawers(exporter, turned(plan_at({3900, 700, 0}), 2), {1800, 350}, 520, 3);
  add_floor_lamp(exporter, plan_at({5300, 4700, 0}));
  add_plant(exporter, plan_at({450, 450, 0}));
  add_picture(exporter, turned(plan_at({kWest, 3300, 0}), 3), 900, 1300, 650);
  add_ceiling_lamp(exporter, plan_at({3000, 2900, 0}), kClear, 240);
}

void furnish_piano_room(Exporter& exporter) {
  add_rug(exporter, plan_at({1000, 6600, 0}), {3600, 2800}, "blue_cloth");
  add_piano(exporter, turned(plan_at({4400, 9300, 0}), 2));
  add_stool(exporter, plan_at({3500, 9500, 0}));
  add_sofa(exporter, turned(plan_at({1300, 7200, 0}), 1), 1);
  add_bookshelf(exporter, turned(plan_at({5700, 7700, 0}), 3), 1200, 5);
  add_floor_lamp(exporter, plan_at({700, 10000, 0}));
  add_plant(exporter, plan_at({500, 5900, 0}));
  add_picture(exporter, turned(plan_at({3300, 5500 + kInner, 0}), 2), 1200, 1200, 800);
  add_ceiling_lamp(exporter, plan_at({2800, 8100, 0}), kClear, 240);
}

void furnish_hall(Exporter& exporter, int floor) {
  add_rug(exporter, plan_at({6700, 6600, floor}), {1600, 3200}, "wool");
  add_drawers(exporter, turned(plan_at({6510, 6800, floor}), 1), {1400, 380}, 850, 4);
  add_plant(exporter, plan_at({9900, 10100, floor}));
  add_picture(exporter, turned(plan_at({kWest + kInner, 5600, floor}), 1), 700, 1400, 900);
  add_picture(exporter, turned(plan_at({kEast, 7600, floor}), 3), 700, 1400, 900);
  add_ceiling_lamp(exporter, plan_at({7400, 3200, floor}), kClear, 200);
  add_ceiling_lamp(exporter, plan_at({8300, 8600, floor}), kClear, 200);
}

// An L of base units whose worktop is two rectangles that meet in a T, units on the wall above, and an island.
void furnish_kitchen(Exporter& exporter) {
  const Frame south = plan_at({15700, 300, 0});
  exporter.begin("worktop");
  exporter.paint("walnut");
  exporter.box(moved(south, {-4800, 0}), {0, 0, 880}, {4800, 620, 920});
  exporter.box(moved(south, {-620, 620}), {0, 0, 880}, {620, 2400, 920});
  for (int unit = 0; unit < 8; ++unit) {
    add_drawers(exporter, turned(plan_at({15690 - unit * 600, 880, 0}), 2), {590, 560}, 885, unit % 2 + 1);
  }
  add_drawers(exporter, turned(plan_at({15130, 3100, 0}), 3), {1000, 560}, 885, 3);
  add_drawers(exporter, turned(plan_at({15130, 2000, 0}), 3), {1000, 560}, 885, 3);
  exporter.begin("oven");
  exporter.paint("steel");
  exporter.box(plan_at({13000, 300, 0}), {0, 0, 900}, {600, 560, 935});
  for (const int ring : {150, 430}) {
    exporter.paint("black_lacquer");
    exporter.column(plan_at({13000, 300, 0}), {ring, 160}, 90, 930, 940);
    exporter.column(plan_at({13000, 300, 0}), {ring, 400}, 110, 930, 940);
  }
  exporter.begin("hood");
  exporter.paint("steel");
  exporter.box(plan_at({13000, 300, 0}), {0, 0, 1700}, {600, 450, 1800});
  exporter.box(plan_at({13000, 300, 0}), {150, 0, 1790}, {450, 300, kClear + 4});
  add_table(exporter, plan_at({11700, 2900, 0}), {1900, 900}, 900);
  for (int i = 0; i < 4; ++i) add_stool(exporter, plan_at({11750 + i * 480, 3900, 0}));
  add_ceiling_lamp(exporter, plan_at({13100, 3200, 0}), kClear, 240);
}

void set_place(Exporter& exporter, const Frame& frame, int top) {
  exporter.begin("plate");
  exporter.paint("ivory");
  exporter.column(frame, {0, 0}, 130, top, top + 18);
  exporter.begin("cutlery");
  exporter.paint("steel");
  exporter.sheet(frame, {-185, -100}, {-165, 100}, top);
  exporter.sheet(frame, {165, -100}, {185, 100}, top);
}

void furnish_dining_room(Exporter& exporter) {
  const Frame table = plan_at({11900, 7600, 0});
  add_rug(exporter, moved(table, {-500, -700}), {3300, 2500}, "wool");
  add_table(exporter, table, {2300, 1100}, 750);
  for (int i = 0; i < 3; ++i) {
    add_chair(exporter, turned(moved(table, {750 + 700 * i, 60}), 2));
    add_chair(exporter, moved(table, {300 + 700 * i, 1040}));
    set_place(exporter, moved(table, {520 + 700 * i, 230}), 750);
    set_place(exporter, moved(table, {520 + 700 * i, 870}), 750);
  }
  add_chair(exporter, turned(moved(table, {60, 300}), 1));
  add_chair(exporter, turned(moved(table, {2240, 780}), 3));
  add_drawers(exporter, turned(plan_at({15240, 9800, 0}), 3), {1800, 450}, 850, 3);
  add_drawers(exporter, plan_at({11200, 10270, 0}), {1600, 420}, 850, 3);
  add_picture(exporter, turned(plan_at({12400, 6200 + kInner, 0}), 2), 1000, 1300, 700);
  add_chandelier(exporter, plan_at({13050, 8150, 0}), kClear, 8);
}

void furnish_bedroom(Exporter& exporter, Planar corner, int wardrobe) {
  const Frame room = plan_at({corner.u, corner.v, kStorey});
  add_rug(exporter, moved(room, {1200, 900}), {2600, 2000}, "wool");
  add_bed(exporter, moved(room, {1500, 2600}));
  for (const int side : {850, 3350}) {
    add_drawers(exporter, moved(room, {side, 4100}), {500, 420}, 480, 2);
    add_table_lamp(exporter, moved(room, {side + 150, 4200}), 480);
  }
  add_wardrobe(exporter, turned(moved(room, {5080, wardrobe}), 3), 4);
  add_desk(exporter, turned(moved(room, {820, 200}), 1));
  add_chair(exporter, turned(moved(room, {900, 1200}), 3));
  add_table_lamp(exporter, moved(room, {100, 300}), 740);
  add_ceiling_lamp(exporter, moved(room, {2800, 1800}), kClear, 220);
}

void furnish_bathroom(Exporter& exporter) {
  const Frame room = plan_at({kEast + kInner, kOuter, kStorey});
  add_rug(exporter, moved(room, {1200, 1500}), {1500, 900}, "linen");
  exporter.begin("tub");  // open at the top: walls with a rim, the inside as facades
  exporter.paint("white_lacquer");
  const Frame tub = moved(room, {3100, 300});
  sides(exporter.modeller(), tub, rectangle({0, 0}, {1800, 800}), -kSunk, 560);
  panel(exporter.modeller(), tub, rectangle({0, 0}, {1800, 800}), 560, Facing::Along,
        {tub.ring(rectangle({70, 70}, {1730, 730}), 560)});
  sides(exporter.modeller(), tub, reversed(rectangle({70, 70}, {1730, 730})), 120, 560);
  exporter.sheet(tub, {70, 70}, {1730, 730}, 120);
  add_drawers(exporter, turned(moved(room, {500, 2200}), 1), {1200, 480}, 820, 2);
  exporter.begin("basin");
  exporter.paint("ivory");
  exporter.column(moved(room, {270, 2800}), {0, 0}, 190, 815, 960);
  add_picture(exporter, turned(moved(room, {0, 2300}), 1), 1000, 1100, 900);
  add_stool(exporter, moved(room, {2300, 4600}));
  add_ceiling_lamp(exporter, moved(room, {2500, 2800}), kClear, 220);
}

void furnish_study(Exporter& exporter) {
  const Frame room = plan_at({kEast + kInner, 6200 + kInner, kStorey});
  add_desk(exporter, moved(room, {700, 2600}));
  add_desk(exporter, moved(room, {2600, 2600}));
  add_chair(exporter, turned(moved(room, {1700, 2560}), 2));
  add_chair(exporter, turned(moved(room, {3600, 2560}), 2));
  add_table_lamp(exporter, moved(room, {800, 3100}), 740);
  add_bookshelf(exporter, turned(moved(room, {1300, 310}), 2), 1200, 5);
  exporter.begin("screen");
  exporter.paint("black_lacquer");
  exporter.box(moved(room, {3100, 3150}), {0, 0, 840}, {560, 30, 1180});
  exporter.box(moved(room, {3100, 3150}), {255, 20, 735}, {305, 60, 900});
  exporter.begin("keyboard");
  for (int key = 0; key < 20; ++key) {
    exporter.box(moved(room, {3160, 2800}), {key % 10 * 26, key / 10 * 26, 748},
                 {key % 10 * 26 + 20, key / 10 * 26 + 20, 756});
  }
  add_ceiling_lamp(exporter, moved(room, {2500, 1900}), kClear, 220);
}

}  // namespace

scene::Scene house() {
  Exporter exporter("house.obj", 1991);
  define_materials(exporter.modeller());
  add_shell(exporter);
  add_walls(exporter, 0);
  add_walls(exporter, kStorey);
  add_stairs(exporter);
  furnish_living_room(exporter);
  furnish_piano_room(exporter);
  furnish_hall(exporter, 0);
  furnish_kitchen(exporter);
  furnish_dining_room(exporter);
  furnish_bedroom(exporter, {kOuter, kOuter + 200}, 4400);
  furnish_bedroom(exporter, {kOuter, 5500 + kInner + 100}, 2600);
  furnish_hall(exporter, kStorey);
  furnish_bathroom(exporter);
  furnish_study(exporter);
  return exporter.take();
}

}  // namespace rad::corpus
