// What belongs to each component of the topology.
#pragma once

#include <vector>

#include "validate/context.h"

namespace rad::validate {

struct ComponentMembers {
  std::vector<std::vector<std::uint32_t>> triangles;  ///< per component: indices into Context::triangles
  std::vector<std::vector<FaceId>> faces;             ///< per component, ascending
};

ComponentMembers members_of_components(const Context& context);

/// In pitches³, without the sign.
double volume_of(const Component& component);

/// Whether the volume is more than that of a folded sheet: than the area times T.
bool has_volume(const Context& context, const Component& component);

/// Whether the box of one lies in that of the other.
bool box_inside(const Component& inner, const Component& outer);

/// The first face by Context::precedes.
FaceId first_face(const Context& context, const std::vector<FaceId>& faces);

/// Whether a material of the faces emits light.
bool any_emits(const Context& context, const std::vector<FaceId>& faces);

}  // namespace rad::validate
