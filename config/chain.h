// The files of configuration that speak of a model, and where they are found.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/config_file.h"

namespace rad::config {

/// A file and all that it builds on: what others extend comes before them, so that later ones win.
using Chain = std::vector<std::shared_ptr<const ConfigFile>>;

/// At most so many files extend each other in a row, and are read for one model.
inline constexpr std::size_t kLongestChain = 16;
inline constexpr std::size_t kMostFiles = 64;

/// Reads a file (absolute path) and all that it extends. Throws ConfigFault, also where files extend each other in a
/// circle or go beyond the limits above.
Chain read_chain(const std::filesystem::path& path);

/// Names that are looked for in a folder; the first that is there counts.
inline constexpr std::string_view kConfigNames[] = {"radlint.toml", ".radlint.toml"};

/// Finds the configuration of models: the nearest file in the folder of the model or one above it. Every folder is
/// looked at once, every file read once.
class ConfigSearch {
 public:
  /// `only`, where it is not empty, is the file for all models; `isolated`: none has any.
  explicit ConfigSearch(const std::filesystem::path& only = {}, bool isolated = false);

  /// Of the models in a folder (absolute, lexically normal); empty where there is none. Throws ConfigFault.
  const Chain& of_folder(const std::filesystem::path& folder);

 private:
  std::shared_ptr<const Chain> found_from(const std::filesystem::path& folder);

  std::shared_ptr<const Chain> everywhere_;  ///< null: it is searched for
  std::map<std::string, std::shared_ptr<const Chain>, std::less<>> of_folder_;
};

/// Whether one of the chain's `exclude` patterns covers the path (absolute, lexically normal).
bool excludes(const Chain& chain, const std::filesystem::path& path);

}  // namespace rad::config
