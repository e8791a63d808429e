// Keys of tables: what they are called, what they say, and who reads them.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/fault.h"
#include "config/nearest.h"
#include "config/stated.h"
#include "config/toml_tree.h"

namespace rad::config {

/// The name and meaning of a key, for lists of them.
struct KeyText {
  std::string_view name;
  std::string_view what;  ///< one clause
};

/// A member of a table of the file `file`.
struct Entry {
  const Member& member;
  const std::string& file;

  [[nodiscard]] Origin origin() const { return {file, member.line}; }
  [[noreturn]] void fail(const std::string& what) const {
    throw ConfigFault(file, member.line, member.key + ": " + what);
  }

  /// Each throws ConfigFault where the value is of another kind.
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::vector<std::string> texts() const;  ///< a list of texts; one text is a list of one
  [[nodiscard]] const Value& table() const;
  [[nodiscard]] const std::vector<Value>& tables() const;  ///< an array of tables: [[name]]
};

template <typename Target>
struct Key {
  KeyText text;
  void (*read)(const Entry& entry, Target& into);
};

/// A table whose keys are read into one object or into several.
class TableReader {
 public:
  /// `name` of the table in messages; empty for the file itself.
  TableReader(const Value& table, const std::string& file, std::string_view name)
      : table_(table), file_(file), name_(name) {}

  template <typename Target>
  TableReader& read(std::span<const Key<Target>> keys, Target& into) {
    for (const Key<Target>& key : keys) known_.push_back(key.text.name);
    for (const Member& member : table_.members) {
      const auto key = std::ranges::find(keys, member.key, [](const Key<Target>& it) { return it.text.name; });
      if (key != keys.end()) key->read({member, file_}, into);
    }
    return *this;
  }

  /// Throws ConfigFault for a key that none of the calls before has read, with the nearest that there is.
  void refuse_others() const;

 private:
  const Value& table_;
  const std::string& file_;
  std::string_view name_;
  std::vector<std::string_view> known_;
};

}  // namespace rad::config
