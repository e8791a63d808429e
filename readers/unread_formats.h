// Formats that are known by name or first bytes but not read, so that a user is told what to do instead.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rad::readers {

/// The name of the known format ("DXF") that these first bytes, or else this path, belong to; empty where unknown.
std::string_view unread_format(std::string_view head, const std::filesystem::path& path);

/// The file's name in lower case (ASCII).
std::string lower_case_name(const std::filesystem::path& path);

}  // namespace rad::readers
