#include "validate/terrain.h"

#include <algorithm>

namespace rad::validate {
namespace {

using geom::IntVector;
using geom::LatticePoint;
using geom::Sign;
using geom::TrianglePlane;

std::int64_t component(const IntVector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

class GroundTest {
 public:
  GroundTest(const Context& context, const LitSpace& space, std::span<const BackSide> backs)
      : context_(context), space_(space), backs_(backs) {}

  Ground run() {
    if (is_border()) return {.shape = GroundShape::Border};
    for (int axis = 0; axis < 3; ++axis) {
      if (one_height_over(axis) && reaches_the_sides(axis)) return height_field(axis);
    }
    return {};
  }

 private:
  [[nodiscard]] TrianglePlane plane(const BackSide& back) const {
    const auto& t = space_.sheets.triangles[back.triangle];
    const auto& points = context_.model.points;
    return {points[t[0]], points[t[1]], points[t[2]]};
  }

  // The plane of the largest triangle has all the backs in it and nothing of the model behind it.
  [[nodiscard]] bool is_border() const {
    const BackSide* largest = &backs_.front();
    for (const BackSide& back : backs_) {
      if (plane(back).normal_length > plane(*largest).normal_length) largest = &back;
    }
    const TrianglePlane border = plane(*largest);
    const std::int64_t tolerance = context_.tolerance.pitches;
    const Sign behind = largest->side == 0 ? Sign::Positive : Sign::Negative;
    for (const BackSide& back : backs_) {
      const bool same_way = (geom::dot(plane(back).normal, border.normal) > 0) == (back.side == largest->side);
      if (!same_way) return false;
      for (const PointId id : space_.sheets.triangles[back.triangle]) {
        if (geom::side_of_plane_within(border, context_.model.points[id], tolerance) != Sign::Zero) return false;
      }
    }
    return std::ranges::all_of(context_.model.points, [&](const LatticePoint& p) {
      return geom::side_of_plane_within(border, p, tolerance) != behind;
    });
  }

  // Along the axis, of the way the front looks.
  [[nodiscard]] std::int64_t upward(const BackSide& back, int axis) const {
    const std::int64_t n = component(plane(back).normal, axis);
    return back.side == 0 ? -n : n;
  }

  [[nodiscard]] bool one_height_over(int axis) const {
    const bool up = upward(backs_.front(), axis) > 0;
    return std::ranges::all_of(backs_, [&](const BackSide& back) {
      const std::int64_t n = upward(back, axis);
      return n != 0 && (n > 0) == up;
    });
  }

  [[nodiscard]] Ground height_field(int axis) const {
    const bool up = upward(backs_.front(), axis) > 0;
    const geom::LatticeBox box = own_box();
    const auto i = static_cast<std::size_t>(axis);
    return {GroundShape::HeightField, axis, up, up ? box.low[i] : box.high[i]};
  }

  [[nodiscard]] geom::LatticeBox own_box() const {
    std::vector<LatticePoint> own;
    for (const BackSide& back : backs_) {
      for (const PointId id : space_.sheets.triangles[back.triangle]) own.push_back(context_.model.points[id]);
    }
    return geom::box_of(own, static_cast<std::int32_t>(context_.tolerance.pitches));
  }

  [[nodiscard]] bool reaches_the_sides(int axis) const {
    const geom::LatticeBox surface = own_box();
    const geom::LatticeBox model = geom::box_of(context_.model.points);
    for (std::size_t i = 0; i < 3; ++i) {
      if (static_cast<int>(i) == axis) continue;
      if (surface.low[i] > model.low[i] || surface.high[i] < model.high[i]) return false;
    }
    return true;
  }

  const Context& context_;
  const LitSpace& space_;
  std::span<const BackSide> backs_;
};

}  // namespace

bool Ground::is_pierced_by(const Component& other) const {
  const geom::LatticePoint& end = up ? other.high : other.low;
  const std::int32_t reach = axis == 0 ? end.x : axis == 1 ? end.y : end.z;
  return up ? reach > lowest : reach < lowest;
}

Ground ground_of(const Context& context, const LitSpace& space, std::span<const BackSide> backs) {
  return GroundTest(context, space, backs).run();
}

}  // namespace rad::validate
