// What lint of a written model would find between the triangles at T, beyond what triangle_lint.h finds exactly.
#pragma once

#include <vector>

#include "repair/triangle_lint.h"

namespace rad::repair {

/// Crossings and edges in faces as Contact, overlaps of the same facing as NearCoplanar; ascending. It is the search of
/// lint itself (validate/contacts.h), with every triangle as a face.
std::vector<Violation> lint_contacts(const TriangleSet& set, std::int64_t tolerance);

}  // namespace rad::repair
