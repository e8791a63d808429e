// The one tolerance T of a scene and the numbers derived from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rad::geom {

/// Weld distance over T. Above 2/√3 = 1.1547 inserting a vertex into an edge strictly shortens both halves whenever
/// vertices are separated by the weld distance and T-vertices lie within T, so insertion ends without a cap.
inline constexpr double kWeldRatio = 1.16;

/// T in pitches: below the first the lattice cannot tell noise from geometry and the run is refused; below the second
/// it is allowed with a warning.
inline constexpr double kRefusedBelowPitches = 8;
inline constexpr double kWarnedBelowPitches = 32;

/// Default T as a share of the box diagonal, and of the median object's diagonal.
inline constexpr double kDiagonalShare = 1e-5;
inline constexpr double kMedianObjectShare = 1e-3;

/// Units in the last place of single precision that T must cover when the format stores floats.
inline constexpr double kFloatUlps = 8;

/// Largest T, as a share of the box diagonal, that is taken over from a file: a thousand times the default. Beyond it
/// the record belongs to another model or is meant to do harm.
inline constexpr double kLargestRecordedShare = 1e-2;

enum class ToleranceSource { Default, SinglePrecision, Lattice, Given, Recorded, Declared, Auto };

/// How --tolerance auto came to its T (auto_tolerance.h). Lengths are in file units.
struct AutoChoice {
  double confidence = 0;  ///< width of the gap in decades; 0 where there was none, so that the default was taken
  double low = 0;         ///< no distance lies between low and high
  double high = 0;
  double usual = 0;          ///< the default T
  std::uint64_t joined = 0;  ///< distances that the weld at this T closes and the weld at the default leaves
};

struct Tolerance {
  double length = 0;         ///< file units, `pitches` times the lattice pitch
  std::int64_t pitches = 1;  ///< T in lattice pitches
  double diagonal = 0;       ///< file units, of the box of all finite vertices that a face uses
  ToleranceSource source = ToleranceSource::Default;
  std::optional<AutoChoice> choice;  ///< where auto was asked for and nothing was recorded

  [[nodiscard]] bool coarse_lattice() const { return static_cast<double>(pitches) < kWarnedBelowPitches; }
};

/// The weld distance in pitches, rounded up: what lies farther apart is kept apart wherever rounding has put it.
std::int64_t weld_pitches(const Tolerance& tolerance);

/// What T is derived from, all in file units.
struct ToleranceBasis {
  double pitch = 1;
  double diagonal = 0;
  double median_object_diagonal = 0;
  double largest_magnitude = 0;   ///< of any coordinate
  bool single_precision = false;  ///< the format stores floats
  double recorded = 0;            ///< T that the file records; 0 where it records none of use
  double declared = 0;            ///< below what the program that wrote the file tells no lengths apart; 0: not stated
};

/// Whether a recorded T may be taken over: finite, at least kRefusedBelowPitches pitches and at most
/// kLargestRecordedShare of the diagonal.
bool is_usable_record(double length, double pitch, double diagonal);

/// What T may not be below: 32 pitches, for formats that store floats also 8 ulp at the largest magnitude.
double least_tolerance(const ToleranceBasis& basis);

/// `length` rounded down to a multiple of the pitch.
Tolerance on_lattice(double length, const ToleranceBasis& basis, ToleranceSource source);

/// The recorded T where there is one, else the declared one where it is usable as a record would be and not too small
/// for the lattice, else T = max(32 h, 8 ulp for float formats, min(1e-5 box diagonal, 1e-3 median
/// object diagonal)), rounded down to a multiple of h.
Tolerance default_tolerance(const ToleranceBasis& basis);

/// A tolerance as a user wrote it: `0.5mm`, `0.5` (file units), `1e-5d` (box diagonals) or `auto`.
struct ToleranceRequest {
  enum class Measure { FileUnits, Metres, Diagonals, Auto };
  double value = 0;
  Measure measure = Measure::FileUnits;
};

/// Parses what follows --tolerance; nothing where it is neither `auto` nor a positive finite number
/// with a known suffix.
std::optional<ToleranceRequest> parse_tolerance(std::string_view text);

/// T as asked for, or why not: below 8 pitches the smallest possible T is named; metres need `metres_per_unit`. Not for
/// `auto`, which auto_tolerance answers.
struct ToleranceOutcome {
  std::optional<Tolerance> tolerance;
  std::string problem;
};
ToleranceOutcome requested_tolerance(const ToleranceRequest& request, const ToleranceBasis& basis,
                                     std::optional<double> metres_per_unit);

std::string_view name(ToleranceSource source);

}  // namespace rad::geom
