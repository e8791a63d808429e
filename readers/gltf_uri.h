// The URIs of glTF buffers: bytes written into the document, or the escaped name of a companion file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rad::readers::gltf {

/// Decodes %XX; nothing where a percent sign is not followed by two hexadecimal digits.
std::optional<std::string> percent_decoded(std::string_view text);

/// Decodes Base64 of RFC 4648, with or without padding; nothing where another character stands in it.
std::optional<std::string> base64_decoded(std::string_view text);

/// Whether the URI carries its bytes itself ("data:").
bool is_data_uri(std::string_view uri);

/// The bytes of a "data:…;base64,…" URI; nothing where it is not one or is damaged.
std::optional<std::string> data_uri_bytes(std::string_view uri);

}  // namespace rad::readers::gltf
