// Typed access to a JSON document of unknown quality: what has the wrong type is reported with its JSON pointer.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/read_issue.h"

namespace rad::readers {

using Json = nlohmann::json;

/// The object that a text of JSON is, which starts `offset` bytes into the file. Nothing, with a ParseError, where it
/// is none; `format` ends the sentence "so this is not …".
std::optional<Json> parse_json_object(std::string_view text, std::uint64_t offset, std::string_view format,
                                      scene::ReadIssues& issues);

/// A key as a step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key);

/// Adds a ParseError at a JSON pointer.
void add_parse_error(scene::ReadIssues& issues, std::string what, std::string pointer);

/// A JSON object and where it stands. An empty view (no object there) answers every question with "absent".
class JsonView {
 public:
  JsonView() = default;
  JsonView(const Json& object, std::string pointer, scene::ReadIssues& issues)
      : object_(&object), pointer_(std::move(pointer)), issues_(&issues) {}

  explicit operator bool() const { return object_ != nullptr; }
  /// The object itself; the view must not be empty.
  [[nodiscard]] const Json& json() const { return *object_; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }

  /// A whole number from 0; nothing where absent. Every getter reports a value of another type and answers as if it
  /// were absent.
  [[nodiscard]] std::optional<std::uint64_t> whole(std::string_view key) const;
  [[nodiscard]] std::optional<double> number(std::string_view key) const;
  [[nodiscard]] std::optional<bool> flag(std::string_view key) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  /// All numbers of an array; nothing where absent or not of exactly `count` numbers.
  [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count) const;
  /// The whole numbers of an array; others are reported and left out.
  [[nodiscard]] std::vector<std::uint64_t> wholes(std::string_view key) const;
  /// The strings of an array; others are reported and left out.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;

  [[nodiscard]] JsonView object(std::string_view key) const;
  /// Object `name` of member "extensions".
  [[nodiscard]] JsonView extension(std::string_view name) const;
  /// Member `key` of what radfix recorded, extras.radfix; null where there is none. Extras may hold anything: nothing
  /// is reported.
  [[nodiscard]] const Json* recorded(std::string_view key) const;
  /// Length of an array; 0 where absent.
  [[nodiscard]] std::size_t length(std::string_view key) const;
  /// Object `index` of an array; empty, and reported, where there is none.
  [[nodiscard]] JsonView item(std::string_view key, std::uint64_t index) const;

 private:
  [[nodiscard]] const Json* find(std::string_view key) const;
  [[nodiscard]] const Json* find_array(std::string_view key) const;
  [[nodiscard]] std::string pointer_to(std::string_view key) const;
  void report(std::string_view key, std::string_view expected) const;

  const Json* object_ = nullptr;
  std::string pointer_;
  scene::ReadIssues* issues_ = nullptr;
};

}  // namespace rad::readers
