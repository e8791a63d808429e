#include "bake/preview.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "bake/lit_camera.h"
#include "bake/ray_scene.h"
#include "bake/viewport.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::VertexLight;

// Linear grey of a face seen at grazing angle and of one seen head-on.
constexpr double kGrazingGrey = 0.12;
constexpr double kFacingGrey = 0.72;
constexpr dvec3 kBackTint{1.0, 0.45, 0.35};
constexpr dvec3 kOutlineColour{0.01, 0.01, 0.01};
// Pixels on each side of an edge, so that an edge between two faces is a line 1.2 pixels wide.
constexpr double kOutlineHalfWidth = 0.6;

class Painter {
 public:
  Painter(const Scene& scene, const VertexLight* light, const PreviewOptions& options)
      : scene_(scene),
        light_(light),
        options_(options),
        triangles_(drawn_triangles(scene)),
        rays_(scene, triangles_, options.cull_back_faces ? BackFaces::SeenThrough : BackFaces::Seen),
        view_(chosen_camera(), options.width, options.height) {}

  [[nodiscard]] bool has_view() const { return view_.has_view(); }

  // The mean of samples on a regular grid, added row by row.
  [[nodiscard]] dvec3 pixel(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t samples = std::max(1u, options_.samples_per_axis);
    dvec3 sum{0, 0, 0};
    for (std::uint32_t j = 0; j < samples; ++j) {
      for (std::uint32_t i = 0; i < samples; ++i) {
        sum += colour_along(view_.ray_through(column + (i + 0.5) / samples, row + (j + 0.5) / samples));
      }
    }
    return sum / static_cast<double>(samples * samples);
  }

 private:
  Camera chosen_camera() const {
    const double aspect = static_cast<double>(options_.width) / options_.height;
    if (options_.camera) return *options_.camera;
    if (light_ == nullptr) return automatic_camera(scene_, aspect);
    return lit_camera(scene_, *light_, triangles_, rays_, aspect);
  }

  dvec3 colour_along(const dvec3& direction) const {
    const std::optional<RayHit> hit = rays_.nearest(view_.camera().position, direction);
    if (!hit) return options_.background;
    const DrawnTriangle& triangle = triangles_[hit->triangle];
    if (options_.outline_faces && is_on_outline(triangle, direction)) return kOutlineColour;
    return light_ != nullptr ? lit(triangle, *hit) : shaded(triangle, *hit, direction);
  }

  dvec3 lit(const DrawnTriangle& triangle, const RayHit& hit) const {
    if (hit.from_behind) return {0, 0, 0};
    const auto& colour = light_->colour;
    return (1 - hit.u - hit.v) * colour[triangle.corners[0]] + hit.u * colour[triangle.corners[1]] +
           hit.v * colour[triangle.corners[2]];
  }

  dvec3 shaded(const DrawnTriangle& triangle, const RayHit& hit, const dvec3& direction) const {
    const dvec3& a = scene_.vertices[triangle.corners[0]];
    const dvec3 normal = glm::cross(scene_.vertices[triangle.corners[1]] - a, scene_.vertices[triangle.corners[2]] - a);
    const double length = glm::length(normal);
    const double cosine = length > 0 ? std::abs(glm::dot(normal, direction)) / length : 0;
    const double grey = kGrazingGrey + (kFacingGrey - kGrazingGrey) * cosine;
    return hit.from_behind ? grey * kBackTint : dvec3{grey, grey, grey};
  }

  bool is_on_outline(const DrawnTriangle& triangle, const dvec3& direction) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!triangle.outline[i]) continue;
      const dvec3& from = scene_.vertices[triangle.corners[i]];
      const dvec3& to = scene_.vertices[triangle.corners[(i + 1) % 3]];
      if (view_.passes_line(direction, from, to, kOutlineHalfWidth)) return true;
    }
    return false;
  }

  const Scene& scene_;
  const VertexLight* light_;
  const PreviewOptions& options_;
  std::vector<DrawnTriangle> triangles_;
  RayScene rays_;
  Viewport view_;
};

}  // namespace

Image render(const Scene& scene, const VertexLight* light, const PreviewOptions& options) {
  Image image{.width = options.width, .height = options.height, .pixels = {}};
  image.pixels.assign(std::size_t{options.width} * options.height, options.background);
  if (image.pixels.empty()) return image;
  const Painter painter(scene, light, options);
  if (!painter.has_view()) return image;
  tbb::parallel_for(0u, options.height, [&](std::uint32_t row) {
    for (std::uint32_t column = 0; column < options.width; ++column) {
      image.pixels[std::size_t{row} * options.width + column] = painter.pixel(column, row);
    }
  });
  return image;
}

Camera light_camera(const Scene& scene, const VertexLight& light, double aspect) {
  const std::vector<DrawnTriangle> triangles = drawn_triangles(scene);
  return lit_camera(scene, light, triangles, RayScene(scene, triangles, BackFaces::SeenThrough), aspect);
}

}  // namespace rad::bake
