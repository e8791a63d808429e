#include "bake/viewport.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace rad::bake {

using geom::dvec3;

Viewport::Viewport(const Camera& camera, std::uint32_t width, std::uint32_t height)
    : camera_(camera),
      width_(width),
      height_(height),
      frame_(frame_of(camera)),
      slope_(std::tan(camera.vertical_field_of_view_deg * std::numbers::pi / 360)) {}

bool Viewport::has_view() const {
  const dvec3 sum = camera_.position + frame_.right + frame_.up + frame_.backward;
  return std::isfinite(sum.x + sum.y + sum.z) && slope_ > 0 && std::isfinite(slope_);
}

dvec3 Viewport::ray_through(double x, double y) const {
  const double across = (2 * x / width_ - 1) * slope_ * width_ / height_;
  const double above = (1 - 2 * y / height_) * slope_;
  return glm::normalize(across * frame_.right + above * frame_.up - frame_.backward);
}

std::optional<glm::dvec2> Viewport::pixel_of(const dvec3& point) const {
  const dvec3 seen = point - camera_.position;
  const double ahead = -glm::dot(seen, frame_.backward);
  if (!(ahead > 0)) return std::nullopt;
  const double scale = height_ / (2 * slope_ * ahead);
  return glm::dvec2{width_ / 2 + glm::dot(seen, frame_.right) * scale, height_ / 2 - glm::dot(seen, frame_.up) * scale};
}

// A line and the eye span a plane; how far the ray leaves it is how far the line is away in the picture.
bool Viewport::passes_line(const dvec3& direction, const dvec3& from, const dvec3& to, double pixels) const {
  const dvec3 across = glm::cross(from - camera_.position, to - camera_.position);
  return std::abs(glm::dot(across, direction)) < pixels * 2 * slope_ / height_ * glm::length(across);
}

}  // namespace rad::bake
