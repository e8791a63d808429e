// Who uses a material, for rules that judge materials and not faces.
#pragma once

#include <functional>
#include <vector>

#include "validate/context.h"
#include "validate/rule.h"

namespace rad::validate {

/// Calls visit(material, face) for every material in use that `at_fault` holds for, where `face` is the one to show it
/// by: that with the least corner by place, whatever the order of the faces. Linear in the faces where any material is
/// at fault, in the materials else.
void for_each_material_at_fault(const Context& context, const std::function<bool(const scene::Material&)>& at_fault,
                                const std::function<void(const scene::Material&, FaceId)>& visit);

/// A violation by a material, of the one finding that there is for all of them.
Violation material_violation(const Context& context, FaceId face, double measure = 0);

/// The largest of the channels of a colour.
double brightest(const dvec3& colour);

}  // namespace rad::validate
