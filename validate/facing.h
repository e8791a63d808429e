// Which sets of faces look away from the light: their fronts in the dark, their backs in the light.
#pragma once

#include "validate/lit_space.h"
#include "validate/orientation_sets.h"

namespace rad::validate {

using FaceSets = std::vector<std::vector<FaceId>>;

/// Whether any can: something emits, and there is an open surface, or an emitter inside of a solid. Cheap.
bool may_face_away(const Context& context);

/// Orientation sets that turning puts right, by their smallest face. Nothing where no material emits.
///
/// A set of an open surface that emits is turned over where four fifths of what its fronts see of others, by area in
/// the cells on that side, are backs, and four fifths of what its backs see are fronts. Where there is one, only such
/// sets are named: what is lit has to be found anew. Otherwise a set looks away where a back of it is in a lit cell and
/// no front of it in a cell that may be lit.
FaceSets sets_facing_away(const Context& context, const LitSpace& space);

}  // namespace rad::validate
