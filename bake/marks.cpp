#include "bake/marks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::bake {
namespace {

using geom::dvec3;
using glm::dvec2;

constexpr dvec3 kCasing{1, 1, 1};
constexpr double kLineHalfWidth = 1.6;    ///< pixels
constexpr double kCasingWidth = 1.4;      ///< pixels
constexpr double kSqrtHalf = 0.70710678;  ///< of the diagonal of a square

/// Share of a pixel that lies inside of a border `distance` pixels away, negative inside.
double coverage(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }

dvec3 blend(const dvec3& under, const dvec3& over, double share) { return under * (1 - share) + over * share; }

/// Paints `colour` with a casing around it wherever `distance`, of a pixel's centre to the border of the shape, says.
template <typename Distance>
void paint(Image& image, const dvec2& low, const dvec2& high, const dvec3& colour, const Distance& distance) {
  const auto first = [](double value, std::uint32_t end) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(value), 0.0, static_cast<double>(end)));
  };
  for (std::uint32_t y = first(low.y, image.height); y < first(high.y + 1, image.height); ++y) {
    for (std::uint32_t x = first(low.x, image.width); x < first(high.x + 1, image.width); ++x) {
      const double d = distance(dvec2{x + 0.5, y + 0.5});
      dvec3& pixel = image.pixels[std::size_t{y} * image.width + x];
      pixel = blend(pixel, kCasing, coverage(d - kCasingWidth));
      pixel = blend(pixel, colour, coverage(d));
    }
  }
}

double distance_to_line(const dvec2& p, const dvec2& from, const dvec2& to) {
  const dvec2 along = to - from;
  const double square = glm::dot(along, along);
  const double share = square > 0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0;
  return glm::length(p - from - share * along);
}

double distance_to_sign(const dvec2& p, scene::Severity severity, double radius) {
  switch (severity) {
    case scene::Severity::Error:
      return (std::abs(p.x) + std::abs(p.y) - radius * 1.15) * kSqrtHalf;
    case scene::Severity::Warning:
      // Three sides of an equilateral triangle, tip up.
      return std::max(p.y - radius * 0.6, std::abs(p.x) * 0.8660254 - p.y * 0.5 - radius * 0.6);
    case scene::Severity::Note:
      break;
  }
  return glm::length(p) - radius * 0.85;
}

}  // namespace

dvec3 severity_colour(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::Error:
      return {0.451, 0.019, 0.004};  // sRGB b3260d, vermilion
    case scene::Severity::Warning:
      return {0.791, 0.347, 0.000};  // sRGB e69f00, amber
    case scene::Severity::Note:
      break;
  }
  return {0.000, 0.168, 0.445};  // sRGB 0072b2, blue
}

void draw_line(Image& image, const dvec2& from, const dvec2& to, const dvec3& colour) {
  const double reach = kLineHalfWidth + kCasingWidth + 1;
  const dvec2 low{std::min(from.x, to.x) - reach, std::min(from.y, to.y) - reach};
  const dvec2 high{std::max(from.x, to.x) + reach, std::max(from.y, to.y) + reach};
  paint(image, low, high, colour, [&](const dvec2& p) { return distance_to_line(p, from, to) - kLineHalfWidth; });
}

void draw_sign(Image& image, const dvec2& at, scene::Severity severity, double radius) {
  const double reach = 1.3 * radius + kCasingWidth + 1;
  paint(image, at - reach, at + reach, severity_colour(severity),
        [&](const dvec2& p) { return distance_to_sign(p - at, severity, radius); });
}

}  // namespace rad::bake
