// rad_fuzz_repair: repairs hard random scenes and judges each by everything that must hold. Exit 1 where one fails.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>

#include "corpus/judge/fuzz_repair.h"
#include "readers/reader.h"
#include "writers/obj.h"

namespace {

using namespace rad;

constexpr const char* kUsage =
    "usage: rad_fuzz_repair [--kinds A,B…] [--seeds A..B] [--size N] [--jobs N] [--time-limit SECONDS]\n"
    "                       [--slow SECONDS] [--quick] [--only CHECK] [--skip CHECK] [--shrink DIR]\n"
    "       rad_fuzz_repair --file MODEL --tolerance T [--quick] [--only CHECK]\n"
    "--quick leaves out the variants of each scene. --shrink writes a small OBJ for every scene that fails.\n";

struct Command {
  corpus::FuzzOptions fuzz;
  std::string shrink_to;
  std::string file;
  double tolerance = 0;
};

struct Refused {
  std::string why;
};

template <typename Number>
Number number(std::string_view text) {
  Number value{};
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || value <= Number{0}) {
    throw Refused{fmt::format("'{}' is no positive number", text)};
  }
  return value;
}

std::vector<const corpus::HardKind*> kinds_of(std::string_view text) {
  std::vector<const corpus::HardKind*> kinds;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    kinds.push_back(corpus::hard_kind(name));
    if (kinds.back() == nullptr) {
      std::string known;
      for (const auto& kind : corpus::hard_kinds()) known += fmt::format(" {}", kind.name);
      throw Refused{fmt::format("no kind '{}'; there are{}", name, known)};
    }
    if (comma == std::string_view::npos) return kinds;
    text.remove_prefix(comma + 1);
  }
}

void set_seeds(corpus::FuzzOptions& options, std::string_view text) {
  const std::size_t dots = text.find("..");
  options.first_seed = number<std::uint64_t>(text.substr(0, dots));
  options.last_seed =
      dots == std::string_view::npos ? options.first_seed : number<std::uint64_t>(text.substr(dots + 2));
}

std::string_view known_check(std::string_view name) {
  for (const std::string_view check : corpus::repair_checks()) {
    if (check == name) return check;
  }
  throw Refused{fmt::format("no check '{}'; there are {}", name, fmt::join(corpus::repair_checks(), ", "))};
}

Command parsed(int argc, char** argv) {
  Command command;
  for (const corpus::HardKind& kind : corpus::hard_kinds()) command.fuzz.kinds.push_back(&kind);
  const std::map<std::string_view, std::function<void(std::string_view)>> options{
      {"--kinds", [&](auto value) { command.fuzz.kinds = kinds_of(value); }},
      {"--seeds", [&](auto value) { set_seeds(command.fuzz, value); }},
      {"--size", [&](auto value) { command.fuzz.size = number<int>(value); }},
      {"--jobs", [&](auto value) { command.fuzz.jobs = number<std::size_t>(value); }},
      {"--time-limit", [&](auto value) { command.fuzz.seconds = number<double>(value); }},
      {"--slow", [&](auto value) { command.fuzz.judge.slow_seconds = number<double>(value); }},
      {"--only", [&](auto value) { command.fuzz.judge.only = known_check(value); }},
      {"--skip", [&](auto value) { command.fuzz.judge.skipped.push_back(known_check(value)); }},
      {"--shrink", [&](auto value) { command.shrink_to = value; }},
      {"--file", [&](auto value) { command.file = value; }},
      {"--tolerance", [&](auto value) { command.tolerance = number<double>(value); }},
  };
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--quick") {
      command.fuzz.judge.variants = false;
      continue;
    }
    const auto option = options.find(argv[i]);
    if (option == options.end() || i + 1 == argc)
      throw Refused{fmt::format("'{}' is no option, or lacks its value", argv[i])};
    option->second(argv[++i]);
  }
  if (!command.file.empty() && command.tolerance == 0) throw Refused{"--file needs --tolerance"};
  return command;
}

void print(std::string_view name, const corpus::RepairVerdict& verdict) {
  for (const corpus::RepairFault& fault : verdict.faults) {
    fmt::print("FAIL {}: {}: {} ({:.2f} s)\n", name, fault.check, fault.what, verdict.seconds);
  }
  std::fflush(stdout);
}

void write_shrunken(const Command& command, const corpus::FuzzFailure& failure) {
  const std::string_view check = failure.verdict.faults[0].check;
  const corpus::HardScene scene = corpus::hard_scene(*failure.kind, failure.seed, command.fuzz.size);
  const scene::Scene small = corpus::shrunken_scene(scene, check, command.fuzz.judge);
  const std::string name = fmt::format("{}_{}_{}.obj", failure.kind->name, failure.seed, check);
  const std::vector<std::string> comments{
      fmt::format("{} seed {}{}: {}; T={}", failure.kind->name, failure.seed, scene.variant, check, scene.tolerance)};
  const writers::Output output{.scene = small, .lattice = small.recorded, .comments = comments};
  const auto written = writers::write_obj(output, std::filesystem::path(command.shrink_to) / name);
  fmt::print("     {} faces of {} left in {} {}\n", small.faces.size(), scene.scene.faces.size(), name,
             written.problem);
  std::fflush(stdout);
}

int judge_file(const Command& command) {
  const readers::ReadResult read = readers::read_file(command.file);
  if (read.scene.faces.empty()) throw Refused{fmt::format("no face could be read in {}", command.file)};
  const corpus::RepairVerdict verdict = corpus::judge_repair(read.scene, command.tolerance, command.fuzz.judge);
  print(command.file, verdict);
  fmt::print("{} in {:.2f} s, moved {:.2f} T, lost {:.2f} T, added {:.2f} T\n",
             verdict.was_clean ? "clean" : "repaired", verdict.seconds, verdict.movement, verdict.lost, verdict.added);
  return verdict.faults.empty() ? 0 : 1;
}

int fuzz(const Command& command) {
  std::size_t failures = 0;
  const auto summaries = corpus::fuzz_repair(command.fuzz, [&](const corpus::FuzzFailure& failure) {
    ++failures;
    const auto variant = corpus::hard_scene(*failure.kind, failure.seed, command.fuzz.size).variant;
    print(fmt::format("{} {} [{}]", failure.kind->name, failure.seed, variant), failure.verdict);
    if (!command.shrink_to.empty()) write_shrunken(command, failure);
  });
  std::fputs(corpus::table(summaries).c_str(), stdout);
  fmt::print("seeds {}..{}, size {}: {} scenes failed\n", command.fuzz.first_seed, command.fuzz.last_seed,
             command.fuzz.size, failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Command command = parsed(argc, argv);
    return command.file.empty() ? fuzz(command) : judge_file(command);
  } catch (const Refused& refused) {
    fmt::print(stderr, "rad_fuzz_repair: {}\n{}", refused.why, kUsage);
  }
  return 2;
}
