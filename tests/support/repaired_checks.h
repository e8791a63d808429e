// What must hold of every repaired model, by brute force.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "geom/vec.h"
#include "repair/distance.h"
#include "repair/repair.h"
#include "scene/repaired_scene.h"
#include "validate/context.h"
#include "validate/lint.h"

namespace rad::tests {

using Corners3 = std::array<geom::dvec3, 3>;

inline repair::Repaired repaired(const scene::Scene& scene, double tolerance) {
  repair::RepairOptions options;
  options.tolerance = geom::ToleranceRequest{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  return repair::repair(scene, {}, options);
}

/// What the second lint calls an error in the triangles that will be written, stage by stage.
inline std::vector<std::string> errors_in(const scene::ConformingModel& model, const scene::Scene& origin) {
  const scene::Scene written = scene::repaired_scene(model, origin, scene::Pieces::Triangles);
  std::vector<std::string> errors;
  for (const validate::Stage stage : {validate::Stage::Model, validate::Stage::Display}) {
    validate::LintOptions options;
    options.stage = stage;
    options.tolerance = geom::ToleranceRequest{model.tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
    for (const scene::Finding& finding : validate::lint(written, {}, options).findings) {
      if (finding.severity != scene::Severity::Error) continue;
      errors.push_back(std::string(finding.rule) + " x" + std::to_string(finding.count) + ": " + finding.message);
    }
  }
  return errors;
}

/// A triangle by its place in file units, with what it is called.
using PlacedTriangle = std::tuple<std::array<std::array<double, 3>, 3>, std::string, std::string>;

/// All triangles by place, ascending: equal for equal geometry, however it is numbered and cut into faces.
inline std::vector<PlacedTriangle> placed_triangles(const scene::ConformingModel& model, const scene::Scene& origin) {
  const auto place = [&](scene::PointId id) {
    const geom::dvec3 p = model.lattice.position(model.points[id]);
    return std::array{p.x, p.y, p.z};
  };
  std::vector<PlacedTriangle> all;
  for (const scene::ConformingFace& face : model.faces) {
    for (const auto& ids : model.triangles_of(face)) {
      std::array corners{place(ids[0]), place(ids[1]), place(ids[2])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      all.emplace_back(corners, origin.materials[face.material].name, origin.objects[face.object]);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Triangles of the result in file units.
inline std::vector<Corners3> corners_of_result(const scene::ConformingModel& model) {
  std::vector<Corners3> all;
  for (const auto& ids : model.triangles) {
    all.push_back({model.lattice.position(model.points[ids[0]]), model.lattice.position(model.points[ids[1]]),
                   model.lattice.position(model.points[ids[2]])});
  }
  return all;
}

/// Triangles of the sound faces of a scene in file units.
inline std::vector<Corners3> corners_of_input(const scene::Scene& scene, double tolerance) {
  std::string refusal;
  const geom::ToleranceRequest request{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  const auto context = validate::build_context(scene, {}, request, refusal);
  std::vector<Corners3> all;
  if (!context) return all;
  for (const auto& triangle : context->triangles.triangles) {
    all.push_back({context->position(triangle.points[0]), context->position(triangle.points[1]),
                   context->position(triangle.points[2])});
  }
  return all;
}

inline double distance_to_any(const geom::dvec3& place, const std::vector<Corners3>& triangles) {
  double least = INFINITY;
  for (const Corners3& triangle : triangles) least = std::min(least, repair::distance_to_triangle(place, triangle));
  return least;
}

/// The smallest height of a triangle.
inline double thickness(const Corners3& t) {
  const double longest = std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
  return longest > 0 ? glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / longest : 0;
}

inline geom::dvec3 centroid(const Corners3& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// How far the middle of a triangle of `from` that is thicker than `least_thickness` is from all of `to`, at most.
inline double farthest_middle(const std::vector<Corners3>& from, const std::vector<Corners3>& to,
                              double least_thickness) {
  double farthest = 0;
  for (const Corners3& triangle : from) {
    if (thickness(triangle) > least_thickness) {
      farthest = std::max(farthest, distance_to_any(centroid(triangle), to));
    }
  }
  return farthest;
}

/// How far a corner of a triangle of `from` is from all of `to`, at most.
inline double farthest_corner(const std::vector<Corners3>& from, const std::vector<Corners3>& to) {
  double farthest = 0;
  for (const Corners3& triangle : from) {
    for (const geom::dvec3& corner : triangle) farthest = std::max(farthest, distance_to_any(corner, to));
  }
  return farthest;
}

}  // namespace rad::tests
