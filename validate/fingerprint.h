// Identity of a finding across renumbering, shuffling, moving and re-export.
#pragma once

#include <span>
#include <string>

#include "scene/finding.h"
#include "validate/context.h"

namespace rad::validate {

/// The box that places of a finding are told in: of its smallest object, which is the one that is moved about; among
/// equally large ones that of the first name. Empty where no face takes part.
geom::Box frame_of(const Context& context, std::span<const scene::FaceId> faces);

/// Sixteen hex digits over the rule, the names of objects and materials that take part, and the centre of the bounds of
/// all violations relative to where.frame, in steps of a power of two of at least 64 T and a 1024th of `frame_size`
/// (diagonal of the frame, file units): noise, moving the object as a whole and changing others keep it. Of a finding
/// without a place it is the message that counts. Steps have borders: report/matching.h compares places too.
std::string fingerprint_of(const scene::Finding& finding, double frame_size, double tolerance);

}  // namespace rad::validate
