#include "mesh/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::mesh {
namespace {

using scene::ConformingFace;
using scene::ConformingModel;
using scene::PointId;

constexpr double kLeastBandPitches = 2;

geom::dvec3 doubled_area(const ConformingModel& model, const std::array<PointId, 3>& triangle) {
  const geom::dvec3 a = geom::as_vector(model.points[triangle[0]]), b = geom::as_vector(model.points[triangle[1]]),
                    c = geom::as_vector(model.points[triangle[2]]);
  return glm::cross(b - a, c - a);
}

bool is_flat(const ConformingModel& model, const ConformingFace& face) {
  geom::dvec3 normal(0, 0, 0);
  for (const auto& triangle : model.triangles_of(face)) normal += doubled_area(model, triangle);
  if (glm::length(normal) == 0) return false;
  normal = glm::normalize(normal);
  double low = 0, high = 0;
  const geom::dvec3 base = geom::as_vector(model.points[model.triangles_of(face).front()[0]]);
  for (const auto& triangle : model.triangles_of(face)) {
    for (const PointId point : triangle) {
      const double height = glm::dot(geom::as_vector(model.points[point]) - base, normal);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  const double band = std::max(kLeastBandPitches, kFlatShare * static_cast<double>(model.tolerance.pitches));
  return high - low <= 2 * band;
}

class Copier {
 public:
  Copier(const DividedModel& divided, const std::vector<bool>& kept)
      : divided_(divided), model_(divided.model), kept_(kept) {
    copy_.lattice = model_.lattice;
    copy_.tolerance = model_.tolerance;
    copy_.points = model_.points;
  }

  DividedModel run() {
    for (std::size_t i = 0; i < model_.faces.size(); ++i) {
      const ConformingFace& face = model_.faces[i];
      if (face.triangle_count == 1 || kept_[i]) {
        add_whole(face);
      } else {
        for (const auto& triangle : model_.triangles_of(face)) add_triangle(face, triangle);
      }
      origin_.resize(copy_.faces.size(), divided_.origin[i]);
    }
    return {std::move(copy_), std::move(origin_)};
  }

 private:
  void add_loop(std::span<const PointId> corners) {
    copy_.loops.push_back(
        {static_cast<std::uint32_t>(copy_.corners.size()), static_cast<std::uint32_t>(corners.size())});
    copy_.corners.insert(copy_.corners.end(), corners.begin(), corners.end());
  }

  ConformingFace begin(const ConformingFace& face) const {
    ConformingFace copy = face;
    copy.first_loop = static_cast<std::uint32_t>(copy_.loops.size());
    copy.first_inner_edge = static_cast<std::uint32_t>(copy_.inner_edges.size());
    copy.first_triangle = static_cast<std::uint32_t>(copy_.triangles.size());
    return copy;
  }

  void add_whole(const ConformingFace& face) {
    copy_.faces.push_back(begin(face));
    for (const scene::Loop& loop : model_.loops_of(face)) add_loop(model_.corners_of(loop));
    const auto inner = model_.inner_edges_of(face);
    copy_.inner_edges.insert(copy_.inner_edges.end(), inner.begin(), inner.end());
    const auto triangles = model_.triangles_of(face);
    copy_.triangles.insert(copy_.triangles.end(), triangles.begin(), triangles.end());
  }

  void add_triangle(const ConformingFace& face, const std::array<PointId, 3>& triangle) {
    ConformingFace part = begin(face);
    part.loop_count = 1;
    part.inner_edge_count = 0;
    part.triangle_count = 1;
    copy_.faces.push_back(part);
    add_loop(triangle);
    copy_.triangles.push_back(triangle);
  }

  const DividedModel& divided_;
  const ConformingModel& model_;
  const std::vector<bool>& kept_;
  ConformingModel copy_;
  std::vector<std::uint32_t> origin_;
};

}  // namespace

std::vector<bool> flat_faces(const ConformingModel& model) {
  std::vector<bool> flat;
  flat.reserve(model.faces.size());
  for (const ConformingFace& face : model.faces) flat.push_back(is_flat(model, face));
  return flat;
}

DividedModel with_triangles(const DividedModel& divided, const std::vector<bool>& kept) {
  return Copier(divided, kept).run();
}

}  // namespace rad::mesh
