// Which pieces of a welded soup need repair.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "repair/soup.h"
#include "repair/triangle_lint.h"

namespace rad::repair {

enum class PieceState : std::uint8_t {
  Sound,    ///< nothing is wrong with it, nor with a piece that has a point in common with it
  Beside,   ///< it has a point in common with one at fault
  AtFault,  ///< the lint of the triangles found something about it, or its rings cross
};

/// Puts pieces at fault that lie on each other looking opposite ways (TriangleLint::opposite_overlaps).
void add_opposite_overlaps(const Soup& soup, const Triangulation& triangulation, const TriangleLint& lint,
                           std::vector<PieceState>& state);

/// Per piece. `triangulation` holds the triangular pieces as they are, `lint` is what was found between them.
std::vector<PieceState> pieces_at_fault(const Soup& soup, const Triangulation& triangulation, const TriangleLint& lint);

/// Per piece, where those `at_fault` are known.
std::vector<PieceState> states_around(const Soup& soup, std::span<const PieceId> at_fault);

/// Whether nothing is wrong with a soup that is not welded yet, though welding it would change it: all points that
/// would be welded (`representative`, weld.h) are more than T from what takes their place. So a result of repair that
/// keeps such points stays as it is.
bool is_fit_unwelded(const Soup& soup, std::span<const std::uint32_t> representative, std::int64_t tolerance);

}  // namespace rad::repair
