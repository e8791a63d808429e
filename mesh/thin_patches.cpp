#include "mesh/thin_patches.h"

#include "geom/predicates.h"

namespace rad::mesh {
namespace {

// As lint has it: within T of the inside of the edge, or nearer than T/2 to it anywhere.
bool too_near(const geom::LatticePoint& corner, const geom::LatticePoint& from, const geom::LatticePoint& to,
              std::int64_t tolerance) {
  if (!geom::point_within_segment(corner, from, to, tolerance)) return false;
  return geom::foot_inside_segment(corner, from, to, tolerance) ||
         geom::point_within_segment(corner, from, to, tolerance / 2);
}

bool is_thin(const PatchCorners& patch, const std::vector<geom::LatticePoint>& points, std::int64_t tolerance) {
  for (std::uint32_t i = 0; i < patch.count; ++i) {
    const geom::LatticePoint &from = points[patch.point[i]], &to = points[patch.point[(i + 1) % patch.count]];
    for (std::uint32_t k = 2; k < patch.count; ++k) {
      if (too_near(points[patch.point[(i + k) % patch.count]], from, to, tolerance)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<bool> faces_with_thin_patches(const PatchSoup& soup, const std::vector<geom::LatticePoint>& points,
                                          std::size_t face_count, const geom::Tolerance& tolerance) {
  std::vector<bool> thin(face_count, false);
  for (std::size_t patch = 0; patch < soup.corners.size(); ++patch) {
    if (is_thin(soup.corners[patch], points, tolerance.pitches)) thin[soup.face[patch]] = true;
  }
  return thin;
}

}  // namespace rad::mesh
