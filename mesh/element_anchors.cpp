#include "mesh/element_anchors.h"

#include <initializer_list>

namespace rad::mesh {
namespace {

// Pieces by slots: 0 to 3 are corners, 4 to 7 the middles of the edges from them on. The patterns are for the rotation
// in which the anchored edges come first.
constexpr std::uint32_t kUnused = 8;
using PieceSlots = std::array<std::uint32_t, 4>;

constexpr PieceSlots triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return {a, b, c, kUnused}; }

struct Pattern {
  std::array<PieceSlots, 5> piece;
  std::uint32_t count;
};

constexpr Pattern kTriangleNone{{triangle(0, 1, 2)}, 1};
constexpr Pattern kTriangleOne{{triangle(0, 4, 2), triangle(4, 1, 2)}, 2};
constexpr Pattern kTriangleTwo{{triangle(4, 1, 5), triangle(0, 4, 5), triangle(0, 5, 2)}, 3};
constexpr Pattern kTriangleThree{{triangle(0, 4, 6), triangle(4, 1, 5), triangle(6, 5, 2), triangle(4, 5, 6)}, 4};
constexpr Pattern kQuadNone{{PieceSlots{0, 1, 2, 3}}, 1};
constexpr Pattern kQuadOne{{triangle(0, 4, 3), triangle(4, 2, 3), triangle(4, 1, 2)}, 3};
constexpr Pattern kQuadAdjacent{{triangle(4, 1, 5), triangle(0, 4, 3), triangle(4, 5, 3), triangle(5, 2, 3)}, 4};
constexpr Pattern kQuadOpposite{{PieceSlots{0, 4, 6, 3}, PieceSlots{4, 1, 2, 6}}, 2};
constexpr Pattern kQuadThree{{PieceSlots{0, 4, 6, 3}, triangle(4, 1, 5), triangle(4, 5, 6), triangle(5, 2, 6)}, 4};
constexpr Pattern kQuadFour{
    {triangle(0, 4, 7), triangle(4, 1, 5), triangle(5, 2, 6), triangle(6, 3, 7), PieceSlots{4, 5, 6, 7}}, 5};

struct Turned {
  const Pattern* pattern;
  std::uint32_t first;  ///< the corner that takes slot 0
};

// Masks have bit i where the edge from corner i on has a middle.
Turned triangle_pattern(unsigned mask) {
  constexpr std::array<Turned, 8> kTurned{{{&kTriangleNone, 0},
                                           {&kTriangleOne, 0},
                                           {&kTriangleOne, 1},
                                           {&kTriangleTwo, 0},
                                           {&kTriangleOne, 2},
                                           {&kTriangleTwo, 2},
                                           {&kTriangleTwo, 1},
                                           {&kTriangleThree, 0}}};
  return kTurned[mask];
}

Turned quad_pattern(unsigned mask) {
  constexpr std::array<Turned, 16> kTurned{{{&kQuadNone, 0},
                                            {&kQuadOne, 0},
                                            {&kQuadOne, 1},
                                            {&kQuadAdjacent, 0},
                                            {&kQuadOne, 2},
                                            {&kQuadOpposite, 0},
                                            {&kQuadAdjacent, 1},
                                            {&kQuadThree, 0},
                                            {&kQuadOne, 3},
                                            {&kQuadAdjacent, 3},
                                            {&kQuadOpposite, 1},
                                            {&kQuadThree, 3},
                                            {&kQuadAdjacent, 2},
                                            {&kQuadThree, 2},
                                            {&kQuadThree, 1},
                                            {&kQuadFour, 0}}};
  return kTurned[mask];
}

}  // namespace

AnchoredPieces anchored_pieces(const Corners& corners, const std::array<NodeId, 4>& middle) {
  unsigned mask = 0;
  for (std::uint32_t i = 0; i < corners.count; ++i) mask |= middle[i] == kNoNode ? 0U : 1U << i;
  const Turned turned = corners.count == 3 ? triangle_pattern(mask) : quad_pattern(mask);
  const auto node = [&](std::uint32_t slot) {
    const std::uint32_t place = (slot % 4 + turned.first) % corners.count;
    return slot < 4 ? corners.node[place] : middle[place];
  };
  AnchoredPieces pieces;
  pieces.count = turned.pattern->count;
  for (std::uint32_t p = 0; p < pieces.count; ++p) {
    const PieceSlots& slots = turned.pattern->piece[p];
    pieces.piece[p].count = slots[3] == kUnused ? 3 : 4;
    for (std::uint32_t i = 0; i < pieces.piece[p].count; ++i) pieces.piece[p].node[i] = node(slots[i]);
  }
  return pieces;
}

}  // namespace rad::mesh
