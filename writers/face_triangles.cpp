#include "writers/face_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::writers {
namespace {

using geom::dvec3;
using Quad = std::array<dvec3, 4>;

// Cosines that differ by less are equal: far above the rounding of a cosine (2^-50), far below what an eye can tell.
constexpr double kCosineTie = 0x1p-40;

/// The halves of a quad on both sides of the diagonal from corner `first`.
struct Halves {
  std::array<std::array<std::size_t, 3>, 2> corners;

  explicit Halves(std::size_t first)
      : corners{{{first, (first + 1) % 4, (first + 2) % 4}, {first, (first + 2) % 4, (first + 3) % 4}}} {}
};

// Of the smallest angle; above 1 where a half is without area or turned against `normal`.
double largest_cosine(const Quad& quad, const Halves& halves, const dvec3& normal) {
  double largest = -1;
  for (const auto& half : halves.corners) {
    const dvec3 &a = quad[half[0]], &b = quad[half[1]], &c = quad[half[2]];
    if (!(glm::dot(glm::cross(b - a, c - a), normal) > 0)) return 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3 to_next = quad[half[(i + 1) % 3]] - quad[half[i]];
      const dvec3 to_last = quad[half[(i + 2) % 3]] - quad[half[i]];
      const double lengths = std::sqrt(glm::dot(to_next, to_next) * glm::dot(to_last, to_last));
      largest = std::max(largest, glm::dot(to_next, to_last) / lengths);
    }
  }
  return largest;
}

bool precedes(const dvec3& a, const dvec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// The corner that the better diagonal starts from, 0 or 1; nothing where neither diagonal is sound.
std::optional<std::size_t> better_diagonal(const Quad& quad) {
  const dvec3 normal = glm::cross(quad[2] - quad[0], quad[3] - quad[1]);
  const double even = largest_cosine(quad, Halves(0), normal);
  const double odd = largest_cosine(quad, Halves(1), normal);
  if (std::min(even, odd) > 1.5) return std::nullopt;
  if (std::abs(even - odd) >= kCosineTie) return even < odd ? 0 : 1;
  return static_cast<std::size_t>(std::min_element(quad.begin(), quad.end(), precedes) - quad.begin()) % 2;
}

}  // namespace

std::optional<FaceTriangles> triangles_of(const scene::Scene& scene, const scene::Face& face) {
  const scene::Loop& loop = scene.loops[face.first_loop];
  const auto corners = scene.corners_of(loop);
  if (face.loop_count != 1 || corners.size() < 3 || corners.size() > 4) return std::nullopt;
  if (corners.size() == 3) return FaceTriangles{{{{loop.first, loop.first + 1, loop.first + 2}}}, 1};
  Quad quad;
  std::ranges::transform(corners, quad.begin(), [&](scene::VertexId id) { return scene.vertices[id]; });
  const auto first = better_diagonal(quad);
  if (!first) return std::nullopt;
  FaceTriangles result;
  for (const auto& half : Halves(*first).corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.triangles[result.count][i] = loop.first + static_cast<std::uint32_t>(half[i]);
    }
    ++result.count;
  }
  return result;
}

std::string unsplit_face(scene::FaceId id) {
  return "face " + std::to_string(id) + " is neither a triangle nor a convex quad; the format holds triangles only";
}

}  // namespace rad::writers
