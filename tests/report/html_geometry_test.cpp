#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "report/html/packed_geometry.h"
#include "tests/bake/drawn_scenes.h"

namespace rad::report::html {
namespace {

using geom::dvec3;
using tests::Facing;

/// Reads what packed() writes, as its header describes it.
class Unpacked {
 public:
  explicit Unpacked(const PackedGeometry& geometry) : geometry_(geometry) {
    uLongf size = 1 << 20;
    bytes_.resize(size);
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes_.data()), &size,
                         reinterpret_cast<const Bytef*>(geometry.bytes.data()), geometry.bytes.size()),
              Z_OK);
    bytes_.resize(size);
    const std::uint64_t vertices = number(), triangles = number();
    points.resize(vertices);
    for (int axis = 0; axis < 3; ++axis) {
      last_ = 0;
      for (dvec3& point : points) point[axis] = geometry.low[axis] + static_cast<double>(difference()) * geometry.step;
    }
    last_ = 0;
    for (std::uint64_t i = 0; i < 3 * triangles; ++i) corners.push_back(static_cast<std::uint64_t>(difference()));
    for (std::uint64_t i = 0; i < triangles; ++i) outlines.push_back(number());
    EXPECT_EQ(at_, bytes_.size()) << "nothing is left over";
  }

  std::vector<dvec3> points;
  std::vector<std::uint64_t> corners;
  std::vector<std::uint64_t> outlines;

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.at(at_++));
      value |= std::uint64_t{byte & 0x7FU} << shift;
      if (byte < 0x80) return value;
    }
  }
  std::int64_t difference() {
    const std::uint64_t coded = number();
    last_ += coded % 2 == 1 ? -static_cast<std::int64_t>((coded + 1) / 2) : static_cast<std::int64_t>(coded / 2);
    return last_;
  }

  const PackedGeometry& geometry_;
  std::string bytes_;
  std::size_t at_ = 0;
  std::int64_t last_ = 0;
};

TEST(PackedGeometry, ComesBackToHalfAStep) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const auto triangles = bake::drawn_triangles(scene);
  const PackedGeometry geometry = packed(scene, triangles);
  const Unpacked back(geometry);
  ASSERT_EQ(back.outlines.size(), triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const dvec3& wanted = scene.vertices[triangles[i].corners[j]];
      const dvec3& found = back.points.at(back.corners[3 * i + j]);
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], wanted[axis], 0.5001 * geometry.step);
      EXPECT_EQ((back.outlines[i] >> j & 1U) != 0, triangles[i].outline[j]);
    }
  }
}

TEST(PackedGeometry, HoldsNoVertexThatNoTriangleUses) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const auto triangles = bake::drawn_triangles(scene);
  const PackedGeometry geometry = packed(scene, std::span(triangles).first(1));
  const Unpacked back(geometry);
  EXPECT_EQ(back.points.size(), 3u);
}

TEST(PackedGeometry, WithoutExtentOrBeyondRange_IsStillReadable) {
  for (const double size : {0.0, 1e308}) {
    scene::SceneBuilder builder("flat.obj", "obj");
    builder.add_section({"flat.obj", "", scene::RecordKind::Line});
    tests::add_polygon(builder, {{-size, 0, 0}, {size, 0, 0}, {size, size, 0}});
    const scene::Scene scene = builder.take();
    const std::array triangle{bake::DrawnTriangle{{0, 1, 2}}};
    const PackedGeometry geometry = packed(scene, triangle);
    EXPECT_TRUE(std::isfinite(geometry.step));
    EXPECT_EQ(Unpacked(geometry).corners.size(), 3u);
  }
}

}  // namespace
}  // namespace rad::report::html
