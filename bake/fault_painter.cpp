#include "bake/fault_painter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "bake/marks.h"
#include "bake/viewport.h"

namespace rad::bake {

using geom::dvec3;
using scene::FaceId;
using scene::Scene;

namespace {

constexpr dvec3 kPaper{1, 1, 1};
constexpr dvec3 kEdge{0.09, 0.1, 0.12};
// Linear grey of a face seen at grazing angle and of one seen head-on.
constexpr double kGrazingGrey = 0.28;
constexpr double kFacingGrey = 0.80;
constexpr double kLampShare = 0.4;
constexpr dvec3 kBackTint{0.62, 0.60, 0.80};
constexpr double kOutlineHalfWidth = 0.5;  ///< pixels
constexpr double kFullInkPixels = 24, kFaintestInk = 0.12;
// Hatching: stripes of this many pixels, one of two darker, mixed into the shade of the face.
constexpr double kStripe = 5;
constexpr double kFaintShare = 0.28, kStrongShare = 0.52;
constexpr double kSignRadius = 6.5;  ///< pixels
// A close-up shows at least this share of the model's diagonal, and at most that share around the place.
constexpr double kLeastReach = 0.035, kMostReach = 0.30;
// A whole model is seen from this much farther than frames it, so that signs at its rim are not cut off.
constexpr double kRoomForSigns = 1.12;
constexpr double kFieldOfViewDeg = 35;
// Of views that show a place alike the first is taken.
constexpr double kClearlyBetter = 1.02;
// Hits this share of the diagonal before the place are the surface that it lies on.
constexpr double kOnSurface = 2e-3;
// What a view is worth in which something hides the place.
constexpr double kHiddenShare = 0.2;

bool finite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

geom::Box box_of(const Scene& scene) {
  geom::Box box;
  for (const scene::VertexId id : scene.corners) {
    if (finite(scene.vertices[id])) box.add(scene.vertices[id]);
  }
  return box;
}

dvec3 normal_of(const Scene& scene, const DrawnTriangle& triangle) {
  const dvec3& a = scene.vertices[triangle.corners[0]];
  const dvec3 normal = glm::cross(scene.vertices[triangle.corners[1]] - a, scene.vertices[triangle.corners[2]] - a);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : dvec3{0, 0, 0};
}

geom::Box box_of(const Scene& scene, FaceId face) {
  geom::Box box;
  for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
    for (const scene::VertexId id : scene.corners_of(loop)) {
      if (finite(scene.vertices[id])) box.add(scene.vertices[id]);
    }
  }
  return box;
}

}  // namespace

DrawnFault drawn(const scene::Finding& finding) {
  return {finding.severity, finding.where.face_ids, finding.where.places};
}

/// Where a camera looks at.
struct FaultPainter::Focus {
  dvec3 at{0, 0, 0};
  double reach = 0;       ///< file units around `at`
  dvec3 normal{0, 0, 0};  ///< of a face at fault; zero where none is known
  dvec3 along{0, 0, 0};   ///< of the segment at fault; zero where there is none
};

/// The face of a pixel's sample, its shade and what is drawn over it.
struct FaultPainter::Paints {
  const FaultPainter& painter;
  const FaultPicture& options;
  Viewport view;
  CameraFrame frame;
  dvec3 lamp;
  std::vector<std::uint8_t> severity_of_face;  ///< 0 for none, else 1 + severity

  Paints(const FaultPainter& owner, const FaultPicture& picture, std::span<const DrawnFault> faults)
      : painter(owner),
        options(picture),
        view(picture.camera, picture.width, picture.height),
        frame(frame_of(picture.camera)),
        lamp(glm::normalize(0.35 * frame.right + 0.8 * frame.up + 0.5 * frame.backward)),
        severity_of_face(owner.scene_.faces.size(), 0) {
    for (const DrawnFault& fault : faults) {
      const auto level = static_cast<std::uint8_t>(1 + static_cast<int>(fault.severity));
      for (const FaceId face : fault.faces) severity_of_face[face] = std::max(severity_of_face[face], level);
    }
  }

  // The mean of samples on a regular grid, added row by row.
  [[nodiscard]] dvec3 pixel(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t samples = std::max(1u, options.samples_per_axis);
    dvec3 sum{0, 0, 0};
    for (std::uint32_t j = 0; j < samples; ++j) {
      for (std::uint32_t i = 0; i < samples; ++i) {
        sum += sample(column + (i + 0.5) / samples, row + (j + 0.5) / samples);
      }
    }
    return sum / static_cast<double>(samples * samples);
  }

  [[nodiscard]] dvec3 sample(double x, double y) const {
    const dvec3 direction = view.ray_through(x, y);
    const std::optional<RayHit> hit = painter.rays_.nearest(view.camera().position, direction);
    if (!hit) return kPaper;
    const DrawnTriangle& triangle = painter.triangles_[hit->triangle];
    const double grey = grey_of(triangle, direction);
    const dvec3 shade = hit->from_behind ? grey * kBackTint : dvec3{grey, grey, grey};
    const dvec3 surface = hatched(shade, severity_of_face[triangle.face], x, y);
    const double ink = ink_of_edges(triangle, direction, hit->distance);
    return surface * (1 - ink) + kEdge * ink;
  }

  // How dark the edges of a face are here: fainter where they are short, so that dense meshes do not become black.
  [[nodiscard]] double ink_of_edges(const DrawnTriangle& triangle, const dvec3& direction, double distance) const {
    double ink = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3& from = painter.scene_.vertices[triangle.corners[i]];
      const dvec3& to = painter.scene_.vertices[triangle.corners[(i + 1) % 3]];
      if (!triangle.outline[i] || !view.passes_line(direction, from, to, kOutlineHalfWidth)) continue;
      const double pixels = view.pixels_of(glm::length(to - from), distance);
      ink = std::max(ink, std::clamp(pixels / kFullInkPixels, kFaintestInk, 1.0));
    }
    return ink;
  }

  // The same all over a plane, so that pictures stay small: light along the line of sight and a little from above.
  [[nodiscard]] double grey_of(const DrawnTriangle& triangle, const dvec3& direction) const {
    dvec3 normal = normal_of(painter.scene_, triangle);
    if (glm::dot(normal, direction) > 0) normal = -normal;
    const double facing = std::max(0.0, glm::dot(normal, frame.backward));
    const double lit = std::max(0.0, glm::dot(normal, lamp));
    return kGrazingGrey + (kFacingGrey - kGrazingGrey) * ((1 - kLampShare) * facing + kLampShare * lit);
  }

  static dvec3 hatched(const dvec3& shade, std::uint8_t level, double x, double y) {
    if (level == 0) return shade;
    const bool strong = std::fmod(x + y, 2 * kStripe) < kStripe;
    const double share = strong ? kStrongShare : kFaintShare;
    return shade * (1 - share) + severity_colour(static_cast<scene::Severity>(level - 1)) * share;
  }
};

FaultPainter::FaultPainter(const Scene& scene, BackFaces back_faces)
    : scene_(scene),
      box_(box_of(scene)),
      up_(up_direction(scene)),
      triangles_(drawn_triangles(scene)),
      rays_(scene, triangles_, back_faces) {}

std::optional<FaultPainter::Focus> FaultPainter::focus_of(const scene::Finding& finding) const {
  const scene::Where& where = finding.where;
  Focus focus;
  geom::Box faces;
  if (!where.face_ids.empty()) {
    faces = box_of(scene_, where.face_ids.front());
    const auto first = std::ranges::lower_bound(triangles_, where.face_ids.front(), {}, &DrawnTriangle::face);
    if (first != triangles_.end() && first->face == where.face_ids.front()) focus.normal = normal_of(scene_, *first);
  }
  if (where.segment) {
    const dvec3 along = (*where.segment)[1] - (*where.segment)[0];
    focus.at = (*where.segment)[0] + 0.5 * along;
    focus.reach = glm::length(along) * 0.75;
    if (glm::length(along) > 0) focus.along = glm::normalize(along);
  } else if (where.point) {
    focus.at = *where.point;
    if (!faces.empty()) focus.reach = faces.diagonal() / 2;
  } else if (!faces.empty()) {
    focus.at = faces.low * 0.5 + faces.high * 0.5;
    focus.reach = faces.diagonal() / 2;
  } else {
    return std::nullopt;
  }
  if (!finite(focus.at) || box_.empty()) return std::nullopt;
  focus.reach = std::clamp(focus.reach, kLeastReach * box_.diagonal(), kMostReach * box_.diagonal());
  return focus;
}

bool FaultPainter::sees(const dvec3& from, const dvec3& place) const {
  const auto hit = rays_.nearest(from, place - from);
  return !hit || hit->distance >= glm::length(place - from) - kOnSurface * box_.diagonal();
}

bool FaultPainter::shows(const scene::Finding& finding, const Camera& camera) const {
  const std::optional<Focus> focus = focus_of(finding);
  return focus && sees(camera.position, focus->at);
}

dvec3 FaultPainter::best_direction(const Focus& focus) const {
  dvec3 best = views_around(up_, 32)[0];
  double most = 0;
  for (const double elevation : {32.0, 12.0, 58.0, -25.0}) {
    for (const dvec3& direction : views_around(up_, elevation)) {
      const double facing = 0.5 + 0.5 * glm::dot(focus.normal, direction);
      const double across = 1 - std::abs(glm::dot(focus.along, direction));
      const bool seen = sees(focus.at + (2 * box_.diagonal() + focus.reach) * direction, focus.at);
      // From below is less familiar.
      const double score = (seen ? 1 : kHiddenShare) * (0.4 + facing) * (0.6 + across) * (elevation < 0 ? 0.8 : 1);
      if (score > kClearlyBetter * most) {
        most = score;
        best = direction;
      }
    }
  }
  return best;
}

std::optional<Camera> FaultPainter::close_up(const scene::Finding& finding, double aspect) const {
  const std::optional<Focus> focus = focus_of(finding);
  if (!focus) return std::nullopt;
  const double slope = std::tan(kFieldOfViewDeg * 3.14159265358979 / 360) * std::min(1.0, aspect);
  const double distance = focus->reach / slope * 1.35;
  return Camera{.position = focus->at + distance * best_direction(*focus),
                .target = focus->at,
                .up = up_,
                .vertical_field_of_view_deg = kFieldOfViewDeg};
}

Camera FaultPainter::whole(const scene::Finding& finding, double aspect) const {
  const std::optional<Focus> focus = focus_of(finding);
  Camera camera = focus ? framing_camera(scene_, best_direction(*focus), aspect) : automatic_camera(scene_, aspect);
  camera.position = camera.target + kRoomForSigns * (camera.position - camera.target);
  return camera;
}

Image FaultPainter::picture(const FaultPicture& view, std::span<const DrawnFault> faults) const {
  Image image{.width = view.width, .height = view.height, .pixels = {}};
  image.pixels.assign(std::size_t{view.width} * view.height, kPaper);
  if (image.pixels.empty()) return image;
  const Paints paints(*this, view, faults);
  if (!paints.view.has_view()) return image;
  tbb::parallel_for(0u, view.height, [&](std::uint32_t row) {
    for (std::uint32_t column = 0; column < view.width; ++column) {
      image.pixels[std::size_t{row} * view.width + column] = paints.pixel(column, row);
    }
  });
  for (const DrawnFault& fault : faults) {
    for (const scene::FaultPlace& place : fault.places) {
      if (!place.segment) continue;
      const auto from = paints.view.pixel_of((*place.segment)[0]), to = paints.view.pixel_of((*place.segment)[1]);
      if (from && to) draw_line(image, *from, *to, severity_colour(fault.severity));
    }
  }
  for (const DrawnFault& fault : faults) {
    for (const scene::FaultPlace& place : fault.places) {
      const auto at = place.point ? paints.view.pixel_of(*place.point) : std::nullopt;
      if (at) draw_sign(image, *at, fault.severity, kSignRadius);
    }
  }
  return image;
}

}  // namespace rad::bake
