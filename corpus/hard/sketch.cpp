#include "corpus/hard/sketch.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "scene/scene_builder.h"

namespace rad::corpus {

Corners rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

Corners reversed(const Corners& corners) { return {corners.rbegin(), corners.rend()}; }

glm::dmat3 about_z(double angle) {
  return {{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
}

// Numbers are drawn one statement each: compilers differ in the order in which they evaluate arguments.
dvec3 HardSketch::anywhere(double extent) {
  const double x = random_.real(0, extent), y = random_.real(0, extent);
  return {x, y, random_.real(0, extent)};
}

dvec3 HardSketch::noise_vector(double share) {
  const double x = noise(share), y = noise(share);
  return {x, y, noise(share)};
}

glm::dmat3 HardSketch::rotation() {
  while (true) {
    const double w = random_.real(-1, 1), x = random_.real(-1, 1), y = random_.real(-1, 1);
    const glm::dquat q(w, x, y, random_.real(-1, 1));
    const double squared = glm::dot(q, q);
    if (squared > 0.01 && squared < 1) return glm::mat3_cast(glm::normalize(q));
  }
}

void HardSketch::add_with_holes(Corners outer, std::vector<Corners> holes, int material) {
  faces_.push_back({std::move(outer), std::move(holes), material});
}

void HardSketch::add_either_way(const Corners& corners) {
  const bool turned = random_.one_in(3);
  add(turned ? reversed(corners) : corners, material());
}

void HardSketch::add_maybe_cut(const Corners& quad, int material) {
  if (!random_.one_in(3)) return add(quad, material);
  add({quad[0], quad[1], quad[2]}, material);
  add({quad[0], quad[2], quad[3]}, material);
}

void HardSketch::box(const dvec3& low, const dvec3& high, int material) {
  const auto corner = [&](unsigned bits) {
    return dvec3(bits & 1U ? high.x : low.x, bits & 2U ? high.y : low.y, bits & 4U ? high.z : low.z);
  };
  constexpr std::array<std::array<unsigned, 4>, 6> kSides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& side : kSides) {
    add_maybe_cut({corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])}, material);
  }
}

void HardSketch::tube(const dvec3& centre, double radius, double half_length, int sides, int material) {
  const double start = random_.unit();
  const auto at = [&](int i, double z) {
    const double angle = start + 2 * std::numbers::pi * i / sides;
    return centre + dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < sides; ++i) {
    add_maybe_cut({at(i, -half_length), at(i + 1, -half_length), at(i + 1, half_length), at(i, half_length)}, material);
  }
}

void HardSketch::transform(std::size_t first, const glm::dmat3& turn, const dvec3& by) {
  for (std::size_t i = first; i < faces_.size(); ++i) {
    for (dvec3& p : faces_[i].outer) p = turn * p + by;
    for (Corners& hole : faces_[i].holes) {
      for (dvec3& p : hole) p = turn * p + by;
    }
  }
}

void HardSketch::turn_freely(std::size_t first) {
  const glm::dmat3 turn = rotation();
  transform(first, turn, anywhere(1));
}

void HardSketch::maybe_turn(std::size_t first) {
  if (random_.one_in(2)) turn_freely(first);
}

void HardSketch::turn_somehow(std::size_t first) {
  const int way = random_.between(0, 2);
  if (way == 1) transform(first, {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}, {0, 0, 0});
  if (way == 2) turn_freely(first);
}

void HardSketch::copy(std::size_t first, const dvec3& by) {
  const std::size_t last = faces_.size();
  for (std::size_t i = first; i < last; ++i) faces_.push_back(SketchFace(faces_[i]));
  transform(last, glm::dmat3(1), by);
}

scene::Scene HardSketch::scene() const {
  scene::SceneBuilder builder("scene.obj", "obj");
  builder.add_section({"scene.obj", "", scene::RecordKind::Line});
  builder.use_object(builder.object("scene"));
  const auto vertices = [&](const Corners& corners) {
    std::vector<scene::VertexId> ids;
    for (const dvec3& p : corners) ids.push_back(builder.add_vertex(p));
    return ids;
  };
  for (const SketchFace& face : faces_) {
    builder.use_material(builder.material("material" + std::to_string(face.material)));
    builder.add_face(vertices(face.outer), builder.scene().faces.size() + 1);
    for (const Corners& hole : face.holes) builder.add_hole(vertices(hole));
  }
  return builder.take();
}

}  // namespace rad::corpus
