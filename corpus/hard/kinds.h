// The kinds of hard scenes, and the scene that a kind and a seed name.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "corpus/hard/sketch.h"

namespace rad::corpus {

struct HardKind {
  std::string_view name;
  void (*draw)(HardSketch& sketch);

  friend std::ostream& operator<<(std::ostream& out, const HardKind& kind) { return out << kind.name; }
};

// The lists that hard_kinds() joins: things that coincide or nearly do, that stand or stick in others, planes at small
// angles, things about as thin as T, faces of hard outlines, much of the same.
std::span<const HardKind> coincident_kinds();
std::span<const HardKind> standing_kinds();
std::span<const HardKind> slanted_kinds();
std::span<const HardKind> thin_kinds();
std::span<const HardKind> outlined_kinds();
std::span<const HardKind> crowded_kinds();

std::span<const HardKind> hard_kinds();
/// Null where there is none of this name.
const HardKind* hard_kind(std::string_view name);

struct HardScene {
  scene::Scene scene;
  double tolerance = 0;  ///< T to repair at, file units
  std::string variant;   ///< what the seed made of it besides: "+needles, float32"; empty where nothing
};

/// One kind alone, or for every fourth seed mixed with another. Of sixteen seeds two are rounded to single precision,
/// and two of those far from the origin; T is 1e-2, or 1e-4, or 1e-2 at ten pitches of the lattice. The same on every
/// machine up to the rounding of sine and cosine.
HardScene hard_scene(const HardKind& kind, std::uint64_t seed, int size = 1);

}  // namespace rad::corpus
