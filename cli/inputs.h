// The model files that a list of files and folders stands for.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rad::cli {

struct InputFiles {
  std::vector<std::string> paths;
  std::string
      problem;  ///< a path that does not exist or a folder that cannot be searched; then nothing is to be judged
};

/// Files stand for themselves, whatever their suffix; folders for all files below them, sorted by path, that have a
/// suffix of a model format. Folders and files whose names begin with a dot are passed over; links to folders are not
/// followed. What `is_excluded` (asked with absolute paths) is true of is passed over in folders, with all that is
/// below. A path that occurs twice is taken once.
InputFiles collect_inputs(std::span<const std::string> paths,
                          const std::function<bool(const std::filesystem::path&)>& is_excluded);

}  // namespace rad::cli
