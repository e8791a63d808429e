// The program on Node.js that reads IFC.
#pragma once

#include <filesystem>

namespace rad::readers {

/// Where it lies: $RAD_IFC_HELPER, beside the installed files, or in the sources. Empty where it is nowhere.
std::filesystem::path ifc_helper();

}  // namespace rad::readers
