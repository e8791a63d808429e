// What the comments at the head of a file declare: unit, up axis, and what radfix recorded.
#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace rad::readers {

/// Collects comments one by one. Of units and axes that contradict each other none is taken.
class HeadComments {
 public:
  /// With or without its mark.
  void read(std::string_view comment);

  /// Puts what was declared into the scene.
  void apply(scene::Scene& scene) const;

 private:
  std::optional<scene::RecordedLattice> recorded_;
  std::optional<double> metres_;
  scene::UpAxis up_ = scene::UpAxis::Unknown;
  bool units_differ_ = false;
  bool axes_differ_ = false;
};

}  // namespace rad::readers
