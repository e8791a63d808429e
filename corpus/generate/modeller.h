// Modelling by hand in whole millimetres: equal places are equal vertices, and the files show few decimals.
#pragma once

#include <array>
#include <compare>
#include <map>
#include <string_view>
#include <vector>

#include "scene/scene_builder.h"

namespace rad::corpus {

struct Millimetres {
  int x = 0;
  int y = 0;
  int z = 0;

  friend auto operator<=>(const Millimetres&, const Millimetres&) = default;
};
using Ring = std::vector<Millimetres>;

/// A point of a plane, in millimetres along the first two axes of a Frame.
struct Planar {
  int u = 0;
  int v = 0;
};
using Outline = std::vector<Planar>;  ///< counter-clockwise

Outline rectangle(Planar low, Planar high);
/// A regular polygon of 16 sides rounded to millimetres; neighbouring sides turn by less than 30 degrees.
Outline round_outline(Planar centre, int radius);
Outline reversed(Outline outline);

/// A right-handed set of axes in space. `axes` are whole vectors of length `divisor`; points that would not fall on
/// whole millimetres must not be asked for.
struct Frame {
  Millimetres origin;
  std::array<Millimetres, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  int divisor = 1;

  [[nodiscard]] Millimetres at(Planar point, int n) const;
  [[nodiscard]] Ring ring(const Outline& outline, int n) const;
};

Frame plan_at(Millimetres origin);  ///< u east, v north, n up
/// The same turned counter-clockwise by the angle of the 3-4-5 triangle (53.13 degrees): take multiples of 5 mm.
Frame turned_plan_at(Millimetres origin);
Frame half_turned(Frame frame);          ///< about its third axis
Frame facing_east(Millimetres origin);   ///< u north, v up, n east
Frame facing_south(Millimetres origin);  ///< u east, v up, n south

/// Builds a scene in metres, Z up, face by face.
class Modeller {
 public:
  explicit Modeller(std::string_view name);

  void define_material(std::string_view name, const scene::dvec3& reflectance,
                       const scene::dvec3& emission = {0, 0, 0});
  /// What the faces from now on belong to and are made of.
  void begin_object(std::string_view name);
  void paint(std::string_view material);

  /// `front` runs counter-clockwise seen from the front; holes may run either way.
  void face(const Ring& front, const std::vector<Ring>& holes = {});
  /// A face on which others stand: their contours are holes of it, and what they cover are faces of its own.
  void face_with_contacts(const Ring& front, const std::vector<Ring>& contacts, std::vector<Ring> holes = {});

  [[nodiscard]] scene::Scene take();

 private:
  std::vector<scene::VertexId> vertices_of(const Ring& ring);

  scene::SceneBuilder builder_;
  std::map<Millimetres, scene::VertexId> vertices_;
  std::uint64_t records_ = 0;
};

}  // namespace rad::corpus
