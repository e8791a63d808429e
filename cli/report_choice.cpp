#include "cli/report_choice.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "cli/nearest.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

// Code hosts know files by their path in the repository, which need not be the current folder.
std::string root_of_paths() {
  const char* const workspace_variable = std::getenv("GITHUB_WORKSPACE");
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const fs::path workspace = fs::path(workspace_variable != nullptr ? workspace_variable : "").lexically_normal();
  if (workspace.is_absolute()) {
    const fs::path inside = here.lexically_relative(workspace);
    if (!inside.empty() && *inside.begin() != "..") return workspace.string();
  }
  return here.string();
}

template <typename Format>
std::string chosen(std::string_view option, const std::string& word, std::span<const Format> formats,
                   const Format*& into) {
  if (word.empty()) return {};
  std::vector<std::string_view> names;
  for (const Format& format : formats) {
    names.push_back(format.name);
    if (format.name != word) continue;
    into = &format;
    return {};
  }
  return fmt::format("{}: '{}' is none of {}{}", option, word, fmt::join(names, ", "),
                     did_you_mean(nearest(word, names)));
}

template <typename File>
std::string taken_apart(const std::string& word, File& into) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) {
    return fmt::format("--report: '{}' is not of the form format=path, such as json=report.json", word);
  }
  into.path = word.substr(equals + 1);
  if (into.path == kStream) return "--report: names a file; --format chooses what standard output carries";
  return read_format("--report", word.substr(0, equals), into.format);
}

}  // namespace

report::WriteOptions file_write_options() {
  report::WriteOptions options;
  options.root = root_of_paths();
  return options;
}

std::string read_format(std::string_view option, const std::string& word, const report::ReportFormat*& into) {
  return chosen(option, word, report::report_formats(), into);
}

std::string read_format(std::string_view option, const std::string& word, const report::DiffFormat*& into) {
  return chosen(option, word, report::diff_formats(), into);
}

std::string read_file_report(const std::string& word, FileReport& into) { return taken_apart(word, into); }
std::string read_file_report(const std::string& word, DiffFileReport& into) { return taken_apart(word, into); }

}  // namespace rad::cli
