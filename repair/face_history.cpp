#include "repair/face_history.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "geom/box_tree.h"
#include "repair/distance.h"
#include "scene/scene_sources.h"
#include "validate/face_triangles.h"

namespace rad::repair {
namespace {

using geom::LatticePoint;
using scene::ConformingFace;
using scene::FaceId;
using Corners = std::array<dvec3, 3>;

// Points that are made where faces meet are rounded to the lattice: up to half the diagonal of its cell, √3/2.
constexpr double kRounding = 1;  // pitches
// The search for the nearest triangle starts with this reach and doubles it.
constexpr std::int32_t kFirstReach = 8;  // T

struct Farthest {
  double distance = 0;  ///< pitches
  dvec3 at{0, 0, 0};    ///< pitches
};

class Historian {
 public:
  Historian(const scene::Scene& input, const scene::ConformingModel& model)
      : input_(input),
        model_(model),
        lattice_model_(scene::build_lattice_model(input)),
        triangles_(validate::triangulate_faces(input, lattice_model_, model.tolerance)) {}

  History run() {
    index_input();
    history_.faces.resize(model_.faces.size());
    follow_result();
    mark_cut_and_gone();
    follow_input();
    gather_regions();
    return std::move(history_);
  }

 private:
  [[nodiscard]] Corners input_corners(std::size_t triangle) const {
    const auto& ids = triangles_.triangles[triangle].points;
    return {geom::as_vector(lattice_model_.points[ids[0]]), geom::as_vector(lattice_model_.points[ids[1]]),
            geom::as_vector(lattice_model_.points[ids[2]])};
  }
  [[nodiscard]] Corners result_corners(std::size_t triangle) const {
    const auto& ids = model_.triangles[triangle];
    return {geom::as_vector(model_.points[ids[0]]), geom::as_vector(model_.points[ids[1]]),
            geom::as_vector(model_.points[ids[2]])};
  }
  [[nodiscard]] dvec3 place(const dvec3& pitches) const {
    return model_.lattice.origin + model_.lattice.pitch * pitches;
  }

  void index_input() {
    first_.assign(input_.faces.size() + 1, 0);
    for (const auto& triangle : triangles_.triangles) ++first_[triangle.face + 1];
    for (std::size_t face = 0; face < input_.faces.size(); ++face) first_[face + 1] += first_[face];
  }

  // How far a triangle of the result is from the nearest of its source; where that has none, nothing is known.
  [[nodiscard]] Farthest distance_to_source(const Corners& corners, FaceId source) const {
    Farthest best{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t i = first_[source]; i < first_[source + 1]; ++i) {
      const Corners from = input_corners(i);
      Farthest farthest;
      for (const dvec3& corner : corners) {
        const double distance = distance_to_triangle(corner, from);
        if (distance >= farthest.distance) farthest = {distance, corner};
      }
      if (farthest.distance < best.distance) best = farthest;
    }
    return first_[source] == first_[source + 1] ? Farthest{} : best;
  }

  void follow_result() {
    moves_.resize(model_.triangles.size());
    tbb::parallel_for(std::size_t{0}, model_.faces.size(), [&](std::size_t id) { follow_face(id); });
    for (const Farthest& move : moves_) history_.result_to_input = std::max(history_.result_to_input, length(move));
  }

  void follow_face(std::size_t id) {
    const ConformingFace& face = model_.faces[id];
    FaceHistory& history = history_.faces[id];
    history.sources = scene::source_faces(model_, face);
    Farthest farthest;
    for (std::uint32_t i = face.first_triangle; i < face.first_triangle + face.triangle_count; ++i) {
      const scene::TriangleOrigin& origin = model_.origins[i];
      const Corners corners = result_corners(i);
      const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      history.turned = history.turned || glm::dot(normal, triangles_.normal[origin.source]) < 0;
      history.won = history.won || origin.won;
      moves_[i] = distance_to_source(corners, origin.source);
      if (moves_[i].distance > farthest.distance) farthest = moves_[i];
    }
    if (farthest.distance <= kRounding) return;
    history.moved = length(farthest);
    history.moved_at = place(farthest.at);
  }

  [[nodiscard]] double length(const Farthest& move) const { return move.distance * model_.lattice.pitch; }

  void mark_cut_and_gone() {
    std::vector<std::uint32_t> faces_of(input_.faces.size(), 0);
    for (const FaceHistory& face : history_.faces) {
      for (const FaceId source : face.sources) ++faces_of[source];
    }
    for (std::size_t id = 0; id < history_.faces.size(); ++id) {
      FaceHistory& face = history_.faces[id];
      face.cut = std::ranges::any_of(face.sources, [&](FaceId source) { return faces_of[source] > 1; });
      face.divided = !face.cut && !face.merged() && corners_of(model_.faces[id]) > corners_of(face.sources.front());
    }
    for (FaceId face = 0; face < faces_of.size(); ++face) {
      if (faces_of[face] == 0) history_.gone.push_back(face);
    }
  }

  [[nodiscard]] std::size_t corners_of(const ConformingFace& face) const {
    std::size_t count = 0;
    for (const scene::Loop& loop : model_.loops_of(face)) count += loop.count;
    return count;
  }
  [[nodiscard]] std::size_t corners_of(FaceId face) const {
    std::set<std::uint32_t> corners;
    for (const scene::Loop& loop : input_.loops_of(input_.faces[face])) {
      const auto of_loop = input_.corners_of(loop);
      corners.insert(of_loop.begin(), of_loop.end());
    }
    return corners.size();
  }

  void follow_input() {
    if (model_.triangles.empty()) return;
    std::vector<geom::LatticeBox> boxes;
    boxes.reserve(model_.triangles.size());
    for (const auto& ids : model_.triangles) {
      const std::array points{model_.points[ids[0]], model_.points[ids[1]], model_.points[ids[2]]};
      boxes.push_back(geom::box_of(points));
    }
    const geom::BoxTree tree(std::move(boxes));
    left_.resize(triangles_.triangles.size());
    tbb::parallel_for(std::size_t{0}, left_.size(), [&](std::size_t i) {
      const Corners corners = input_corners(i);
      for (const dvec3& probe : {corners[0], corners[1], corners[2], (corners[0] + corners[1] + corners[2]) / 3.0}) {
        const double distance = distance_to_result(probe, tree);
        if (distance > left_[i].distance) left_[i] = {distance, probe};
      }
    });
    for (const Farthest& move : left_) history_.input_to_result = std::max(history_.input_to_result, length(move));
  }

  [[nodiscard]] double distance_to_result(const dvec3& probe, const geom::BoxTree& tree) const {
    for (std::int64_t reach = kFirstReach * model_.tolerance.pitches;; reach *= 2) {
      const auto clamped = static_cast<std::int32_t>(std::min<std::int64_t>(reach, 4 * geom::kLatticeLimit));
      geom::LatticeBox box;
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        box.low[k] = static_cast<std::int32_t>(std::floor(probe[axis])) - clamped;
        box.high[k] = static_cast<std::int32_t>(std::ceil(probe[axis])) + clamped;
      }
      double least = std::numeric_limits<double>::infinity();
      tree.for_each_meeting(box, [&](std::uint32_t triangle) {
        least = std::min(least, distance_to_triangle(probe, result_corners(triangle)));
      });
      if (least <= clamped || clamped == 4 * geom::kLatticeLimit) return least;
    }
  }

  void gather_regions() {
    const double allowed = kFarthestMove * static_cast<double>(model_.tolerance.pitches);
    std::vector<Farthest> beyond;
    for (const auto* moves : {&moves_, &left_}) {
      std::ranges::copy_if(*moves, std::back_inserter(beyond),
                           [&](const Farthest& move) { return move.distance > allowed; });
    }
    std::ranges::sort(beyond, [](const Farthest& a, const Farthest& b) {
      return std::tuple(-a.distance, a.at.x, a.at.y, a.at.z) < std::tuple(-b.distance, b.at.x, b.at.y, b.at.z);
    });
    const double reach = kRegionReach * model_.tolerance.length;
    for (const Farthest& move : beyond) {
      const dvec3 at = place(move.at);
      const auto region = std::ranges::find_if(
          history_.far, [&](const FarRegion& known) { return glm::distance(known.at, at) <= reach; });
      if (region != history_.far.end()) {
        ++region->places;
      } else {
        history_.far.push_back({at, length(move), 1});
      }
    }
  }

  const scene::Scene& input_;
  const scene::ConformingModel& model_;
  scene::LatticeModel lattice_model_;
  validate::FaceTriangles triangles_;
  std::vector<std::size_t> first_;  ///< per face of the input: its first triangle; one more than there are faces
  std::vector<Farthest> moves_;     ///< per triangle of the result
  std::vector<Farthest> left_;      ///< per triangle of the input
  History history_;
};

}  // namespace

History history_of(const scene::Scene& input, const scene::ConformingModel& model) {
  return Historian(input, model).run();
}

}  // namespace rad::repair
