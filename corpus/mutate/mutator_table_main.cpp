// rad_mutator_table: what radfix makes of planted defects, as Markdown. Exit 1 where something must not be.
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>

#include "corpus/mutate/repair_table.h"

namespace {

constexpr const char* kUsage =
    "usage: rad_mutator_table --radfix PROGRAM [--seeds N] [--model NAME]…\n"
    "       rad_mutator_table --check DOCUMENT\n";

int check(const char* path) {
  std::ifstream file(path);
  const std::string document(std::istreambuf_iterator<char>(file), {});
  const std::string fault = rad::corpus::fault_of_form(document);
  if (!fault.empty()) std::fprintf(stderr, "%s %s: run rad_mutator_table --radfix bin/radfix\n", path, fault.c_str());
  return fault.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  rad::corpus::RepairTrials trials;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i], value = argv[i + 1];
    if (option == "--check" && argc == 3) return check(argv[2]);
    if (option == "--radfix") trials.radfix = value;
    if (option == "--model") trials.models.emplace_back(value);
    if (option == "--seeds") std::from_chars(value.data(), value.data() + value.size(), trials.seeds);
  }
  if (trials.radfix.empty() || argc % 2 == 0) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  const rad::corpus::RepairTable table = rad::corpus::measure_repairs(trials);
  std::fputs(rad::corpus::markdown(table).c_str(), stdout);
  for (const std::string& failure : table.failures) std::fprintf(stderr, "%s\n", failure.c_str());
  return table.failures.empty() ? 0 : 1;
}
