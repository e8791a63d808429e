// What is known of the backs of surfaces: whether light or a viewer can reach them (paper 2.1, 1a).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "geom/vec.h"
#include "scene/scene.h"

namespace rad::validate {

struct Context;

enum class FacadeVerdict : std::uint8_t {
  NotAFacade,     ///< closed, and nothing is wrong with the way it faces
  Undecided,      ///< the model has to be repaired first: there are no air cells, or neighbours disagree
  ValidProved,    ///< its backs lie in air cells that hold no light
  Terrain,        ///< the ground: behind it is nothing but open space
  ProbablyValid,  ///< its backs lie in lit cells, but kSightRays rays found no line of sight to anything lit
  InvalidProved,  ///< a line of sight, proved, leads from something lit to a back
  TurnedOver,     ///< its backs that lie in light are of faces whose fronts lie in the dark
};

/// Rays from the backs of each facade. Where none of N finds anything lit, a share below ln(1/α)/N of what the backs
/// see is lit, at confidence 1-α: 1 % at 95 % for 300, 10 % for 30.
inline constexpr int kSightRays = 300;
/// Where more than kManyFacades are in question.
inline constexpr int kFewSightRays = 30;
inline constexpr std::size_t kManyFacades = 5000;

/// Where the rim of a facade comes near to something else without touching it: where light gets in.
struct Gap {
  geom::dvec3 middle{};  ///< lattice units
  double width = 0;      ///< pitches
};

/// A gap is looked for up to this many T.
inline constexpr int kGapReach = 20;

struct Facade {
  FacadeVerdict verdict = FacadeVerdict::NotAFacade;
  int rays = 0;                                     ///< of ProbablyValid
  double lit_back_area = 0;                         ///< pitches²: area of its backs in lit cells
  scene::FaceId face = 0xffffffffu;                 ///< of InvalidProved: the one whose back is seen
  std::optional<std::array<geom::dvec3, 2>> sight;  ///< lattice units, from what is lit to the back
  bool from_open_space = false;                     ///< the line of sight starts there, not at a front
  std::optional<Gap> gap;                           ///< the narrowest
};

struct Facades {
  std::vector<Facade> of_component;                     ///< one for each component of the topology
  std::vector<std::vector<scene::FaceId>> turned_over;  ///< sets of faces that turning as a whole puts into the light
  bool has_emitters = false;
};

/// Computed on first use and kept with the context; rules ask one after the other. Models without open components, and
/// without an emitter inside of a closed one, cost nothing.
const Facades& facades_of(const Context& context);

}  // namespace rad::validate
