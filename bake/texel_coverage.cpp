#include "bake/texel_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rad::bake {
namespace {

// A quadrilateral cut by four lines.
struct Outline {
  std::array<dvec2, 8> corner{};
  std::size_t count = 0;
};

enum class Axis : std::uint8_t { X, Y };

double along(const dvec2& point, Axis axis) { return axis == Axis::X ? point.x : point.y; }

// What lies at `sign` · coordinate <= `sign` · line.
Outline cut(const Outline& outline, Axis axis, double line, double sign) {
  Outline kept;
  for (std::size_t i = 0; i < outline.count; ++i) {
    const dvec2 &a = outline.corner[i], &b = outline.corner[(i + 1) % outline.count];
    const double da = sign * (along(a, axis) - line), db = sign * (along(b, axis) - line);
    if (da <= 0) kept.corner[kept.count++] = a;
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) kept.corner[kept.count++] = a + (b - a) * (da / (da - db));
  }
  return kept;
}

double area(const Outline& outline) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < outline.count; ++i) {
    const dvec2 a = outline.corner[i] - outline.corner[0], b = outline.corner[i + 1] - outline.corner[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return std::abs(doubled) / 2;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Between what the outline has in common at the upper and at the lower line it fills the row, being convex.
Interval filled(const Outline& outline, double upper, double lower) {
  Interval at_upper, at_lower;
  for (std::size_t i = 0; i < outline.count; ++i) {
    if (outline.corner[i].y == upper) at_upper.add(outline.corner[i].x);
    if (outline.corner[i].y == lower) at_lower.add(outline.corner[i].x);
  }
  return {std::max(at_upper.low, at_lower.low), std::min(at_upper.high, at_lower.high)};
}

// Corners that were cut lie on the line but for rounding.
void settle_on(Outline& outline, double upper, double lower) {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < outline.count; ++i) {
    double& y = outline.corner[i].y;
    if (std::abs(y - upper) <= kRounding * std::max(1.0, std::abs(upper))) y = upper;
    if (std::abs(y - lower) <= kRounding * std::max(1.0, std::abs(lower))) y = lower;
  }
}

}  // namespace

void add_coverage(const FlatElement& element, const CoverageRow& row) {
  Outline outline;
  outline.count = element.count;
  std::copy_n(element.corner.begin(), element.count, outline.corner.begin());
  const double upper = static_cast<double>(row.row) - 0.5, lower = upper + 1;
  outline = cut(cut(outline, Axis::Y, lower, 1), Axis::Y, upper, -1);
  if (outline.count < 3) return;
  settle_on(outline, upper, lower);
  Interval columns;
  for (std::size_t i = 0; i < outline.count; ++i) columns.add(outline.corner[i].x);
  const Interval full = filled(outline, upper, lower);
  const auto last = static_cast<std::int64_t>(row.share.size()) - 1;
  const auto to = std::min(last, static_cast<std::int64_t>(std::floor(columns.high + 0.5)));
  for (auto i = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(columns.low + 0.5))); i <= to; ++i) {
    if (!row.counted.empty() && row.counted[static_cast<std::size_t>(i)] == 0) continue;
    const double left = static_cast<double>(i) - 0.5, right = left + 1;
    const bool whole = left >= full.low && right <= full.high;
    row.share[static_cast<std::size_t>(i)] += whole ? 1 : area(cut(cut(outline, Axis::X, right, 1), Axis::X, left, -1));
  }
}

}  // namespace rad::bake
