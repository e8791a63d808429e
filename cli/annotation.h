// The repaired model coloured by what was done to each of its faces.
#pragma once

#include <string>

#include "cli/fix_stages.h"
#include "repair/face_history.h"

namespace rad::cli {

/// Writes a GLB or glTF file with a node and a material for each sort of change and a legend in its extras. `history`
/// is that of the product; nothing where it was left as it is. Returns what went wrong, empty for nothing.
std::string write_annotation(const std::string& path, const Model& before, const Product& product,
                             const std::optional<repair::History>& history);

}  // namespace rad::cli
