#include "geom/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace rad::geom {
namespace {

double single_precision_ulp(double magnitude) {
  if (magnitude <= 0) return 0;
  return std::ldexp(1.0, std::ilogb(magnitude) - 23);
}

constexpr std::pair<std::string_view, double> kMetresPerSuffix[] = {
    {"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"ft", 0.3048}, {"m", 1.0}};

}  // namespace

bool is_usable_record(double length, double pitch, double diagonal) {
  return std::isfinite(length) && length >= kRefusedBelowPitches * pitch && length <= kLargestRecordedShare * diagonal;
}

Tolerance on_lattice(double length, const ToleranceBasis& basis, ToleranceSource source) {
  Tolerance tolerance;
  const double pitches = std::floor(length / basis.pitch * (1 + 0x1p-50));
  tolerance.pitches = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(pitches, 0x1p24)));
  tolerance.length = static_cast<double>(tolerance.pitches) * basis.pitch;
  tolerance.diagonal = basis.diagonal;
  tolerance.source = source;
  return tolerance;
}

double least_tolerance(const ToleranceBasis& basis) {
  const double ulps = basis.single_precision ? kFloatUlps * single_precision_ulp(basis.largest_magnitude) : 0;
  return std::max(kWarnedBelowPitches * basis.pitch, ulps);
}

std::int64_t weld_pitches(const Tolerance& tolerance) {
  static_assert(kWeldRatio == 1.16);
  return (29 * tolerance.pitches + 24) / 25;
}

Tolerance default_tolerance(const ToleranceBasis& basis) {
  if (basis.recorded > 0) return on_lattice(basis.recorded, basis, ToleranceSource::Recorded);
  if (is_usable_record(basis.declared, basis.pitch, basis.diagonal) && basis.declared >= least_tolerance(basis)) {
    return on_lattice(basis.declared, basis, ToleranceSource::Declared);
  }
  double length = kDiagonalShare * basis.diagonal;
  if (basis.median_object_diagonal > 0) length = std::min(length, kMedianObjectShare * basis.median_object_diagonal);
  ToleranceSource source = ToleranceSource::Default;
  const double float_floor = basis.single_precision ? kFloatUlps * single_precision_ulp(basis.largest_magnitude) : 0;
  if (float_floor > length) {
    length = float_floor;
    source = ToleranceSource::SinglePrecision;
  }
  const double lattice_floor = kWarnedBelowPitches * basis.pitch;
  if (lattice_floor > length) {
    length = lattice_floor;
    source = ToleranceSource::Lattice;
  }
  return on_lattice(length, basis, source);
}

std::optional<ToleranceRequest> parse_tolerance(std::string_view text) {
  ToleranceRequest request;
  if (text == "auto") return ToleranceRequest{0, ToleranceRequest::Measure::Auto};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), request.value);
  if (error != std::errc{} || !std::isfinite(request.value) || request.value <= 0) return std::nullopt;
  const std::string_view suffix(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
  if (suffix.empty()) return request;
  if (suffix == "d") {
    request.measure = ToleranceRequest::Measure::Diagonals;
    return request;
  }
  for (const auto& [unit, metres] : kMetresPerSuffix) {
    if (suffix != unit) continue;
    request.value *= metres;
    request.measure = ToleranceRequest::Measure::Metres;
    return request;
  }
  return std::nullopt;
}

ToleranceOutcome requested_tolerance(const ToleranceRequest& request, const ToleranceBasis& basis,
                                     std::optional<double> metres_per_unit) {
  double length = request.value;
  if (request.measure == ToleranceRequest::Measure::Diagonals) length *= basis.diagonal;
  if (request.measure == ToleranceRequest::Measure::Metres) {
    if (!metres_per_unit) return {std::nullopt, "a tolerance with a unit needs the unit of the model: add --units"};
    length /= *metres_per_unit;
  }
  const double smallest = kRefusedBelowPitches * basis.pitch;
  if (length < smallest) {
    return {std::nullopt, fmt::format("tolerance {:.6g} is too small for a model of this extent; the smallest possible "
                                      "is {:.6g} (8 steps of the scene lattice)",
                                      length, smallest)};
  }
  return {on_lattice(length, basis, ToleranceSource::Given), {}};
}

std::string_view name(ToleranceSource source) {
  switch (source) {
    case ToleranceSource::Default:
      return "default";
    case ToleranceSource::SinglePrecision:
      return "single-precision";
    case ToleranceSource::Lattice:
      return "lattice";
    case ToleranceSource::Given:
      return "given";
    case ToleranceSource::Recorded:
      return "recorded";
    case ToleranceSource::Declared:
      return "declared";
    case ToleranceSource::Auto:
      return "auto";
  }
  return "default";
}

}  // namespace rad::geom
