// Modelling as a CAD program exports it: boxes that stand through one another, walls cut into rectangles whose corners
// do not meet, sheets laid on what they lie on. Broken on purpose, in the ways that repair is for.
#pragma once

#include <map>
#include <string>

#include "corpus/generate/shapes.h"
#include "corpus/random.h"

namespace rad::corpus {

/// An opening of a wall, in millimetres along it and above its foot.
struct Opening {
  Planar low;
  Planar high;
};

/// A place to put a thing: its frame is a plan, u to its right, v to its back.
class Exporter {
 public:
  explicit Exporter(std::string_view name, std::uint64_t seed) : modeller_(name), random_(seed) {}

  [[nodiscard]] Modeller& modeller() { return modeller_; }
  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] scene::Scene take() { return modeller_.take(); }

  /// The next object of its kind: "chair_7".
  void begin(std::string_view kind);
  void paint(std::string_view material) { modeller_.paint(material); }

  /// Six faces. `low` and `high` are in the frame.
  void box(const Frame& frame, const Millimetres& low, const Millimetres& high);
  /// A square post.
  void post(const Frame& frame, Planar corner, int thickness, int low, int high);
  /// An upright cylinder of 16 sides.
  void column(const Frame& frame, Planar centre, int radius, int low, int high);
  /// One face alone, nothing behind it: a facade.
  void sheet(const Frame& frame, Planar low, Planar high, int n) {
    panel(modeller_, frame, rectangle(low, high), n, Facing::Along);
  }
  /// A horizontal slab with rectangular openings, its top and bottom cut into strips along v at the openings.
  void slab(const Frame& frame, Planar size, const std::vector<Opening>& openings, int low, int high);
  /// An upright wall from the frame's origin along its u axis, `thickness` to its left, with the reveals of openings.
  void wall(const Frame& plan, int length, int thickness, int height, const std::vector<Opening>& openings);

 private:
  void cut_sheet(const Frame& frame, Planar size, const std::vector<Opening>& openings, int n, Facing facing);

  Modeller modeller_;
  Random random_;
  std::map<std::string, int, std::less<>> counts_;
};

/// Turned counter-clockwise about its third axis by right angles.
Frame turned(Frame frame, int right_angles);
/// The frame with its origin moved to a place of itself.
Frame moved(const Frame& frame, Planar place, int n = 0);
/// Of a plan: u stays, v goes up, n towards the viewer who stands before it.
Frame upright(const Frame& plan);

}  // namespace rad::corpus
