// Holds JSON against the part of JSON Schema draft-07 that report.schema.json uses. A keyword that it does not know is
// a fault of its own, so that no part of the schema goes unchecked.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rad::report {

class SchemaChecker {
 public:
  explicit SchemaChecker(const nlohmann::json& schema) : root_(schema) {}

  /// Faults, each with the place of the value; empty for a valid value.
  std::vector<std::string> faults(const nlohmann::json& value) const;

 private:
  using Json = nlohmann::json;
  using Faults = std::vector<std::string>;

  void check(const Json& value, const Json& schema, const std::string& at, Faults& faults) const;
  void check_keyword(const std::string& keyword, const Json& rule, const Json& value, const std::string& at,
                     Faults& faults) const;
  void check_object(const Json& value, const Json& schema, const std::string& at, Faults& faults) const;

  const Json& root_;
};

}  // namespace rad::report
