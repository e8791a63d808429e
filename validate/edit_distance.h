// How far a mistyped word is from one that there is.
#pragma once

#include <cstddef>
#include <string_view>

namespace rad::validate {

/// Levenshtein distance: letters put in, left out or exchanged.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace rad::validate
