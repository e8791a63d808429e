// How the files of a run are judged: what the command line says on top of what the configuration of each file says.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/file_plan.h"
#include "config/in_force.h"

namespace rad::cli {

/// All functions throw config::ConfigFault where a file of configuration is not understood.
class RunSettings {
 public:
  explicit RunSettings(const LintCommand& command);

  /// Of the model at this path, as the user named it. Models that are judged alike share one. Throws ConfigFault too
  /// where no rule is left to check.
  std::shared_ptr<const FileSettings> of(const std::string& path);

  /// The same for all models of a run, which has one stage and one --fail-on: throws ConfigFault where the
  /// configurations of two models disagree on them.
  std::vector<FilePlan> plans_of(const std::vector<std::string>& paths);

  /// Whether a file or folder below a folder of the command line is passed over (absolute, lexically normal).
  bool excludes(const std::filesystem::path& path);

  /// Of the whole run, after plans_of().
  [[nodiscard]] const config::Stated<validate::Stage>& stage() const { return stage_; }
  [[nodiscard]] const config::Stated<report::FailOn>& fail_on() const { return fail_on_; }

  /// The files of configuration of a model or a folder, and what they and the command line come to.
  const config::Chain& chain_of(const std::string& path);
  config::InForce in_force(const std::string& path);
  config::Stated<validate::Stage> stage_of(const std::string& path) { return stage_in(chain_of(path)); }
  config::Stated<report::FailOn> fail_on_of(const std::string& path) { return fail_on_in(chain_of(path)); }

 private:
  using Key = std::pair<const config::Chain*, std::vector<std::size_t>>;

  void agree(const std::string& path, const std::string& first);
  config::Stated<validate::Stage> stage_in(const config::Chain& chain) const;
  config::Stated<report::FailOn> fail_on_in(const config::Chain& chain) const;
  std::shared_ptr<const FileSettings> make(const config::Chain& chain, const std::filesystem::path& model) const;

  const LintCommand& command_;
  config::ConfigSearch search_;
  std::vector<config::PathPattern> excluded_;
  std::map<Key, std::shared_ptr<const FileSettings>> made_;
  config::Stated<validate::Stage> stage_{validate::Stage::Model};
  config::Stated<report::FailOn> fail_on_{report::FailOn::Error};
};

}  // namespace rad::cli
