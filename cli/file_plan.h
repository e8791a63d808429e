// What a run of radlint is to do, file by file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/worker_pool.h"
#include "cli/options.h"
#include "validate/lint.h"

namespace rad::cli {

/// How one file is to be judged.
struct FilePlan {
  std::string path;  ///< as the user gave it or as it was found
  ModelOptions model;
  validate::LintOptions lint;
};

struct RunPlan {
  std::vector<FilePlan> files;
  std::size_t jobs = 0;  ///< threads; 0: all that the machine has
  batch::TaskLimits limits;
  std::optional<std::filesystem::path> cache;  ///< folder; nothing: no cache
  bool workers = false;                        ///< worker processes may be made
};

/// All that the judgement of a file hangs on beside its content, as text.
std::string settings_text(const FilePlan& plan);

}  // namespace rad::cli
