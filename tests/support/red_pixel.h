// A picture as small as can be.
#pragma once

#include <string_view>

namespace rad::tests {

/// A PNG of one red pixel.
inline constexpr std::string_view kRedPixel(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\2\0\0\0\x90wS\xde\0\0\0\x0cIDATx\x9c"
    "c\xf8\xcf\xc0\0\0\3\1\1\0\xc9\xfe\x92\xef\0\0\0\0IEND\xae\x42`\x82",
    69);

}  // namespace rad::tests
