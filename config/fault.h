// What is wrong with a configuration.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace rad::config {

/// A file of configuration that cannot be used. what(): "radlint.toml:3: unknown key 'selct'; did you mean select?"
class ConfigFault : public std::runtime_error {
 public:
  /// `line` is 1-based, 0 for the file as a whole; `what` a clause without a full stop.
  ConfigFault(const std::string& file, std::uint64_t line, const std::string& what);

  [[nodiscard]] std::uint64_t line() const { return line_; }
  /// The clause alone.
  [[nodiscard]] const std::string& clause() const { return clause_; }

 private:
  std::uint64_t line_ = 0;
  std::string clause_;
};

}  // namespace rad::config
