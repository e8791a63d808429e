// Which closed component a component lies in.
#pragma once

#include <cstdint>
#include <vector>

namespace rad::validate {

struct Context;

/// Per component the smallest closed component with volume that all of it lies in; kNoComponent where there is none.
/// Exact rays along an axis, from the middles of its first and its last triangle by place, decide by parity: what
/// crosses the wall of another, or touches it with one of the two, is in none by it. Computed on first use and kept
/// with the context. Models in which no box of a component lies in that of a closed one cost next to nothing.
const std::vector<std::uint32_t>& enclosing_components(const Context& context);

}  // namespace rad::validate
