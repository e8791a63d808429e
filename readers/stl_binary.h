// Binary STL: 80 bytes of header, a count, and 50 bytes for each facet.
#pragma once

#include "readers/reader.h"

namespace rad::readers {

inline constexpr std::uint64_t kStlHeaderBytes = 84;
inline constexpr std::uint64_t kStlFacetBytes = 50;

/// The number of facets that the header states; the bytes must hold a header.
std::uint64_t stated_stl_facets(std::string_view bytes);

/// Reads the whole facets that are there. `input.bytes` may be shorter than its header states.
ReadResult read_binary_stl(const Input& input);

}  // namespace rad::readers
