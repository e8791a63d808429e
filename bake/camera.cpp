#include "bake/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "bake/vertex_light.h"
#include "geom/lattice.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::VertexId;
using scene::VertexLight;

constexpr double kDegrees = std::numbers::pi / 180;
constexpr double kElevationDeg = 32;
constexpr double kFirstAzimuth = 30 * kDegrees;
// A view is taken instead of an earlier one only where it shows clearly more: a closed solid shows the same from
// opposite sides but for rounding.
constexpr double kClearlyMore = 1.02;
constexpr double kMarginShare = 0.06;
// At right angles to an axis: within acos(0.999) = 2.6°, as for near-parallel faces elsewhere.
constexpr double kAlongAxis = 0.999;
// How far the middle of a model is from zero, in extents: 0.5 along an axis on which it stands on zero, 0 along one on
// which it was centred. Axes that differ by this are of these two kinds.
constexpr double kOffCentre = 0.35;

bool finite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

geom::Box box_of(const Scene& scene) {
  geom::Box box;
  for (const VertexId id : scene.corners) {
    if (finite(scene.vertices[id])) box.add(scene.vertices[id]);
  }
  return box;
}

/// Normal with the area as its length; zero where a corner is not finite.
dvec3 area_vector(const Scene& scene, const scene::Face& face) {
  dvec3 doubled{0, 0, 0};
  for (const scene::Loop& loop : scene.loops_of(face)) {
    const auto corners = scene.corners_of(loop);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const dvec3& from = scene.vertices[corners[0]];
      doubled += glm::cross(scene.vertices[corners[i]] - from, scene.vertices[corners[i + 1]] - from);
    }
  }
  return finite(doubled) ? doubled / 2.0 : dvec3{0, 0, 0};
}

std::vector<dvec3> area_vectors(const Scene& scene) {
  std::vector<dvec3> areas;
  areas.reserve(scene.faces.size());
  for (const scene::Face& face : scene.faces) areas.push_back(area_vector(scene, face));
  return areas;
}

double area_across(const std::vector<dvec3>& areas, int axis) {
  double sum = 0;
  for (const dvec3& area : areas) {
    const double size = glm::length(area);
    if (std::abs(area[axis]) >= kAlongAxis * size) sum += size;
  }
  return sum;
}

double distance_from_zero(const geom::Box& box, int axis) {
  const double extent = box.high[axis] - box.low[axis];
  return extent > 0 ? std::abs(box.low[axis] / 2 + box.high[axis] / 2) / extent : 0;
}

int unstated_up_axis(const Scene& scene) {
  constexpr int kY = 1, kZ = 2;
  const geom::Box box = box_of(scene);
  if (box.empty()) return kZ;
  const double y_distance = distance_from_zero(box, kY), z_distance = distance_from_zero(box, kZ);
  if (std::abs(y_distance - z_distance) > kOffCentre) return y_distance > z_distance ? kY : kZ;
  const std::vector<dvec3> areas = area_vectors(scene);
  return area_across(areas, kY) > area_across(areas, kZ) ? kY : kZ;
}

/// Mean over the corners of a face.
double shown_luminance(const Scene& scene, const scene::Face& face, const VertexLight& light) {
  double sum = 0;
  std::size_t count = 0;
  for (const scene::Loop& loop : scene.loops_of(face)) {
    for (const VertexId id : scene.corners_of(loop)) sum += luminance(light.colour[id]);
    count += loop.count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// The same, each times the light that it shows; as they were where all is dark.
std::vector<dvec3> weighted(std::vector<dvec3> areas, const Scene& scene, const VertexLight& light) {
  std::vector<dvec3> lit;
  lit.reserve(areas.size());
  double sum = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    lit.push_back(shown_luminance(scene, scene.faces[i], light) * areas[i]);
    sum += glm::length(lit.back());
  }
  return sum > 0 ? lit : areas;
}

dvec3 best_view(const std::vector<dvec3>& areas, const dvec3& up) {
  const auto directions = views_around(up, kElevationDeg);
  std::array<double, directions.size()> shown{};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (const dvec3& area : areas) shown[i] += std::max(0.0, glm::dot(area, directions[i]));
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    if (shown[i] > kClearlyMore * shown[best]) best = i;
  }
  return directions[best];
}

/// How far points reach to both sides of one axis of the picture, each measured where it meets the plane of the eye
/// along the border of the view.
struct Reach {
  double slope;  ///< tangent of half the field of view
  double positive = -std::numeric_limits<double>::infinity();
  double negative = -std::numeric_limits<double>::infinity();

  void add(double across, double backward) {
    positive = std::max(positive, across + slope * backward);
    negative = std::max(negative, -across + slope * backward);
  }
  [[nodiscard]] double distance() const { return (positive + negative) / (2 * slope); }
  [[nodiscard]] double middle() const { return (positive - negative) / 2; }
};

Camera framing(const Scene& scene, const dvec3& centre, const dvec3& view, double aspect) {
  Camera camera{.position = view, .target = {0, 0, 0}, .up = up_direction(scene)};
  const CameraFrame frame = frame_of(camera);
  const double slope = std::tan(camera.vertical_field_of_view_deg * kDegrees / 2) * (1 - kMarginShare);
  Reach wide{.slope = slope * aspect}, high{.slope = slope};
  double nearest = -std::numeric_limits<double>::infinity();
  for (const VertexId id : scene.corners) {
    if (!finite(scene.vertices[id])) continue;
    const dvec3 from_centre = scene.vertices[id] - centre;
    const double backward = glm::dot(from_centre, frame.backward);
    wide.add(glm::dot(from_centre, frame.right), backward);
    high.add(glm::dot(from_centre, frame.up), backward);
    nearest = std::max(nearest, backward);
  }
  double distance = std::max(wide.distance(), high.distance());
  // A model without extent, or seen along a line, would have the eye in it.
  if (!(distance > nearest)) distance = nearest + 1;
  camera.target = centre + wide.middle() * frame.right + high.middle() * frame.up;
  camera.position = camera.target + distance * frame.backward;
  return camera;
}

}  // namespace

CameraFrame frame_of(const Camera& camera) {
  const dvec3 backward = glm::normalize(camera.position - camera.target);
  dvec3 right = glm::cross(camera.up, backward);
  // Below this the sine of the angle between both is noise.
  constexpr double kAlongSight = 1e-9;
  if (!(glm::length(right) > kAlongSight * glm::length(camera.up))) {
    right = glm::cross(std::abs(backward.x) < 0.9 ? dvec3{1, 0, 0} : dvec3{0, 1, 0}, backward);
  }
  right = glm::normalize(right);
  return {right, glm::cross(backward, right), backward};
}

std::array<dvec3, 8> views_around(const dvec3& up, double elevation_deg) {
  // A model with Y up shows its front to +Z, one with Z up to -Y.
  const dvec3 front = up.y > up.z ? dvec3{0, 0, 1} : dvec3{0, -1, 0};
  const dvec3 right{1, 0, 0};
  const double elevation = elevation_deg * kDegrees;
  std::array<dvec3, 8> directions;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double azimuth = kFirstAzimuth + static_cast<double>(i) * 2 * std::numbers::pi / directions.size();
    const dvec3 level = std::cos(azimuth) * front + std::sin(azimuth) * right;
    directions[i] = std::cos(elevation) * level + std::sin(elevation) * up;
  }
  return directions;
}

dvec3 up_direction(const Scene& scene) {
  switch (scene.up) {
    case scene::UpAxis::Y:
      return {0, 1, 0};
    case scene::UpAxis::Z:
      return {0, 0, 1};
    case scene::UpAxis::Unknown:
      break;
  }
  return unstated_up_axis(scene) == 1 ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
}

Camera framing_camera(const Scene& scene, const dvec3& direction, double aspect) {
  const geom::Box box = box_of(scene);
  if (box.empty()) return {};
  return framing(scene, box.low * 0.5 + box.high * 0.5, direction, aspect);
}

Camera automatic_camera(const Scene& scene, double aspect, const VertexLight* light) {
  const geom::Box box = box_of(scene);
  if (box.empty()) return {};
  std::vector<dvec3> areas = area_vectors(scene);
  if (light != nullptr) areas = weighted(std::move(areas), scene, *light);
  return framing_camera(scene, best_view(areas, up_direction(scene)), aspect);
}

}  // namespace rad::bake
