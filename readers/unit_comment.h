// The unit and up axis in a comment at the head of a text file: "# File units = meters", "# units: mm", "# up: z".
#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace rad::readers {

/// Metres of the unit that a comment (with or without its '#') declares, by a name that is known or as "0.9144 m";
/// nothing where it declares none.
std::optional<double> metres_of_comment(std::string_view comment);

/// The axis that a comment such as "up: z" or "up axis = y" declares.
scene::UpAxis up_axis_of_comment(std::string_view comment);

}  // namespace rad::readers
