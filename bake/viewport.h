// A camera and the picture that it fills: rays through pixels, and where points are seen.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "bake/camera.h"

namespace rad::bake {

class Viewport {
 public:
  /// `width` and `height` in pixels, both positive.
  Viewport(const Camera& camera, std::uint32_t width, std::uint32_t height);

  /// Whether position, target, direction up and field of view make a view.
  [[nodiscard]] bool has_view() const;

  [[nodiscard]] const Camera& camera() const { return camera_; }

  /// Unit vector from the camera through a point of the picture; pixels from the upper left corner, so that the first
  /// pixel's centre is (0.5, 0.5).
  [[nodiscard]] geom::dvec3 ray_through(double x, double y) const;

  /// Where a point is seen, in pixels, also beside the picture; nothing for what is not before the camera.
  [[nodiscard]] std::optional<glm::dvec2> pixel_of(const geom::dvec3& point) const;

  /// How many pixels a length across the line of sight takes at a distance from the camera, both in file units.
  [[nodiscard]] double pixels_of(double length, double distance) const {
    return length / distance * height_ / (2 * slope_);
  }

  /// Whether a ray along the unit vector `direction` passes within `pixels` of the line through two points. Holds for
  /// lines that reach behind the camera too.
  [[nodiscard]] bool passes_line(const geom::dvec3& direction, const geom::dvec3& from, const geom::dvec3& to,
                                 double pixels) const;

 private:
  Camera camera_;
  double width_;
  double height_;
  CameraFrame frame_;
  double slope_;  ///< tangent of half the vertical field of view
};

}  // namespace rad::bake
