// Results of earlier runs in a folder: found by what they were made from, checked before they are believed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rad::batch {

class ResultCache {
 public:
  /// Entries of a folder that take more than this together are thrown away, those unused for longest first.
  static constexpr std::uint64_t kUsualBytes = std::uint64_t{512} << 20;

  explicit ResultCache(std::filesystem::path folder, std::uint64_t most_bytes = kUsualBytes);

  /// The result kept under this key (hex digits). Nothing where there is none, where it is damaged, or where one of the
  /// companions that it was made from is not as it was.
  [[nodiscard]] std::optional<std::string> find(const std::string& key) const;

  /// Keeps a result, with the files beside its model that it hangs on, whether they exist or not. Appears in full or
  /// not at all; a folder that cannot be written keeps nothing.
  void keep(const std::string& key, std::string_view result,
            const std::vector<std::filesystem::path>& companions) const;

  /// Throws away what is too much. Other runs may use the folder at the same time.
  void trim() const;

 private:
  [[nodiscard]] std::filesystem::path path_of(const std::string& key) const;

  std::filesystem::path folder_;
  std::uint64_t most_bytes_;
};

}  // namespace rad::batch
