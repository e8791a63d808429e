#include "readers/assimp/frame.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace rad::readers::assimp {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;

constexpr double kSinglePrecision = 1e-6;  ///< relative; the matrix is of floats

bool near(double a, double b) { return std::abs(a - b) <= kSinglePrecision * std::max(1.0, std::abs(b)); }

bool near(const dmat3& a, const dmat3& b) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!near(a[i][j], b[i][j])) return false;
    }
  }
  return true;
}

// (x, y, z) becomes (x, z, -y).
dmat3 z_up_to_y_up() { return {dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, 1, 0)}; }

// The shortest decimal that reads back as the float.
double decimal_of(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  return static_cast<float>(rounded) == static_cast<float>(value) && rounded > 0 ? rounded : value;
}

Frame frame_of_root(const dmat4& root, bool states_unit) {
  Frame frame;
  const dvec3 moved(root[3]);
  const double scale = glm::length(dvec3(root[0]));
  const dmat3 turn = scale > 0 ? dmat3(root) / scale : dmat3(root);
  const bool stays = moved == dvec3(0.0);
  const bool upright = near(turn, dmat3(1.0)), turned = near(turn, z_up_to_y_up());
  if (stays && scale > 0 && (upright || turned)) {
    frame.up = turned ? scene::UpAxis::Z : scene::UpAxis::Y;
    frame.metres_per_unit = decimal_of(scale);
  } else {
    frame.root = root;
    frame.up = scene::UpAxis::Y;
    frame.metres_per_unit = 1;
  }
  if (!states_unit) frame.metres_per_unit.reset();
  return frame;
}

Frame frame_of_fbx(const aiScene& scene) {
  Frame frame;
  frame.root = matrix_of(scene.mRootNode->mTransformation);
  if (scene.mMetaData == nullptr) return frame;
  double centimetres = 0;
  float single = 0;
  if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) && scene.mMetaData->Get("UnitScaleFactor", single)) {
    centimetres = single;
  }
  if (centimetres > 0 && std::isfinite(centimetres)) frame.metres_per_unit = centimetres / 100;
  std::int32_t axis = -1;
  if (scene.mMetaData->Get("UpAxis", axis) && axis == 1) frame.up = scene::UpAxis::Y;
  if (axis == 2) frame.up = scene::UpAxis::Z;
  return frame;
}

}  // namespace

dmat4 matrix_of(const aiMatrix4x4& m) {
  // assimp's matrices are by rows.
  return {glm::dvec4(m.a1, m.b1, m.c1, m.d1), glm::dvec4(m.a2, m.b2, m.c2, m.d2), glm::dvec4(m.a3, m.b3, m.c3, m.d3),
          glm::dvec4(m.a4, m.b4, m.c4, m.d4)};
}

Frame frame_of(const aiScene& scene, std::string_view format) {
  const dmat4 root = matrix_of(scene.mRootNode->mTransformation);
  if (format == "dae") return frame_of_root(root, true);
  if (format == "3ds") return frame_of_root(root, false);
  if (format == "fbx") return frame_of_fbx(scene);
  Frame frame;
  frame.root = root;
  if (format == "x3d" || format == "lwo") {
    frame.metres_per_unit = 1;
    frame.up = scene::UpAxis::Y;
  }
  return frame;
}

}  // namespace rad::readers::assimp
