// The piano and the lamps.
#include <algorithm>

#include "corpus/generate/furniture.h"

namespace rad::corpus {
namespace {

constexpr int kWhiteKeys = 52, kKeyPitch = 24, kKeyWidth = 22, kKeysFrom = 126, kKeyFoot = 700;

// Black keys stand behind the gaps after every white key but the third and the seventh of an octave.
void add_keys(Exporter& exporter, const Frame& frame) {
  exporter.begin("keys");
  exporter.paint("ivory");
  for (int key = 0; key < kWhiteKeys; ++key) {
    const int left = kKeysFrom + key * kKeyPitch;
    exporter.box(frame, {left, 20, kKeyFoot}, {left + kKeyWidth, 165, kKeyFoot + 22});
  }
  exporter.paint("black_lacquer");
  for (int key = 0; key + 1 < kWhiteKeys; ++key) {
    const int place = (key + 5) % 7;
    if (place == 2 || place == 6) continue;
    const int left = kKeysFrom + key * kKeyPitch + 17;
    exporter.box(frame, {left, 72, kKeyFoot + 18}, {left + 13, 165, kKeyFoot + 34});
  }
}

Outline piano_outline() {
  return {{0, 180},     {1500, 180},  {1500, 620}, {1470, 800}, {1390, 960}, {1280, 1100}, {1180, 1240}, {1110, 1390},
          {1070, 1550}, {1000, 1700}, {870, 1820}, {680, 1890}, {430, 1900}, {180, 1840},  {0, 1700}};
}

// The lid as triangles around one corner, as programs without concave faces write it; seen from above only.
void add_lid(Exporter& exporter, const Frame& frame) {
  const Outline outline = piano_outline();
  exporter.begin("lid");
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    if (i + 2 < outline.size() && i % 2 == 1) {
      exporter.modeller().face({frame.at(outline[0], 960), frame.at(outline[i], 960), frame.at(outline[i + 1], 960),
                                frame.at(outline[i + 2], 960)});
      ++i;
    } else {
      exporter.modeller().face({frame.at(outline[0], 960), frame.at(outline[i], 960), frame.at(outline[i + 1], 960)});
    }
  }
}

}  // namespace

void add_piano(Exporter& exporter, const Frame& frame) {
  exporter.begin("grand_piano");
  exporter.paint("black_lacquer");
  Modeller& modeller = exporter.modeller();
  panel(modeller, frame, piano_outline(), 660, Facing::Against);
  sides(modeller, frame, piano_outline(), 660, 960);
  exporter.box(frame, {0, -20, 640}, {1500, 190, 695});
  exporter.box(frame, {0, -20, 640}, {110, 190, 800});
  exporter.box(frame, {1390, -20, 640}, {1500, 190, 800});
  for (const Planar corner : {Planar{60, 220}, {1340, 220}, {500, 1650}}) {
    exporter.post(frame, corner, 90, -kSunk, 670);
  }
  exporter.box(frame, {690, 420, 120}, {810, 450, 670});
  exporter.box(frame, {380, 240, 955}, {1120, 262, 1180});
  add_lid(exporter, frame);
  add_keys(exporter, frame);
  exporter.begin("notes");
  exporter.paint("sheet_paper");
  const Frame rest = moved(upright(frame), {0, 0}, -240);
  exporter.sheet(rest, {540, 970}, {750, 1165}, 0);
  exporter.sheet(rest, {750, 970}, {960, 1165}, 0);
}

void add_ceiling_lamp(Exporter& exporter, const Frame& frame, int ceiling, int radius) {
  exporter.begin("ceiling_lamp");
  exporter.paint("white_lacquer");
  const Outline outline = round_outline({0, 0}, radius);
  sides(exporter.modeller(), frame, outline, ceiling - 70, ceiling + 3);
  panel(exporter.modeller(), frame, outline, ceiling + 3, Facing::Along);
  exporter.paint("lamp_light");
  panel(exporter.modeller(), frame, outline, ceiling - 70, Facing::Against);
}

void add_floor_lamp(Exporter& exporter, const Frame& frame) {
  exporter.begin("floor_lamp");
  exporter.paint("brass");
  exporter.column(frame, {150, 150}, 150, -kSunk, 20);
  exporter.post(frame, {138, 138}, 24, 15, 1500);
  exporter.paint("shade_light");
  exporter.column(frame, {150, 150}, 190, 1420, 1720);
}

void add_table_lamp(Exporter& exporter, const Frame& frame, int foot) {
  exporter.begin("table_lamp");
  exporter.paint("clay");
  exporter.box(frame, {50, 50, foot}, {150, 150, foot + 180});
  exporter.paint("shade_light");
  exporter.box(frame, {0, 0, foot + 175}, {200, 200, foot + 360});
}

void add_chandelier(Exporter& exporter, const Frame& frame, int ceiling, int bulbs) {
  exporter.begin("chandelier");
  exporter.paint("brass");
  exporter.post(frame, {-12, -12}, 24, ceiling - 700, ceiling + 3);
  const int half = bulbs / 2;
  exporter.box(frame, {-150 * half, -18, ceiling - 720}, {150 * half, 18, ceiling - 690});
  for (int bulb = 0; bulb < bulbs; ++bulb) {
    const int u = -150 * half + 75 + 150 * (bulb % (2 * half));
    exporter.paint("brass");
    exporter.post(frame, {u - 10, -10}, 20, ceiling - 760, ceiling - 700);
    exporter.paint("lamp_light");
    exporter.box(frame, {u - 35, -35, ceiling - 850}, {u + 35, 35, ceiling - 755});
  }
}

}  // namespace rad::corpus
