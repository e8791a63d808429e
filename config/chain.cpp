#include "config/chain.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/fault.h"

namespace rad::config {

namespace {

namespace fs = std::filesystem;

class ChainReader {
 public:
  void read(const fs::path& path, const Stated<std::string>* named) {
    refuse_what_has_no_end(path, named);
    if (std::error_code error; named != nullptr && !fs::is_regular_file(path, error)) {
      throw ConfigFault(named->origin.source, named->origin.line,
                        fmt::format("extend: there is no file '{}'", named->value));
    }
    auto file = std::make_shared<const ConfigFile>(read_config_file(path));
    being_read_.push_back(path);
    for (const Stated<std::string>& extended : file->extends) {
      read((path.parent_path() / extended.value).lexically_normal(), &extended);
    }
    being_read_.pop_back();
    chain.push_back(std::move(file));
  }

  Chain chain;

 private:
  void refuse_what_has_no_end(const fs::path& path, const Stated<std::string>* named) {
    if (named == nullptr) return;
    const auto fail = [&](const std::string& what) {
      throw ConfigFault(named->origin.source, named->origin.line, "extend: " + what);
    };
    const auto same_file = [&](const fs::path& other) {
      std::error_code error;
      return path == other || fs::equivalent(path, other, error);
    };
    if (std::ranges::any_of(being_read_, same_file)) {
      fail(fmt::format("'{}' is extended by itself: {}", named->value, circle()));
    }
    if (being_read_.size() >= kLongestChain) fail(fmt::format("more than {} files in a row", kLongestChain));
    if (++files_ >= kMostFiles) fail(fmt::format("more than {} files", kMostFiles));
  }

  [[nodiscard]] std::string circle() const {
    std::string text;
    for (const fs::path& path : being_read_) text += (text.empty() ? "" : " extends ") + shown_path(path);
    return text;
  }

  std::vector<fs::path> being_read_;
  std::size_t files_ = 0;
};

}  // namespace

Chain read_chain(const fs::path& path) {
  ChainReader reader;
  reader.read(path, nullptr);
  return std::move(reader.chain);
}

ConfigSearch::ConfigSearch(const fs::path& only, bool isolated) {
  if (isolated) {
    everywhere_ = std::make_shared<const Chain>();
  } else if (!only.empty()) {
    everywhere_ = std::make_shared<const Chain>(read_chain(fs::absolute(only).lexically_normal()));
  }
}

const Chain& ConfigSearch::of_folder(const fs::path& folder) {
  if (everywhere_) return *everywhere_;
  const auto known = of_folder_.find(folder.native());
  return *(known != of_folder_.end() ? known->second : found_from(folder));
}

std::shared_ptr<const Chain> ConfigSearch::found_from(const fs::path& folder) {
  if (const auto known = of_folder_.find(folder.native()); known != of_folder_.end()) return known->second;
  std::shared_ptr<const Chain> chain;
  for (const std::string_view name : kConfigNames) {
    std::error_code error;
    if (chain || !fs::is_regular_file(folder / name, error)) continue;
    chain = std::make_shared<const Chain>(read_chain(folder / name));
  }
  if (!chain) {
    const bool top = !folder.has_relative_path();
    chain = top ? std::make_shared<const Chain>() : found_from(folder.parent_path());
  }
  return of_folder_.emplace(folder.native(), std::move(chain)).first->second;
}

bool excludes(const Chain& chain, const fs::path& path) {
  return std::ranges::any_of(chain, [&](const std::shared_ptr<const ConfigFile>& file) {
    return std::ranges::any_of(file->exclude,
                               [&](const Stated<PathPattern>& pattern) { return pattern.value.covers(path); });
  });
}

}  // namespace rad::config
