// Baum et al. 1991, Color Plates 1 and 2: the ground with a hole, the box through the ground, the lamp post.
#include "corpus/generate/models.h"
#include "corpus/generate/shapes.h"

namespace rad::corpus {
namespace {

constexpr Planar kBoxLow{4200, 1500}, kBoxHigh{5500, 3100};
constexpr int kBoxBottom = -300, kBoxTop = 900;
constexpr Planar kPostCentre{2400, 1750};
constexpr int kPostRadius = 65, kPostBottom = -500, kPostTop = 3200;
constexpr Planar kLampLow{2150, 1500}, kLampHigh{2650, 2000};
constexpr int kLampTop = 3500;
constexpr Planar kPitLow{1200, 4200}, kPitHigh{3100, 5600};

const Frame kPlan = plan_at({0, 0, 0});

void define_materials(Modeller& modeller) {
  modeller.define_material("grass", {0.12, 0.42, 0.14});
  modeller.define_material("crate", {0.55, 0.36, 0.2});
  modeller.define_material("iron", {0.28, 0.28, 0.3});
  modeller.define_material("lamp_glass", {0.8, 0.8, 0.78}, {420, 395, 330});
}

Outline box_outline() { return rectangle(kBoxLow, kBoxHigh); }
Outline post_outline() { return round_outline(kPostCentre, kPostRadius); }
Outline lamp_outline() { return rectangle(kLampLow, kLampHigh); }

void add_lamp_shell(Modeller& modeller) {
  modeller.paint("lamp_glass");
  sides(modeller, kPlan, lamp_outline(), kPostTop, kLampTop);
  modeller.paint("iron");
  panel(modeller, kPlan, lamp_outline(), kLampTop, Facing::Along);
}

// A solid that the plane z = 0 cuts in two: sides below and above the contour, caps at both ends.
void add_cut_solid(Modeller& modeller, const Outline& outline, int low, int high) {
  panel(modeller, kPlan, outline, low, Facing::Against);
  sides(modeller, kPlan, outline, low, 0);
  sides(modeller, kPlan, outline, 0, high);
  panel(modeller, kPlan, outline, high, Facing::Along);
}

}  // namespace

scene::Scene lamp_post() {
  Modeller modeller("lamp_post.obj");
  define_materials(modeller);
  modeller.begin_object("ground");
  modeller.paint("grass");
  for (const auto& [low, high] : std::vector<std::pair<Planar, Planar>>{{{0, 0}, {4700, 2600}},
                                                                        {{4700, 0}, {8000, 2600}},
                                                                        {{0, 2600}, {1200, 7500}},
                                                                        {{1200, 2600}, {3100, 4200}},
                                                                        {{1200, 5600}, {3100, 7500}},
                                                                        {{3100, 2600}, {5600, 5000}},
                                                                        {{5600, 2600}, {8000, 5000}},
                                                                        {{3100, 5000}, {5000, 7500}}}) {
    panel(modeller, kPlan, rectangle(low, high), 0, Facing::Along);
  }
  modeller.begin_object("box");
  modeller.paint("crate");
  prism(modeller, kPlan, box_outline(), kBoxBottom, kBoxTop);
  modeller.begin_object("post");
  modeller.paint("iron");
  prism(modeller, kPlan, post_outline(), kPostBottom, kPostTop);
  modeller.begin_object("lamp");
  add_lamp_shell(modeller);
  modeller.paint("lamp_glass");
  panel(modeller, kPlan, lamp_outline(), kPostTop, Facing::Against);
  return modeller.take();
}

scene::Scene lamp_post_repaired() {
  Modeller modeller("lamp_post_repaired.obj");
  define_materials(modeller);
  modeller.begin_object("ground");
  modeller.paint("grass");
  const Outline ground{{0, 0}, {8000, 0}, {8000, 5000}, {5000, 5000}, {5000, 7500}, {0, 7500}};
  panel_with_contacts(modeller, kPlan, ground, 0, Facing::Along,
                      {kPlan.ring(box_outline(), 0), kPlan.ring(post_outline(), 0)},
                      {kPlan.ring(rectangle(kPitLow, kPitHigh), 0)});
  modeller.begin_object("box");
  modeller.paint("crate");
  add_cut_solid(modeller, box_outline(), kBoxBottom, kBoxTop);
  modeller.begin_object("post");
  modeller.paint("iron");
  add_cut_solid(modeller, post_outline(), kPostBottom, kPostTop);
  modeller.begin_object("lamp");
  add_lamp_shell(modeller);
  modeller.paint("lamp_glass");
  panel_with_contacts(modeller, kPlan, lamp_outline(), kPostTop, Facing::Against,
                      {kPlan.ring(post_outline(), kPostTop)});
  return modeller.take();
}

}  // namespace rad::corpus
