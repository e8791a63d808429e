// The settings in force for a model, ready to be written.
#pragma once

#include <string>
#include <vector>

#include "cli/run_settings.h"

namespace rad::cli {

/// A setting that has one value.
struct SettingView {
  std::string name;   ///< as in radlint.toml
  std::string value;  ///< empty: what the file says, or nothing
  std::string origin;
};

struct ConfigView {
  std::string path;                ///< as the user named it
  std::vector<std::string> files;  ///< that speak of it: what is extended comes first
  std::vector<SettingView> settings;
  std::vector<SettingView> exclude;  ///< one for each pattern
  config::InForce in_force;
  config::Chain chain;  ///< keeps alive what in_force points to
};

ConfigView config_view(RunSettings& settings, const LintCommand& command, const std::string& path);

std::string config_text(const ConfigView& view);
std::string config_json(const ConfigView& view);

}  // namespace rad::cli
