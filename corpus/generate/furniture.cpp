#include "corpus/generate/furniture.h"

#include <algorithm>

namespace rad::corpus {
namespace {

void add_legs(Exporter& exporter, const Frame& frame, Planar size, int inset, int thickness, int top) {
  const int u = size.u - inset - thickness, v = size.v - inset - thickness;
  for (const Planar corner : {Planar{inset, inset}, {u, inset}, {u, v}, {inset, v}}) {
    exporter.post(frame, corner, thickness, -kSunk, top);
  }
}

}  // namespace

void define_furniture_materials(Modeller& modeller) {
  modeller.define_material("oak", {0.52, 0.4, 0.26});
  modeller.define_material("beech", {0.62, 0.5, 0.36});
  modeller.define_material("walnut", {0.3, 0.2, 0.13});
  modeller.define_material("black_lacquer", {0.05, 0.05, 0.055});
  modeller.define_material("ivory", {0.8, 0.78, 0.7});
  modeller.define_material("white_lacquer", {0.8, 0.8, 0.78});
  modeller.define_material("steel", {0.5, 0.51, 0.53});
  modeller.define_material("brass", {0.55, 0.42, 0.2});
  modeller.define_material("sheet_paper", {0.82, 0.82, 0.8});
  modeller.define_material("canvas", {0.32, 0.38, 0.5});
  modeller.define_material("linen", {0.76, 0.74, 0.68});
  modeller.define_material("green_cloth", {0.16, 0.34, 0.22});
  modeller.define_material("red_cloth", {0.5, 0.12, 0.1});
  modeller.define_material("blue_cloth", {0.14, 0.2, 0.45});
  modeller.define_material("leaves", {0.14, 0.32, 0.1});
  modeller.define_material("clay", {0.5, 0.28, 0.18});
  modeller.define_material("lamp_light", {0.8, 0.8, 0.8}, {620, 560, 470});
  modeller.define_material("shade_light", {0.75, 0.7, 0.6}, {120, 100, 75});
}

void add_table(Exporter& exporter, const Frame& frame, Planar size, int height) {
  exporter.begin("table");
  exporter.paint("oak");
  exporter.box(frame, {0, 0, height - 35}, {size.u, size.v, height});
  exporter.box(frame, {60, 60, height - 115}, {size.u - 60, 85, height - 35});
  exporter.box(frame, {60, size.v - 85, height - 115}, {size.u - 60, size.v - 60, height - 35});
  add_legs(exporter, frame, size, 50, 60, height - 30);
}

void add_desk(Exporter& exporter, const Frame& frame) {
  constexpr int kTop = 740;
  add_table(exporter, frame, {1600, 800}, kTop);
  exporter.begin("drawer_unit");
  exporter.paint("white_lacquer");
  exporter.box(frame, {1150, 90, -kSunk}, {1520, 740, 600});
  exporter.begin("papers");
  exporter.paint("sheet_paper");
  exporter.sheet(frame, {240, 130}, {450, 427}, kTop);
  exporter.sheet(frame, {620, 190}, {830, 487}, kTop);
  exporter.sheet(frame, {700, 260}, {910, 557}, kTop);  // over a part of the one before
  exporter.paint("blue_cloth");
  exporter.sheet(frame, {1050, 220}, {1400, 470}, kTop);
}

void add_chair(Exporter& exporter, const Frame& frame) {
  exporter.begin("chair");
  exporter.paint("beech");
  exporter.box(frame, {0, 0, 425}, {450, 450, 455});
  exporter.post(frame, {20, 20}, 40, -kSunk, 430);
  exporter.post(frame, {390, 20}, 40, -kSunk, 430);
  exporter.post(frame, {20, 390}, 40, -kSunk, 930);
  exporter.post(frame, {390, 390}, 40, -kSunk, 930);
  for (const int foot : {560, 690, 820}) exporter.box(frame, {50, 400, foot}, {400, 420, foot + 70});
}

void add_stool(Exporter& exporter, const Frame& frame) {
  exporter.begin("stool");
  exporter.paint("steel");
  add_legs(exporter, frame, {360, 360}, 30, 30, 640);
  exporter.paint("walnut");
  exporter.column(frame, {180, 180}, 180, 635, 670);
}

void add_sofa(Exporter& exporter, const Frame& frame, int seats) {
  constexpr int kSeat = 640, kArm = 180;
  const int width = 2 * kArm + seats * kSeat;
  exporter.begin("sofa");
  exporter.paint("green_cloth");
  exporter.box(frame, {0, 0, 60}, {width, 880, 260});
  exporter.box(frame, {0, 0, 250}, {kArm, 880, 600});
  exporter.box(frame, {width - kArm, 0, 250}, {width, 880, 600});
  exporter.box(frame, {kArm, 660, 255}, {width - kArm, 880, 820});
  exporter.paint("linen");
  for (int seat = 0; seat < seats; ++seat) {
    const int from = kArm + seat * kSeat;
    exporter.box(frame, {from, 0, 260}, {from + kSeat, 670, 430});
    exporter.box(frame, {from + 60, 520, 425}, {from + kSeat - 60, 665, 790});
  }
  exporter.paint("walnut");
  add_legs(exporter, frame, {width, 880}, 60, 60, 70);
}

void add_bed(Exporter& exporter, const Frame& frame) {
  exporter.begin("bed");
  exporter.paint("walnut");
  exporter.box(frame, {0, 0, 180}, {1700, 2060, 300});
  exporter.box(frame, {0, 2040, -kSunk}, {1700, 2100, 1000});
  add_legs(exporter, frame, {1700, 2060}, 40, 80, 190);
  exporter.paint("linen");
  exporter.box(frame, {40, 40, 290}, {1660, 2040, 520});
  exporter.box(frame, {140, 1520, 500}, {790, 1990, 640});
  exporter.box(frame, {910, 1520, 500}, {1560, 1990, 640});
  exporter.paint("blue_cloth");
  exporter.box(frame, {20, 20, 400}, {1680, 1400, 545});
}

void add_wardrobe(Exporter& exporter, const Frame& frame, int doors) {
  constexpr int kDoor = 550;
  exporter.begin("wardrobe");
  exporter.paint("white_lacquer");
  exporter.box(frame, {0, 0, -kSunk}, {doors * kDoor, 600, 2200});
  for (int door = 0; door < doors; ++door) {
    const int from = door * kDoor;
    exporter.paint("beech");
    exporter.box(frame, {from + 10, -22, 90}, {from + kDoor - 10, 5, 2150});
    exporter.paint("brass");
    const int handle = door % 2 == 0 ? from + kDoor - 70 : from + 45;
    exporter.box(frame, {handle, -60, 980}, {handle + 25, -15, 1140});
  }
}

void add_drawers(Exporter& exporter, const Frame& frame, Planar size, int height, int drawers) {
  exporter.begin("drawers");
  exporter.paint("walnut");
  exporter.box(frame, {0, 0, 60}, {size.u, size.v, height});
  add_legs(exporter, frame, size, 20, 50, 70);
  const int clear = (height - 100) / drawers;
  for (int drawer = 0; drawer < drawers; ++drawer) {
    const int foot = 80 + drawer * clear;
    exporter.paint("oak");
    exporter.box(frame, {25, -20, foot}, {size.u - 25, 5, foot + clear - 20});
    exporter.paint("brass");
    exporter.box(frame, {size.u / 2 - 60, -48, foot + clear / 2 - 20}, {size.u / 2 + 60, -15, foot + clear / 2 + 5});
  }
}

namespace {

void add_books(Exporter& exporter, const Frame& frame, int from, int to, int board) {
  constexpr std::array<std::string_view, 5> kCovers{"red_cloth", "blue_cloth", "green_cloth", "linen", "clay"};
  Random& random = exporter.random();
  for (int left = from; left + 78 < to;) {
    if (random.one_in(8)) {
      left += 110;
      continue;
    }
    const int thickness = random.between(38, 78), depth = random.between(160, 215);
    exporter.begin("book");
    exporter.paint(kCovers[random.index(kCovers.size())]);
    exporter.box(frame, {left, 30, board}, {left + thickness, 30 + depth, board + random.between(190, 275)});
    left += thickness;
  }
}

}  // namespace

void add_bookshelf(Exporter& exporter, const Frame& frame, int width, int boards) {
  constexpr int kPitch = 350, kSide = 30, kDepth = 290;
  const int height = boards * kPitch + 90;
  exporter.begin("bookshelf");
  exporter.paint("oak");
  exporter.box(frame, {0, 0, -kSunk}, {kSide, kDepth, height});
  exporter.box(frame, {width - kSide, 0, -kSunk}, {width, kDepth, height});
  exporter.box(frame, {0, 0, height}, {width, kDepth, height + 30});
  panel(exporter.modeller(), moved(upright(frame), {0, 0}, -kDepth), rectangle({kSide, 0}, {width - kSide, height}), 0,
        Facing::Along);
  for (int board = 0; board < boards; ++board) {
    exporter.begin("shelf_board");
    exporter.paint("oak");
    exporter.box(frame, {kSide - 5, 0, 60 + board * kPitch}, {width - kSide + 5, kDepth - 10, 85 + board * kPitch});
  }
  for (int board = 0; board < boards; ++board) add_books(exporter, frame, kSide, width - kSide, 85 + board * kPitch);
}

void add_rug(Exporter& exporter, const Frame& frame, Planar size, std::string_view material) {
  exporter.begin("rug");
  exporter.paint(material);
  exporter.sheet(frame, {0, 0}, size, 0);
}

void add_picture(Exporter& exporter, const Frame& plan, int width, int foot, int height) {
  const Frame front = upright(plan);
  exporter.begin("picture");
  exporter.paint("walnut");
  prism(exporter.modeller(), front, rectangle({0, foot}, {width, foot + height}), -2, 25);
  exporter.paint("canvas");
  exporter.sheet(front, {50, foot + 50}, {width - 50, foot + height - 50}, 25);
}

void add_plant(Exporter& exporter, const Frame& frame) {
  exporter.begin("plant");
  exporter.paint("clay");
  exporter.column(frame, {200, 200}, 150, -kSunk, 320);
  exporter.paint("leaves");
  exporter.post(frame, {190, 190}, 20, 300, 900);
  Random& random = exporter.random();
  for (int leaf = 0; leaf < 14; ++leaf) {
    const Frame turn = turned(moved(frame, {200, 200}), leaf % 4);
    const int foot = 480 + 30 * leaf, reach = random.between(180, 320), drop = random.between(-60, 160);
    const int half = random.between(35, 60);
    exporter.modeller().face(
        {turn.at({4, 0}, foot), turn.at({reach / 2, -half}, foot + 80), turn.at({reach, 0}, foot + drop)});
    exporter.modeller().face(
        {turn.at({4, 0}, foot), turn.at({reach, 0}, foot + drop), turn.at({reach / 2, half}, foot + 80)});
  }
}

void add_curtain(Exporter& exporter, const Frame& frame, int folds, int height) {
  exporter.begin("curtain");
  exporter.paint("linen");
  for (int fold = 0; fold < 2 * folds; ++fold) {
    const Planar a{fold * 60, fold % 2 == 0 ? 0 : 40}, b{(fold + 1) * 60, fold % 2 == 0 ? 40 : 0};
    exporter.modeller().face(side(frame, a, b, 60, height));
  }
}

void add_radiator(Exporter& exporter, const Frame& frame, int ribs) {
  exporter.begin("radiator");
  exporter.paint("white_lacquer");
  for (int rib = 0; rib < ribs; ++rib) exporter.box(frame, {rib * 190, 0, 120}, {rib * 190 + 150, 110, 700});
  exporter.box(frame, {-40, 40, 180}, {ribs * 190 + 10, 80, 220});
  exporter.box(frame, {-40, 40, 600}, {ribs * 190 + 10, 80, 640});
}

}  // namespace rad::corpus
