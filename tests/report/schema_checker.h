// Holds JSON against the part of JSON Schema draft-07 that the published schemas use. A keyword that it does not know
// is a fault of its own, so that no part of a schema goes unchecked. "$ref" reaches into the same file or one beside
// it.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rad::report {

class SchemaChecker {
 public:
  /// Reads report/<file>, and every schema that it refers to.
  explicit SchemaChecker(const std::string& file);

  /// Faults, each with the place of the value; empty for a valid value.
  std::vector<std::string> faults(const nlohmann::json& value) const;

 private:
  using Json = nlohmann::json;
  using Faults = std::vector<std::string>;

  /// A schema and the file that its references start from.
  struct Rules {
    const Json& schema;
    const std::string& file;
  };

  void load(const std::string& file);
  [[nodiscard]] Rules resolved(const std::string& reference, const std::string& from) const;
  void check(const Json& value, Rules rules, const std::string& at, Faults& faults) const;
  void check_keyword(const std::string& keyword, Rules rule, const Json& value, const std::string& at,
                     Faults& faults) const;
  void check_object(const Json& value, Rules rules, const std::string& at, Faults& faults) const;

  std::string root_;
  std::map<std::string, Json> files_;
};

}  // namespace rad::report
