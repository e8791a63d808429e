// A closed room with a light panel in its ceiling and furniture that touches it in imprinted contours only.
#include "corpus/generate/models.h"
#include "corpus/generate/shapes.h"

namespace rad::corpus {
namespace {

constexpr int kLength = 5400, kWidth = 4200, kHeight = 2700;

struct Leg {
  Planar low;
  Planar high;
};

std::vector<Leg> four_legs(Planar size, int inset, int thickness) {
  const int near = inset, far_u = size.u - inset - thickness, far_v = size.v - inset - thickness;
  std::vector<Leg> legs;
  for (const Planar low : {Planar{near, near}, {far_u, near}, {far_u, far_v}, {near, far_v}}) {
    legs.push_back({low, {low.u + thickness, low.v + thickness}});
  }
  return legs;
}

std::vector<Ring> rings_of(const Frame& frame, const std::vector<Leg>& legs, int n) {
  std::vector<Ring> rings;
  for (const Leg& leg : legs) rings.push_back(frame.ring(rectangle(leg.low, leg.high), n));
  return rings;
}

// Legs that grow out of the underside of a slab. Returns the contours of the feet.
std::vector<Ring> add_legs(Modeller& modeller, const Frame& frame, const std::vector<Leg>& legs, int length) {
  for (const Leg& leg : legs) {
    const Outline outline = rectangle(leg.low, leg.high);
    sides(modeller, frame, outline, 0, length);
    panel(modeller, frame, outline, 0, Facing::Against);
  }
  return rings_of(frame, legs, 0);
}

std::vector<Ring> add_table(Modeller& modeller, const Frame& frame) {
  constexpr Planar kSize{1600, 850};
  constexpr int kUnderside = 720, kTop = 755;
  const std::vector<Leg> legs = four_legs(kSize, 45, 60);
  modeller.begin_object("table");
  modeller.paint("oak");
  prism(modeller, frame, rectangle({0, 0}, kSize), kUnderside, kTop, rings_of(frame, legs, kUnderside));
  return add_legs(modeller, frame, legs, kUnderside);
}

std::vector<Ring> add_chair(Modeller& modeller, const Frame& frame, std::string_view name) {
  constexpr Planar kSize{450, 430};
  constexpr int kUnderside = 425, kSeat = 455, kBackTop = 905;
  const std::vector<Leg> legs = four_legs(kSize, 25, 40);
  const Outline back = rectangle({20, 385}, {430, 415});
  modeller.begin_object(name);
  modeller.paint("beech");
  prism(modeller, frame, rectangle({0, 0}, kSize), kUnderside, kSeat, rings_of(frame, legs, kUnderside),
        {frame.ring(back, kSeat)});
  sides(modeller, frame, back, kSeat, kBackTop);
  panel(modeller, frame, back, kBackTop, Facing::Along);
  return add_legs(modeller, frame, legs, kUnderside);
}

struct Shelf {
  static constexpr int kWidth = 900, kDepth = 300, kHeight = 1800;
  static constexpr int kBoards = 4, kPitch = 430, kFirst = 60, kClear = 390, kRecess = 270;
  Millimetres corner;  ///< of the front, left, on the floor

  [[nodiscard]] static int board(int i) { return kFirst + kPitch * i; }
  [[nodiscard]] static Outline opening(int i) { return rectangle({30, board(i)}, {kWidth - 30, board(i) + kClear}); }
};

struct Book {
  int left, thickness, depth, height;
};
constexpr std::array<Book, 3> kBooks{{{120, 35, 180, 240}, {180, 52, 205, 285}, {262, 28, 170, 215}}};

Outline book_outline(const Book& book, int board) {
  const int left = book.left + 110 * board;
  return rectangle({left, 40}, {left + book.thickness, 40 + book.depth});
}

// One recess in the front of the shelf. The books stand in contours of its lower side.
void add_recess(Modeller& modeller, const Shelf& shelf, int board) {
  const Frame front = facing_south(shelf.corner), plan = plan_at(shelf.corner);
  const Outline opening = Shelf::opening(board);
  std::vector<Ring> books;
  for (const Book& book : kBooks) books.push_back(plan.ring(book_outline(book, board), Shelf::board(board)));
  modeller.face_with_contacts(side(front, opening[1], opening[0], -Shelf::kRecess, 0), books);
  for (std::size_t i = 1; i < 4; ++i) {
    modeller.face(side(front, opening[(i + 1) % 4], opening[i], -Shelf::kRecess, 0));
  }
  panel(modeller, front, opening, -Shelf::kRecess, Facing::Along);
}

void add_books(Modeller& modeller, const Shelf& shelf) {
  constexpr std::array<std::string_view, 3> kCovers{"red_cloth", "blue_cloth", "green_cloth"};
  for (int board = 0; board < Shelf::kBoards; ++board) {
    for (std::size_t i = 0; i < kBooks.size(); ++i) {
      modeller.begin_object("book_" + std::to_string(board + 1) + "_" + std::to_string(i + 1));
      modeller.paint(kCovers[(i + static_cast<std::size_t>(board)) % kCovers.size()]);
      prism(modeller, plan_at(shelf.corner), book_outline(kBooks[i], board), Shelf::board(board),
            Shelf::board(board) + kBooks[i].height);
    }
  }
}

Ring add_bookshelf(Modeller& modeller, const Shelf& shelf) {
  const Frame plan = plan_at(shelf.corner), front = facing_south(shelf.corner);
  const Outline outline = rectangle({0, 0}, {Shelf::kWidth, Shelf::kDepth});
  modeller.begin_object("bookshelf");
  modeller.paint("oak");
  panel(modeller, plan, outline, 0, Facing::Against);
  panel(modeller, plan, outline, Shelf::kHeight, Facing::Along);
  for (std::size_t i = 1; i < 4; ++i) {
    modeller.face(side(plan, outline[i], outline[(i + 1) % 4], 0, Shelf::kHeight));
  }
  std::vector<Ring> openings;
  for (int board = 0; board < Shelf::kBoards; ++board) openings.push_back(front.ring(Shelf::opening(board), 0));
  panel(modeller, front, rectangle({0, 0}, {Shelf::kWidth, Shelf::kHeight}), 0, Facing::Along, openings);
  for (int board = 0; board < Shelf::kBoards; ++board) add_recess(modeller, shelf, board);
  add_books(modeller, shelf);
  return plan.ring(outline, 0);
}

Ring add_rug(Modeller& modeller) {
  const Frame frame = plan_at({350, 420, 0});
  const Outline outline = rectangle({0, 0}, {1450, 980});
  modeller.begin_object("rug");
  modeller.paint("wool");
  prism(modeller, frame, outline, 0, 12);
  return frame.ring(outline, 0);
}

Ring add_picture(Modeller& modeller) {
  const Frame frame = facing_south({0, kWidth, 0});
  const Outline outline = rectangle({3005, 1290}, {3890, 1985});
  modeller.begin_object("picture");
  modeller.paint("canvas");
  prism(modeller, frame, outline, 0, 22);
  return frame.ring(outline, 0);
}

void add_lantern(Modeller& modeller) {
  modeller.begin_object("lantern");
  modeller.paint("paper");
  prism(modeller, plan_at({1120, 2530, 0}), round_outline({0, 0}, 165), 1730, 2145);
}

void add_room(Modeller& modeller, const std::vector<Ring>& feet, const Ring& picture) {
  const Frame plan = plan_at({0, 0, 0});
  const Outline outline = rectangle({0, 0}, {kLength, kWidth});
  modeller.begin_object("room");
  modeller.paint("floorboards");
  panel_with_contacts(modeller, plan, outline, 0, Facing::Along, feet);
  modeller.paint("plaster");
  for (std::size_t i = 0; i < 4; ++i) {
    const Ring wall = side(plan, outline[(i + 1) % 4], outline[i], 0, kHeight);
    modeller.face_with_contacts(wall, i == 2 ? std::vector<Ring>{picture} : std::vector<Ring>{});
  }
  const Outline light = rectangle({2150, 1500}, {3350, 2100});
  panel(modeller, plan, outline, kHeight, Facing::Against, {plan.ring(light, kHeight)});
  modeller.begin_object("light_panel");
  modeller.paint("light");
  panel(modeller, plan, light, kHeight, Facing::Against);
}

void define_materials(Modeller& modeller) {
  modeller.define_material("floorboards", {0.46, 0.34, 0.23});
  modeller.define_material("plaster", {0.78, 0.77, 0.74});
  modeller.define_material("light", {0.8, 0.8, 0.8}, {260, 250, 235});
  modeller.define_material("oak", {0.52, 0.4, 0.26});
  modeller.define_material("beech", {0.6, 0.48, 0.34});
  modeller.define_material("wool", {0.44, 0.16, 0.15});
  modeller.define_material("canvas", {0.35, 0.4, 0.5});
  modeller.define_material("paper", {0.72, 0.69, 0.6}, {45, 40, 30});
  modeller.define_material("red_cloth", {0.5, 0.1, 0.1});
  modeller.define_material("blue_cloth", {0.12, 0.18, 0.45});
  modeller.define_material("green_cloth", {0.1, 0.35, 0.16});
}

}  // namespace

scene::Scene furnished_room() {
  Modeller modeller("furnished_room.obj");
  define_materials(modeller);
  std::vector<Ring> feet = add_table(modeller, plan_at({2610, 1345, 0}));
  const auto stand = [&feet](const std::vector<Ring>& contours) {
    feet.insert(feet.end(), contours.begin(), contours.end());
  };
  stand(add_chair(modeller, half_turned(plan_at({3385, 1130, 0})), "chair_1"));
  stand(add_chair(modeller, half_turned(turned_plan_at({4640, 3000, 0})), "chair_2"));
  stand({add_bookshelf(modeller, {{690, 3850, 0}}), add_rug(modeller)});
  const Ring picture = add_picture(modeller);
  add_lantern(modeller);
  add_room(modeller, feet, picture);
  return modeller.take();
}

}  // namespace rad::corpus
