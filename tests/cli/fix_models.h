// Models for the tests of radfix, small enough to be solved within a test.
#pragma once

#include <string>

namespace rad::cli {

/// A ground, a lamp above it that looks down, and a box. The box stands on the ground, whose outline
/// the ground does not have (RL211), and one face of the box is turned inward, on line 30 (RL110).
inline const std::string kLitScene =
    "mtllib lit.mtl\n"
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n"
    "v 1 1 3\nv 1 2 3\nv 2 2 3\nv 2 1 3\n"
    "v 2 2 0\nv 3 2 0\nv 3 3 0\nv 2 3 0\nv 2 2 1\nv 3 2 1\nv 3 3 1\nv 2 3 1\n"
    "usemtl white\no ground\nf 1 2 3 4\n"
    "usemtl lamp\no lamp\nf 5 6 7 8\n"
    "usemtl white\no box\n"
    "f 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 9 12 16 13\nf 12 11 10 9\n";

inline const std::string kLitMaterials = "newmtl white\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0.2 0.2 0.2\nKe 100 90 80\n";

/// The lamp alone, over nothing: fit as it is.
inline const std::string kLamp = "mtllib lit.mtl\nv 1 1 3\nv 1 2 3\nv 2 2 3\nv 2 1 3\nusemtl lamp\nf 1 2 3 4\n";

}  // namespace rad::cli
