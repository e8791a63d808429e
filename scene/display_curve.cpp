#include "scene/display_curve.h"

#include <algorithm>
#include <cmath>

namespace rad::scene {
namespace {

using geom::dvec3;

constexpr std::array<std::uint32_t, 10> kViridis{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};

dvec3 codes_of(std::uint32_t rgb) {
  return {static_cast<double>(rgb >> 16U & 0xffU), static_cast<double>(rgb >> 8U & 0xffU),
          static_cast<double>(rgb & 0xffU)};
}

double linear(double code) {
  const double value = code / 255;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

dvec3 with_shoulder(const dvec3& exposed) {
  const double most = std::max({exposed.x, exposed.y, exposed.z});
  if (most <= kKnee) return exposed;
  const double beyond = (most - kKnee) / (1 - kKnee);
  return exposed * ((kKnee + (1 - kKnee) * beyond / (1 + beyond)) / most);
}

dvec3 by_reinhard(const dvec3& exposed) {
  const double l = luminance(exposed);
  return exposed * ((1 + l / (kReinhardWhite * kReinhardWhite)) / (1 + l));
}

}  // namespace

std::string_view name(DisplayCurve curve) {
  switch (curve) {
    case DisplayCurve::Linear:
      return "linear";
    case DisplayCurve::Shoulder:
      return "shoulder";
    case DisplayCurve::Reinhard:
      return "reinhard";
    case DisplayCurve::FalseColour:
      return "falsecolor";
  }
  return "";
}

double luminance(const dvec3& colour) { return 0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z; }

dvec3 curved(DisplayCurve curve, const dvec3& exposed) {
  switch (curve) {
    case DisplayCurve::Linear:
      return exposed;
    case DisplayCurve::Shoulder:
      return with_shoulder(exposed);
    case DisplayCurve::Reinhard:
      return by_reinhard(exposed);
    case DisplayCurve::FalseColour:
      return false_colour(luminance(exposed));
  }
  return exposed;
}

std::span<const std::uint32_t> false_colours() { return kViridis; }

dvec3 false_colour(double value) {
  const double at = std::clamp(value, 0.0, 1.0) * (kViridis.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const double share = at - static_cast<double>(first);
  const dvec3 codes = (1 - share) * codes_of(kViridis[first]) + share * codes_of(kViridis[first + 1]);
  return {linear(codes.x), linear(codes.y), linear(codes.z)};
}

}  // namespace rad::scene
