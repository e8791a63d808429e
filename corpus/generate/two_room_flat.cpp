// Two rooms joined by a door opening, in walls with thickness: outer shell, rooms, opening and window are one surface.
#include "corpus/generate/models.h"
#include "corpus/generate/shapes.h"

namespace rad::corpus {
namespace {

constexpr int kEast = 7600, kNorth = 4600, kBottom = -200, kTop = 2900, kCeiling = 2700;
constexpr int kLowY = 250, kHighY = 4350;    // inside of the walls to the south and north
constexpr int kWest1 = 250, kEast1 = 4000;   // room 1
constexpr int kWest2 = 4120, kEast2 = 7350;  // room 2
constexpr int kDoorLow = 1500, kDoorHigh = 2400, kDoorTop = 2050;

const Frame kPlan = plan_at({0, 0, 0});
const Frame kAlongX = facing_east({0, 0, 0});
const Outline kWindow = rectangle({1200, 900}, {3000, 2200});
const Outline kLamp = rectangle({1800, 1950}, {2400, 2550});
const Outline kVase = round_outline({6480, 3560}, 150);

void define_materials(Modeller& modeller) {
  modeller.define_material("render", {0.55, 0.53, 0.5});
  modeller.define_material("plaster", {0.8, 0.79, 0.76});
  modeller.define_material("screed", {0.4, 0.39, 0.37});
  modeller.define_material("door_paint", {0.7, 0.71, 0.68});
  modeller.define_material("ceramic", {0.3, 0.45, 0.5});
  modeller.define_material("diffuser", {0.85, 0.85, 0.85}, {340, 325, 300});
}

void add_outer_shell(Modeller& modeller) {
  modeller.paint("render");
  const Outline outline = rectangle({0, 0}, {kEast, kNorth});
  panel(modeller, kPlan, outline, kBottom, Facing::Against);
  panel(modeller, kPlan, outline, kTop, Facing::Along);
  for (std::size_t i = 0; i < 3; ++i) modeller.face(side(kPlan, outline[i], outline[i + 1], kBottom, kTop));
  panel(modeller, kAlongX, rectangle({0, kBottom}, {kNorth, kTop}), 0, Facing::Against, {kAlongX.ring(kWindow, 0)});
}

void add_floor(Modeller& modeller) {
  modeller.paint("screed");
  const Outline floor{{kWest1, kLowY},     {kEast1, kLowY},     {kEast1, kDoorLow}, {kWest2, kDoorLow},
                      {kWest2, kLowY},     {kEast2, kLowY},     {kEast2, kHighY},   {kWest2, kHighY},
                      {kWest2, kDoorHigh}, {kEast1, kDoorHigh}, {kEast1, kHighY},   {kWest1, kHighY}};
  panel_with_contacts(modeller, kPlan, floor, 0, Facing::Along, {kPlan.ring(kVase, 0)});
}

// The wall between the rooms as one of them sees it: a notch where the door opening is.
Outline partition() {
  return {{kLowY, 0},     {kDoorLow, 0}, {kDoorLow, kDoorTop}, {kDoorHigh, kDoorTop},
          {kDoorHigh, 0}, {kHighY, 0},   {kHighY, kCeiling},   {kLowY, kCeiling}};
}

void add_rooms(Modeller& modeller) {
  modeller.paint("plaster");
  const Outline plain = rectangle({kLowY, 0}, {kHighY, kCeiling});
  panel(modeller, kAlongX, plain, kWest1, Facing::Along, {kAlongX.ring(kWindow, kWest1)});
  panel(modeller, kAlongX, partition(), kEast1, Facing::Against);
  panel(modeller, kAlongX, partition(), kWest2, Facing::Along);
  panel(modeller, kAlongX, plain, kEast2, Facing::Against);
  for (const auto& [west, east] : {std::pair{kWest1, kEast1}, {kWest2, kEast2}}) {
    modeller.face(side(kPlan, {east, kLowY}, {west, kLowY}, 0, kCeiling));
    modeller.face(side(kPlan, {west, kHighY}, {east, kHighY}, 0, kCeiling));
  }
  panel_with_contacts(modeller, kPlan, rectangle({kWest1, kLowY}, {kEast1, kHighY}), kCeiling, Facing::Against,
                      {kPlan.ring(kLamp, kCeiling)});
  panel(modeller, kPlan, rectangle({kWest2, kLowY}, {kEast2, kHighY}), kCeiling, Facing::Against);
}

void add_openings(Modeller& modeller) {
  sides(modeller, kAlongX, reversed(kWindow), 0, kWest1);
  const Outline door = rectangle({kDoorLow, 0}, {kDoorHigh, kDoorTop});
  for (std::size_t i = 1; i < 4; ++i) {
    modeller.face(side(kAlongX, door[(i + 1) % 4], door[i], kEast1, kWest2));
  }
}

void add_contents(Modeller& modeller) {
  modeller.begin_object("lamp");
  modeller.paint("diffuser");
  prism(modeller, kPlan, kLamp, kCeiling - 85, kCeiling);
  modeller.begin_object("door_leaf");
  modeller.paint("door_paint");
  prism(modeller, turned_plan_at({kWest2 + 50, kDoorLow + 20, 0}), rectangle({0, 0}, {860, 40}), 5, 2035);
  modeller.begin_object("vase");
  modeller.paint("ceramic");
  prism(modeller, kPlan, kVase, 0, 480);
}

}  // namespace

scene::Scene two_room_flat() {
  Modeller modeller("two_room_flat.obj");
  define_materials(modeller);
  modeller.begin_object("flat");
  add_outer_shell(modeller);
  add_floor(modeller);
  add_rooms(modeller);
  add_openings(modeller);
  add_contents(modeller);
  return modeller.take();
}

}  // namespace rad::corpus
