// Pictures of a scene with its faults drawn over it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bake/camera.h"
#include "bake/image.h"
#include "bake/ray_scene.h"
#include "scene/finding.h"

namespace rad::bake {

/// What of a finding is drawn.
struct DrawnFault {
  scene::Severity severity = scene::Severity::Error;
  std::span<const scene::FaceId> faces;       ///< hatched in the colour of the severity
  std::span<const scene::FaultPlace> places;  ///< lines and signs over everything
};

DrawnFault drawn(const scene::Finding& finding);

struct FaultPicture {
  std::uint32_t width = 480;           ///< pixels
  std::uint32_t height = 320;          ///< pixels
  std::uint32_t samples_per_axis = 3;  ///< on a regular grid in each pixel; at least 1
  Camera camera;
};

/// Draws one scene many times. The scene must outlive it.
class FaultPainter {
 public:
  explicit FaultPainter(const scene::Scene& scene, BackFaces back_faces = BackFaces::SeenThrough);

  /// A camera that looks at the worst place of a finding, near enough to tell it from its neighbours, from where it is
  /// seen best; nothing for a finding without a place. `aspect` is width over height.
  [[nodiscard]] std::optional<Camera> close_up(const scene::Finding& finding, double aspect) const;

  /// Whether nothing hides the worst place of a finding from this camera.
  [[nodiscard]] bool shows(const scene::Finding& finding, const Camera& camera) const;

  /// The scene as a whole, from where the worst place of a finding is seen best.
  [[nodiscard]] Camera whole(const scene::Finding& finding, double aspect) const;

  /// White paper, grey faces with dark edges, the faults over them. The same picture whatever the number of threads.
  [[nodiscard]] Image picture(const FaultPicture& view, std::span<const DrawnFault> faults) const;

  [[nodiscard]] std::span<const DrawnTriangle> triangles() const { return triangles_; }

 private:
  struct Focus;
  struct Paints;
  [[nodiscard]] std::optional<Focus> focus_of(const scene::Finding& finding) const;
  [[nodiscard]] geom::dvec3 best_direction(const Focus& focus) const;
  [[nodiscard]] bool sees(const geom::dvec3& from, const geom::dvec3& place) const;

  const scene::Scene& scene_;
  geom::Box box_;
  geom::dvec3 up_;
  std::vector<DrawnTriangle> triangles_;
  RayScene rays_;
};

}  // namespace rad::bake
