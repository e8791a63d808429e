#include "cli/saved_report.h"

#include <filesystem>

#include "readers/file_bytes.h"
#include "report/read_report.h"

namespace rad::cli {

namespace {

constexpr std::uint64_t kLargestReport = std::uint64_t{4} << 30;  // bytes

}  // namespace

bool names_report(const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return (extension == ".json" || extension == ".jsonl") && !path.ends_with(".stage.json");
}

SavedReport read_saved_report(const std::string& path) {
  readers::FileBytes file;
  std::string problem = file.open(path, kLargestReport, readers::FileKind::RegularOrStream);
  if (!problem.empty()) return {{}, path + ": the report cannot be read: " + problem};
  report::ReadBack back = report::read_report(file.bytes());
  if (!back.problem.empty()) return {{}, path + ": the report cannot be read: " + back.problem};
  return {std::move(back.report), {}};
}

}  // namespace rad::cli
