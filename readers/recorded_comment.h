// The comment in which radfix records its lattice and tolerance: "radfix T=<T> h=<pitch> origin=<x> <y> <z>".
#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace rad::readers {

/// What a comment (with or without its '#') records; nothing where it is not of that form or a number is not finite.
/// Whether the record is of use for a scene is judged where its lattice model is built.
std::optional<scene::RecordedLattice> record_of_comment(std::string_view comment);

}  // namespace rad::readers
