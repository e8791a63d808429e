// rad_corpus --out DIR: writes the kept models.
#include <cstdio>
#include <string_view>

#include "corpus/generate/kept_files.h"
#include "writers/whole_file.h"

int main(int argc, char** argv) {
  if (argc != 3 || std::string_view(argv[1]) != "--out") {
    std::fputs("usage: rad_corpus --out DIR\n", stderr);
    return 2;
  }
  for (const rad::corpus::KeptFile& file : rad::corpus::kept_files()) {
    const std::string problem = rad::writers::write_whole_file(std::filesystem::path(argv[2]) / file.name, file.bytes);
    if (!problem.empty()) {
      std::fprintf(stderr, "rad_corpus: %s\n", problem.c_str());
      return 2;
    }
  }
  return 0;
}
