// One file of configuration, read and understood.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/path_glob.h"
#include "config/settings.h"
#include "report/report.h"
#include "scene/name_patterns.h"
#include "validate/stage.h"

namespace rad::config {

/// [[files]]: settings for some models.
struct FilesEntry {
  std::vector<PathPattern> files;  ///< any of them
  Settings settings;
  Origin origin;

  /// `model` is absolute and lexically normal.
  [[nodiscard]] bool fits(const std::filesystem::path& model) const;
};

/// [[objects]]: what is said of faces whose objects and materials have these names.
struct ObjectsEntry {
  scene::NamePatterns names;
  Words ignore;  ///< selectors of rules that are not reported there
  std::map<const validate::Rule*, scene::Severity> severities;
  std::map<const validate::Rule*, std::map<std::string_view, double>> thresholds;  ///< by rule and parameter
  std::string reason;
  Origin origin;
};

struct ConfigFile {
  std::filesystem::path path;                ///< absolute, lexically normal
  std::string shown;                         ///< as messages name it
  std::vector<Stated<std::string>> extends;  ///< paths as written
  std::optional<Stated<validate::Stage>> stage;
  std::optional<Stated<report::FailOn>> fail_on;
  std::vector<Stated<PathPattern>> exclude;
  Settings settings;
  std::vector<FilesEntry> files;
  std::vector<ObjectsEntry> objects;
};

/// Reads the file at `path` (absolute). Throws ConfigFault for the first thing in it that is not understood.
ConfigFile read_config_file(const std::filesystem::path& path);

/// The same of a text; `shown` stands for its path in messages.
ConfigFile config_of(std::string_view text, const std::filesystem::path& path, const std::string& shown);

/// An absolute path as messages and reports name it: from the current folder, so that it tells nothing of the machine.
std::string shown_path(const std::filesystem::path& path);

}  // namespace rad::config
