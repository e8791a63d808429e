// The unit that exporters write into a comment at the head of an OBJ file: "# File units = meters", "# units: mm".
#pragma once

#include <optional>
#include <string_view>

namespace rad::readers {

/// Metres of the unit that a comment (with or without its '#') declares; nothing where it declares none that is known.
std::optional<double> metres_of_comment(std::string_view comment);

}  // namespace rad::readers
