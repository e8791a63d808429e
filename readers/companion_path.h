// Where a companion file lies that a model names. Nothing outside the model's folder is ever opened.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace rad::readers {

/// The path below `directory` that a model names, with '/' or '\' between its parts. Nothing where the name is
/// absolute, carries a drive or scheme, steps out of the folder by "..", or a link on the way leads out of it.
std::optional<std::filesystem::path> companion_path(const std::filesystem::path& directory, std::string_view name);

}  // namespace rad::readers
