#include "bake/lit_camera.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "bake/vertex_light.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::VertexLight;

constexpr double kDegrees = std::numbers::pi / 180;
// Linear display value that counts as lit: code 13 of 255, a shade that is told from black.
constexpr double kLit = 0.004;
// Share of the surface in the picture that has to be lit.
constexpr double kLitShare = 0.1;
constexpr std::uint32_t kColumns = 16, kRows = 12;

constexpr double kInsideFieldOfView = 60;
constexpr double kDownward = 10 * kDegrees;
constexpr int kDirections = 12;
constexpr std::size_t kFloorSamples = 40;
// Eyes stand near the corners of the sampled triangles: rooms are seen best from their corners.
constexpr double kCornerShare = 0.8;
constexpr double kEyeShare = 0.6;         ///< of the height of the room
constexpr double kOpenAirEyeShare = 0.3;  ///< of the scene's extent along up, where nothing is above
constexpr double kFloorCosine = 0.9;
// Rays from a floor start this share of the scene's size above it, clear of the floor itself in single precision.
constexpr double kClearance = 1e-4;

double shown_luminance(const VertexLight& light, const DrawnTriangle& triangle, const RayHit& hit) {
  if (hit.from_behind) return 0;
  const auto& c = triangle.corners;
  return luminance((1 - hit.u - hit.v) * light.colour[c[0]] + hit.u * light.colour[c[1]] + hit.v * light.colour[c[2]]);
}

class Viewpoints {
 public:
  Viewpoints(const Scene& scene, const VertexLight& light, std::span<const DrawnTriangle> triangles, double aspect)
      : scene_(scene), light_(light), triangles_(triangles), aspect_(aspect), up_(up_direction(scene)) {}

  bool shows_light(const Camera& camera, const RayScene& shown) const {
    int surface = 0, lit = 0;
    for_each_ray(camera, [&](const dvec3& direction) {
      const auto hit = shown.nearest(camera.position, direction);
      if (!hit) return;
      ++surface;
      if (shown_luminance(light_, triangles_[hit->triangle], *hit) >= kLit) ++lit;
    });
    return lit >= kLitShare * surface;
  }

  std::optional<Camera> best_inside() const {
    const RayScene solid(scene_, triangles_, BackFaces::Seen);
    const std::vector<Camera> cameras = inside(solid);
    std::vector<double> scores(cameras.size());
    tbb::parallel_for(std::size_t{0}, cameras.size(), [&](std::size_t i) { scores[i] = score(cameras[i], solid); });
    const auto best = std::max_element(scores.begin(), scores.end());
    if (best == scores.end() || *best <= 0) return std::nullopt;
    return cameras[static_cast<std::size_t>(best - scores.begin())];
  }

 private:
  template <typename Visit>
  void for_each_ray(const Camera& camera, const Visit& visit) const {
    const CameraFrame frame = frame_of(camera);
    const double slope = std::tan(camera.vertical_field_of_view_deg * kDegrees / 2);
    for (std::uint32_t row = 0; row < kRows; ++row) {
      for (std::uint32_t column = 0; column < kColumns; ++column) {
        const double across = ((2.0 * column + 1) / kColumns - 1) * slope * aspect_;
        const double above = (1 - (2.0 * row + 1) / kRows) * slope;
        visit(across * frame.right + above * frame.up - frame.backward);
      }
    }
  }

  dvec3 corner(const DrawnTriangle& triangle, std::size_t i) const { return scene_.vertices[triangle.corners[i]]; }

  /// Area times luminance of a floor; zero for other faces.
  double floor_light(const DrawnTriangle& triangle) const {
    const dvec3 doubled =
        glm::cross(corner(triangle, 1) - corner(triangle, 0), corner(triangle, 2) - corner(triangle, 0));
    const double size = glm::length(doubled);
    if (!(glm::dot(doubled, up_) >= kFloorCosine * size)) return 0;
    double sum = 0;
    for (const scene::VertexId id : triangle.corners) sum += luminance(light_.colour[id]);
    return sum * size;
  }

  // Floors at equal steps of the light on them, in the order of the scene.
  std::vector<std::size_t> sampled_floors() const {
    std::vector<double> until;
    until.reserve(triangles_.size());
    double sum = 0;
    for (const DrawnTriangle& triangle : triangles_) until.push_back(sum += floor_light(triangle));
    std::vector<std::size_t> floors;
    if (!(sum > 0)) return floors;
    for (std::size_t i = 0; i < kFloorSamples; ++i) {
      const double wanted = sum * (static_cast<double>(i) + 0.5) / kFloorSamples;
      const auto found = std::lower_bound(until.begin(), until.end(), wanted);
      const auto floor = static_cast<std::size_t>(found - until.begin());
      if (floor < until.size() && (floors.empty() || floors.back() != floor)) floors.push_back(floor);
    }
    return floors;
  }

  std::vector<Camera> inside(const RayScene& solid) const {
    geom::Box box;
    for (const DrawnTriangle& triangle : triangles_) {
      for (std::size_t i = 0; i < 3; ++i) box.add(corner(triangle, i));
    }
    std::vector<Camera> cameras;
    for (const std::size_t floor : sampled_floors()) {
      const DrawnTriangle& triangle = triangles_[floor];
      const dvec3 middle = (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3.0;
      add_cameras(middle, box, solid, cameras);
      for (std::size_t i = 0; i < 3; ++i) {
        add_cameras(middle + kCornerShare * (corner(triangle, i) - middle), box, solid, cameras);
      }
    }
    return cameras;
  }

  void add_cameras(const dvec3& floor, const geom::Box& box, const RayScene& solid,
                   std::vector<Camera>& cameras) const {
    const dvec3 start = floor + kClearance * box.diagonal() * up_;
    const auto above = solid.nearest(start, up_);
    if (above && above->from_behind) return;
    const double height = above ? kEyeShare * above->distance : kOpenAirEyeShare * glm::dot(box.high - box.low, up_);
    const dvec3 eye = start + height * up_;
    const dvec3 ahead = up_.z > 0 ? dvec3{1, 0, 0} : dvec3{0, 0, 1};
    const dvec3 aside = glm::cross(up_, ahead);
    for (int i = 0; i < kDirections; ++i) {
      const double azimuth = (i + 0.5) * 2 * std::numbers::pi / kDirections;
      const dvec3 level = std::cos(azimuth) * ahead + std::sin(azimuth) * aside;
      const dvec3 direction = std::cos(kDownward) * level - std::sin(kDownward) * up_;
      cameras.push_back({.position = eye,
                         .target = eye + box.diagonal() * direction,
                         .up = up_,
                         .vertical_field_of_view_deg = kInsideFieldOfView});
    }
  }

  // Roots of the distances to what is lit: a wide room counts for more than a close wall, but one far spot through a
  // door does not make up for a picture full of the door frame.
  double score(const Camera& camera, const RayScene& solid) const {
    double sum = 0;
    for_each_ray(camera, [&](const dvec3& direction) {
      const auto hit = solid.nearest(camera.position, direction);
      if (hit && shown_luminance(light_, triangles_[hit->triangle], *hit) >= kLit) sum += std::sqrt(hit->distance);
    });
    return sum;
  }

  const Scene& scene_;
  const VertexLight& light_;
  std::span<const DrawnTriangle> triangles_;
  double aspect_;
  dvec3 up_;
};

}  // namespace

Camera lit_camera(const Scene& scene, const VertexLight& light, std::span<const DrawnTriangle> triangles,
                  const RayScene& shown, double aspect) {
  const Camera outside = automatic_camera(scene, aspect, &light);
  const Viewpoints viewpoints(scene, light, triangles, aspect);
  if (viewpoints.shows_light(outside, shown)) return outside;
  return viewpoints.best_inside().value_or(outside);
}

}  // namespace rad::bake
