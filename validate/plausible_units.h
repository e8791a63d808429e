// Which unit of length a model is likely to be in, judged by how large things would be. A guess that is shown and never
// acted on.
#pragma once

#include <string>
#include <string_view>

#include "validate/context.h"

namespace rad::validate {

struct UnitGuess {
  std::string_view unit;  ///< "m", "cm", "mm", "in", "ft"
  double metres = 1;      ///< of one unit
  double surprise = 0;    ///< sum of squared deviations of what is measured from what is usual; 0 is best
};

/// What is measured of a model: file units. The median of what one kind of object measures in its largest part, where
/// names of objects tell what they are; else the median size of all parts, where there are at least ten.
struct SizeEvidence {
  double diagonal = 0;
  double typical = 0;             ///< 0 where nothing tells
  std::string_view typical_name;  ///< "doors", "chairs"…, "parts"
  double usual_metres = 1;        ///< what `typical` has in the world
  double spread = 2;              ///< factor by which things of the kind differ
};

SizeEvidence size_evidence(const Context& context);

/// Whether the measured things have, if a unit had so many metres, a size that there is not: more than four spreads
/// from the usual. Never where names tell nothing.
bool is_contradicted(const SizeEvidence& evidence, double metres);

/// Surprise at the model if a unit had so many metres.
double surprise_at(const SizeEvidence& evidence, double metres);

struct UnitGuesses {
  UnitGuess best;
  UnitGuess runner_up;
};
UnitGuesses plausible_units(const SizeEvidence& evidence);

/// "doors would be 2.1 m if units were mm; runner-up: cm (21 m)"
std::string words_of(const SizeEvidence& evidence, const UnitGuesses& guesses);

/// "2.1 m", "35 cm", "1.2 km": two digits.
std::string metric_length(double metres);

}  // namespace rad::validate
