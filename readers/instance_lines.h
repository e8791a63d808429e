// Where the instances of a STEP file stand, which IFC files are too (ISO 10303-21).
#pragma once

#include <cstdint>
#include <map>
#include <string_view>

namespace rad::readers {

/// The 1-based line of every instance that begins a line, "#12 = …", by its number.
std::map<std::uint64_t, std::uint64_t> lines_of_instances(std::string_view text);

}  // namespace rad::readers
