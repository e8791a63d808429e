// rad_precision MODELS [SEEDS]: recall and false findings of every rule that has a mutator. Exit 1 unless perfect.
#include <charconv>
#include <cstdio>
#include <string_view>

#include "corpus/mutate/precision.h"

int main(int argc, char** argv) {
  std::uint64_t seeds = 5;
  const std::string_view given = argc == 3 ? argv[2] : "5";
  const auto parsed = std::from_chars(given.data(), given.data() + given.size(), seeds);
  if (argc < 2 || argc > 3 || parsed.ec != std::errc() || parsed.ptr != given.data() + given.size() || seeds == 0) {
    std::fputs("usage: rad_precision MODELS [SEEDS]\nMODELS is the folder corpus/models of this project.\n", stderr);
    return 2;
  }
  const rad::corpus::PrecisionReport report = rad::corpus::measure_precision(argv[1], seeds);
  std::fputs(rad::corpus::table(report).c_str(), stdout);
  constexpr std::size_t kShown = 40;
  for (std::size_t i = 0; i < report.failures.size() && i < kShown; ++i) std::puts(report.failures[i].c_str());
  if (report.failures.size() > kShown) std::printf("… %zu more\n", report.failures.size() - kShown);
  return report.perfect() ? 0 : 1;
}
