// Luminous intensities of a luminaire as files of photometry state them, and what of that cannot be.
#pragma once

#include <string>
#include <vector>

#include "readers/reader.h"
#include "scene/scene_builder.h"

namespace rad::readers {

/// How the planes of measurement turn: about the vertical axis (C), about a horizontal one (B), about the other (A).
enum class PlaneType : std::uint8_t { C = 1, B = 2, A = 3 };

struct Photometry {
  PlaneType type = PlaneType::C;
  std::vector<double> vertical;    ///< degrees, strictly ascending; for C from the nadir, else from the horizon
  std::vector<double> horizontal;  ///< degrees, strictly ascending
  std::vector<double> intensity;   ///< cd or cd/klm, plane by plane
};

/// Integral of the intensity over all directions, lm or lm/klm: linear between the angles that are given, planes that
/// symmetry leaves out like those that stand for them, and nothing beyond the first and last vertical angle.
double flux_of(const Photometry& photometry);

/// Which directions the angles of an IES file leave out, in a clause; empty where they are all there.
std::string gap_in(const Photometry& photometry);

/// Whether a number may stand in a file of photometry: below 1e8, so that no sum of them overflows; not NaN.
bool is_believable(double value);

/// Whether there are angles, each farther than the one before, all within a turn either way.
bool are_ascending(const std::vector<double>& angles);

/// A scene without faces, for a file of this format: angles count from the nadir, so that Z is up.
scene::SceneBuilder luminaire(const Input& input, const char* format, double metres_per_unit);

}  // namespace rad::readers
