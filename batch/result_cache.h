// Results of earlier runs in a folder: found by what they were made from, checked before they are believed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/file_state.h"
#include "batch/result_pack.h"

namespace rad::batch {

/// A result as it is kept: with the states of the model and of the files beside it that it was made from, whether they
/// are there or not. Bytes that can go from one process to another.
std::string entry_of(const FileState& model, std::string_view result,
                     const std::vector<std::filesystem::path>& companions);

/// The result of an entry.
std::string_view result_of(std::string_view entry);

/// The results of the models of a folder are in one file.
class ResultCache {
 public:
  /// Files that take more than this together are thrown away, those unused for longest first.
  static constexpr std::uint64_t kUsualBytes = std::uint64_t{512} << 20;

  /// `tool` tells what made the results: those of another are not found.
  ResultCache(std::filesystem::path folder, std::string tool, std::uint64_t most_bytes = kUsualBytes);

  /// Reads the results of the folder of a model. After this has been called for all models, find() may be called from
  /// several threads.
  void open(const std::string& path) { pack_of(path); }

  /// The result of the model at `path` (as the user named it) under settings of this digest. Nothing where there is
  /// none, where it is damaged, or where the model or a companion is not as it was. Valid until save().
  [[nodiscard]] std::optional<std::string_view> find(const std::string& path, const Digest128& settings);

  void keep(const std::string& path, const Digest128& settings, std::string entry);

  /// Writes what was kept; a folder that cannot be written keeps nothing. Then throws away what is too much. Other runs
  /// may use the folder at the same time.
  void save();

 private:
  ResultPack& pack_of(const std::string& path);
  void trim() const;

  std::filesystem::path folder_;
  std::string tool_;
  std::uint64_t most_bytes_;
  std::map<std::string, std::unique_ptr<ResultPack>, std::less<>> packs_;  ///< by folder of models, as named
  bool changed_ = false;
};

}  // namespace rad::batch
