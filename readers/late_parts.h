// Files that belong to the readers and are loaded or run only when a model asks for them.
#pragma once

#include <filesystem>
#include <vector>

namespace rad::readers {

/// The library that reads STEP and IGES; empty where it is nowhere or the build is without it.
std::filesystem::path step_library();

/// All of them that are there: with the program they decide what is read.
std::vector<std::filesystem::path> late_parts();

}  // namespace rad::readers
