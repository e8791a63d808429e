#include "writers/gltf_uri.h"

namespace rad::writers::gltf {
namespace {

void append_escaped(std::string& uri, char c) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~";
  const auto byte = static_cast<unsigned char>(c);
  if (kPlain.find(c) != std::string_view::npos) {
    uri += c;
  } else {
    uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
}

}  // namespace

std::string uri_of_name(std::string_view name) {
  std::string uri;
  for (const char c : name) append_escaped(uri, c);
  return uri;
}

std::string uri_of_path(std::string_view path) {
  constexpr std::string_view kMark = "://";
  std::string uri;
  const std::size_t mark = path.find(kMark);
  if (mark != std::string_view::npos) {
    uri = path.substr(0, mark + kMark.size());
    path.remove_prefix(uri.size());
  }
  for (const char c : path) {
    if (c == '/' || c == '\\') {
      uri += '/';
    } else {
      append_escaped(uri, c);
    }
  }
  return uri;
}

}  // namespace rad::writers::gltf
