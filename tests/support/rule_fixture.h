// A folder of corpus/rules: the models in it and what expected.json says of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geom/vec.h"

namespace rad::tests {

/// A finding of the folder's rule, as a reader of the model can check it by hand.
struct ExpectedFinding {
  std::string severity;  ///< at stage model
  std::uint64_t count = 0;
  std::optional<geom::dvec3> point;  ///< file units, to a thousandth
};

/// One model of a folder. `implied` are the ids of all other rules that it breaks.
struct RuleFixture {
  std::filesystem::path path;
  bool fails = false;
  std::vector<ExpectedFinding> findings;  ///< canonical order; empty for a model that passes
  std::set<std::string> implied;
  std::optional<double> metres_per_unit{};  ///< as with --units
};

inline bool is_fixture_model(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  return (stem.starts_with("fail") || stem.starts_with("pass")) && path.extension() != ".mtl";
}

/// Names of the models that lie in the folder.
inline std::set<std::string> model_names(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_fixture_model(entry.path())) names.insert(entry.path().filename().string());
  }
  return names;
}

inline ExpectedFinding expected_finding(const nlohmann::json& text) {
  ExpectedFinding finding{text.at("severity"), text.at("count"), std::nullopt};
  const nlohmann::json& point = text.at("point");
  if (!point.is_null()) finding.point = geom::dvec3(point.at(0), point.at(1), point.at(2));
  return finding;
}

/// What expected.json names, by file name; throws where it is absent or not of this shape.
inline std::map<std::string, RuleFixture> fixtures_of(const std::filesystem::path& folder) {
  std::ifstream file(folder / "expected.json");
  const nlohmann::json described = nlohmann::json::parse(file);
  std::map<std::string, RuleFixture> fixtures;
  for (const auto& [name, text] : described.items()) {
    RuleFixture fixture{folder / name, name.starts_with("fail"), {}, text.at("implied")};
    if (text.contains("metresPerUnit")) fixture.metres_per_unit = text.at("metresPerUnit").get<double>();
    if (fixture.fails) {
      for (const nlohmann::json& finding : text.at("findings")) fixture.findings.push_back(expected_finding(finding));
    }
    fixtures.emplace(name, std::move(fixture));
  }
  return fixtures;
}

}  // namespace rad::tests
