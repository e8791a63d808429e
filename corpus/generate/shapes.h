// Shapes over an outline: panels across an axis, sides along it, and the solids made of them.
#pragma once

#include "corpus/generate/modeller.h"

namespace rad::corpus {

enum class Facing { Along, Against };  ///< the third axis of the frame

/// The outline at height `n`.
void panel(Modeller& modeller, const Frame& frame, const Outline& outline, int n, Facing facing,
           const std::vector<Ring>& holes = {});
void panel_with_contacts(Modeller& modeller, const Frame& frame, const Outline& outline, int n, Facing facing,
                         const std::vector<Ring>& contacts, const std::vector<Ring>& holes = {});

/// The side over the edge from `a` to `b` between two heights; its front is to the right of the edge.
Ring side(const Frame& frame, Planar a, Planar b, int low, int high);
/// Sides over all edges: fronts outside; of a reversed outline, inside.
void sides(Modeller& modeller, const Frame& frame, const Outline& outline, int low, int high);

/// A closed solid over the outline; `low_holes` and `high_holes` are where others of its parts take over.
void prism(Modeller& modeller, const Frame& frame, const Outline& outline, int low, int high,
           const std::vector<Ring>& low_holes = {}, const std::vector<Ring>& high_holes = {});

}  // namespace rad::corpus
