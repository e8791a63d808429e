// What a run of radlint is to do, file by file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch/digest.h"
#include "batch/worker_pool.h"
#include "cli/options.h"
#include "validate/lint.h"

namespace rad::cli {

/// How files are judged; many files share one.
struct FileSettings {
  ModelOptions model;
  validate::LintOptions lint;
  std::string configuration;  ///< path as reports name it; empty for none
  batch::Digest128 digest{};  ///< of all that the judgement of a file hangs on beside its path and content
};

/// How one file is to be judged.
struct FilePlan {
  std::string path;  ///< as the user gave it or as it was found
  std::shared_ptr<const FileSettings> settings;
};

struct RunPlan {
  std::vector<FilePlan> files;
  std::size_t jobs = 0;  ///< threads; 0: all that the machine has
  batch::TaskLimits limits;
  std::optional<std::filesystem::path> cache;        ///< folder; nothing: no cache
  bool workers = false;                              ///< worker processes may be made
  report::Detail detail = report::Detail::Drawings;  ///< what is wanted of findings, at least
};

/// All that the judgement of a file hangs on beside its path and content, as text.
std::string settings_text(const FileSettings& settings);

}  // namespace rad::cli
