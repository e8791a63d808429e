// How well the rules find planted defects, and what else they say.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rad::corpus {

struct Score {
  std::string mutator;
  std::string rule;
  std::size_t planted = 0;
  std::size_t found = 0;
  std::size_t false_findings = 0;
};

struct PrecisionReport {
  std::vector<Score> scores;          ///< one for each mutator
  std::vector<std::string> failures;  ///< one line for each miss and each false finding
  [[nodiscard]] bool perfect() const;
};

/// Plants every mutator's defect with each of `seeds` seeds into every clean model, as made and as read back from
/// `models` (the kept files), and compares findings before and after. False: a finding that was not there before, is
/// not in the planted place, and is of the planted rule or an error, the implied rules excepted in that place.
PrecisionReport measure_precision(const std::filesystem::path& models, std::uint64_t seeds);

std::string table(const PrecisionReport& report);

}  // namespace rad::corpus
