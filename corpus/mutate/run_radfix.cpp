#include "corpus/mutate/run_radfix.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rad::corpus {
namespace {

// The exit status; what it says goes nowhere.
int run_quietly(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  pid_t child = 0;
  const int problem = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (problem != 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void read_report(const std::filesystem::path& path, RadfixRun& run) {
  std::ifstream file(path);
  const auto report = nlohmann::json::parse(file, nullptr, false);
  if (report.is_discarded()) return;
  if (report["tolerance"].is_object()) run.tolerance = report["tolerance"]["T"];
  for (const auto& entry : report["ledger"]) run.ledger.push_back({entry["operation"], entry["largestMovement"]});
}

}  // namespace

RadfixRun run_radfix(const std::filesystem::path& radfix, const std::filesystem::path& model,
                     const std::filesystem::path& output) {
  std::filesystem::path report = output;
  report += ".json";
  std::filesystem::remove(output);
  std::filesystem::remove(report);
  RadfixRun run;
  run.exit_code =
      run_quietly({radfix.string(), model.string(), "-o", output.string(), "--report", "json=" + report.string()});
  run.wrote = std::filesystem::exists(output);
  if (std::filesystem::exists(report)) read_report(report, run);
  std::filesystem::remove(report);
  return run;
}

}  // namespace rad::corpus
