// Writing a model between two filters as a stage file (docs/stage-format.md).
#pragma once

#include <filesystem>
#include <string>

#include "writers/model.h"

namespace rad::writers {

/// The text of a stage file. Returns what keeps the output from being one: it has no stage record, no lattice, or a
/// vertex that is not on the lattice.
std::string stage_text(const Output& output, std::string& text);

WriteResult write_stage(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
