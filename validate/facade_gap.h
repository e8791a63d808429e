// The narrowest place between the rim of an open component and anything else that it does not touch there.
#pragma once

#include "geom/box_tree.h"
#include "validate/context.h"

namespace rad::validate {

class FacadeGaps {
 public:
  /// `context` must outlive it.
  explicit FacadeGaps(const Context& context);

  /// Nothing where nothing comes within kGapReach T of the rim. Ties go to the place that comes first in space.
  [[nodiscard]] std::optional<Gap> narrowest(std::uint32_t component) const;

 private:
  void measure(const Subedge& subedge, std::optional<Gap>& best) const;

  const Context& context_;
  geom::BoxTree tree_;                            ///< of Context::triangles
  std::vector<std::vector<std::uint32_t>> rims_;  ///< per component: its open subedges
};

}  // namespace rad::validate
