// One report of several.
#pragma once

#include <string>
#include <vector>

#include "report/report.h"

namespace rad::report {

struct Joined {
  Report report;
  std::string problem;  ///< why they are not one run, in one clause; then the report says nothing
};

/// Lines of one file, each a report of one input: the inputs in the order of the lines, still a shard where they are.
Joined join_lines(std::vector<Report> lines);

/// Shards become the whole run that was divided, every file at its place; all shards must be there. Reports that are no
/// shards follow each other in the order given. They must agree on tool, stage, rules chosen and what fails the run,
/// and no input may occur twice.
Joined merged(std::vector<Report> reports);

}  // namespace rad::report
