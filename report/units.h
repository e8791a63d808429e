// Names of length units.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rad::report {

/// Metres in a unit by its name: m, cm, mm, in, ft. Nothing for another name.
std::optional<double> metres_in(std::string_view unit);

/// "mm" for 0.001; for a unit without a name its length in metres: "0.9144 m".
std::string unit_name(double metres_per_unit);

/// The name to print after lengths in file units: unit_name, or "units" where it is not known.
std::string unit_label(std::optional<double> metres_per_unit);

}  // namespace rad::report
