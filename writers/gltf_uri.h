// Names of files as URIs.
#pragma once

#include <string>
#include <string_view>

namespace rad::writers::gltf {

/// Everything but the letters, digits and marks that a URI holds as they are (RFC 3986, unreserved) as %XX.
std::string uri_of_name(std::string_view name);

/// The same for a path: '/' and '\' part its names, and a scheme with "://" stays.
std::string uri_of_path(std::string_view path);

}  // namespace rad::writers::gltf
