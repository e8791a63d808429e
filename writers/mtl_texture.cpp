#include "writers/mtl_texture.h"

#include "writers/text_line.h"

namespace rad::writers {
namespace {

constexpr std::uint32_t kClampToEdge = 33071;

void append_option(std::string& text, std::string_view option, const scene::dvec2& value, double otherwise) {
  if (value == scene::dvec2(otherwise)) return;
  text += option;
  for (int axis = 0; axis < 2; ++axis) {
    text += ' ';
    append_number(text, value[axis]);
  }
}

}  // namespace

void append_texture(std::string& text, const scene::Texture& texture) {
  text += "map_Kd";
  if (texture.transform) {
    // The origin of MTL is at the lower left: v here is 1 - v there.
    const scene::TextureTransform& transform = *texture.transform;
    append_option(text, " -o", {transform.offset.x, 1 - transform.scale.y - transform.offset.y}, 0);
    append_option(text, " -s", transform.scale, 1);
  }
  if (texture.sampling.wrap_s == kClampToEdge && texture.sampling.wrap_t == kClampToEdge) text += " -clamp on";
  text += ' ' + one_line(texture.image->path) + '\n';
}

}  // namespace rad::writers
