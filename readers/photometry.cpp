#include "readers/photometry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string_view>

namespace rad::readers {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// Angles in files are rounded to hundredths at most.
constexpr double kAngleAccuracy = 0.01;

bool is_at(double angle, double place) { return std::abs(angle - place) <= kAngleAccuracy; }

// The integral of f(x) sin x from a to b, where f goes from fa to fb in a straight line.
double times_sine(double a, double b, double fa, double fb) {
  const double slope = (fb - fa) / (b - a);
  return fa * (std::cos(a) - std::cos(b)) + slope * (std::sin(b) - std::sin(a) - (b - a) * std::cos(b));
}

// Over the vertical angles of one plane, per radian between planes. The horizon is a quarter turn from the nadir.
double plane_integral(const Photometry& photometry, std::size_t plane) {
  const double from = photometry.type == PlaneType::C ? 0 : 90;
  const std::size_t first = plane * photometry.vertical.size();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < photometry.vertical.size(); ++i) {
    sum += times_sine((photometry.vertical[i] + from) * kRadiansPerDegree,
                      (photometry.vertical[i + 1] + from) * kRadiansPerDegree, photometry.intensity[first + i],
                      photometry.intensity[first + i + 1]);
  }
  return sum;
}

bool is_half(const std::vector<double>& angles) { return is_at(angles.front(), 0); }

}  // namespace

double flux_of(const Photometry& photometry) {
  const std::vector<double>& turn = photometry.horizontal;
  double sum = 0;
  for (std::size_t i = 0; i + 1 < turn.size(); ++i) {
    sum += 0.5 * (plane_integral(photometry, i) + plane_integral(photometry, i + 1)) * (turn[i + 1] - turn[i]) *
           kRadiansPerDegree;
  }
  if (photometry.type != PlaneType::C) {
    return sum * (is_half(turn) ? 2 : 1) * (is_half(photometry.vertical) ? 2 : 1);
  }
  const double mean =
      turn.size() == 1 ? plane_integral(photometry, 0) : sum / ((turn.back() - turn.front()) * kRadiansPerDegree);
  return mean * 2 * std::numbers::pi;
}

std::string gap_in(const Photometry& photometry) {
  const auto [low, high] = std::pair(photometry.vertical.front(), photometry.vertical.back());
  const auto ends_at = [](double angle, std::initializer_list<double> places) {
    return std::ranges::any_of(places, [&](double place) { return is_at(angle, place); });
  };
  const auto range = [](std::string_view what, double from, double to) {
    return std::string(what) + " angles go from " + std::to_string(std::lround(from)) + " to " +
           std::to_string(std::lround(to)) + " degrees";
  };
  const auto [first, last] = std::pair(photometry.horizontal.front(), photometry.horizontal.back());
  if (photometry.type != PlaneType::C) {
    if (!ends_at(low, {-90, 0}) || !ends_at(high, {90})) return range("vertical", low, high) + ", not to 90";
    if (!ends_at(first, {-90, 0}) || !ends_at(last, {90})) return range("horizontal", first, last) + ", not to 90";
    return {};
  }
  if (!ends_at(low, {0, 90}) || !ends_at(high, {90, 180}) || is_at(low, high)) {
    return range("vertical", low, high) + ", neither to the horizon nor to the zenith";
  }
  const bool whole = is_at(first, 0) ? ends_at(last, {0, 90, 180, 360}) : is_at(first, 90) && ends_at(last, {270});
  if (!whole) return range("horizontal", first, last) + ", which is no quarter, half or whole turn";
  constexpr double kWidestStep = 90;
  for (std::size_t i = 0; i + 1 < photometry.horizontal.size(); ++i) {
    if (photometry.horizontal[i + 1] - photometry.horizontal[i] <= kWidestStep + kAngleAccuracy) continue;
    return "no plane lies between " + std::to_string(std::lround(photometry.horizontal[i])) + " and " +
           std::to_string(std::lround(photometry.horizontal[i + 1])) + " degrees";
  }
  return {};
}

bool is_believable(double value) {
  constexpr double kMost = 1e8;
  return std::abs(value) <= kMost;
}

bool are_ascending(const std::vector<double>& angles) {
  constexpr double kLeast = -360, kMost = 360;
  return !angles.empty() && angles.front() >= kLeast && angles.back() <= kMost &&
         std::ranges::adjacent_find(angles, std::not_fn(std::less<>())) == angles.end();
}

scene::SceneBuilder luminaire(const Input& input, const char* format, double metres_per_unit) {
  scene::SceneBuilder builder(input.path, format);
  builder.add_section({input.path, {}, scene::RecordKind::Line});
  builder.scene().metres_per_unit = metres_per_unit;
  builder.scene().up = scene::UpAxis::Z;
  return builder;
}

}  // namespace rad::readers
