// ASCII STL.
#pragma once

#include "readers/reader.h"

namespace rad::readers {

/// Reads solids of facets; the name of a solid becomes an object.
ReadResult read_text_stl(const Input& input);

}  // namespace rad::readers
