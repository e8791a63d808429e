// Running radfix on a file, as a user does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rad::corpus {

struct LedgerRow {
  std::string operation;
  double largest_movement = 0;  ///< file units
};

struct RadfixRun {
  int exit_code = -1;  ///< -1: it could not be run or was killed
  bool wrote = false;
  double tolerance = 0;  ///< file units, as reported
  std::vector<LedgerRow> ledger;
};

/// `radfix model -o output --report json=…`; the output is removed before. The report is not kept.
RadfixRun run_radfix(const std::filesystem::path& radfix, const std::filesystem::path& model,
                     const std::filesystem::path& output);

}  // namespace rad::corpus
