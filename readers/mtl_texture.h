// The texture statement of MTL.
#pragma once

#include <optional>

#include "readers/text_cursor.h"
#include "scene/texture.h"

namespace rad::readers {

/// The texture of a map_Kd statement whose keyword was read: its options, then the name of the image to the end of the
/// line. Offset (-o), scale (-s) and clamping (-clamp on) are kept, the other options passed over. Nothing where no
/// name stands there. The image is not looked for.
std::optional<scene::Texture> mtl_texture(TextCursor cursor);

}  // namespace rad::readers
