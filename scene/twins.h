// Faces that radfix doubled on request: how they are marked in the model and in files.
#pragma once

#include <string>
#include <string_view>

namespace rad::scene {

/// The object of a twin is named after that of its face. Names of objects survive in OBJ and glTF; formats without them
/// lose the mark.
inline constexpr std::string_view kTwinSuffix = " (twin)";

inline std::string twin_name(std::string_view object) { return std::string(object) + std::string(kTwinSuffix); }

inline bool is_twin_name(std::string_view object) { return object.ends_with(kTwinSuffix); }

}  // namespace rad::scene
