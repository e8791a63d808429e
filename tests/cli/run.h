// Running a program inside a test.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.h"
#include "tests/support/fresh_folder.h"

namespace rad::cli {

struct Outcome {
  int exit_code = 0;
  std::string out;
  std::string err;
};

inline Outcome outcome_of(Run run, const std::vector<std::string>& args, const Terminal& terminal = {}) {
  std::ostringstream out;
  std::ostringstream err;
  const int exit_code = run(args, out, err, terminal);
  return {exit_code, out.str(), err.str()};
}

/// A folder of its own for each test, removed at the end unless RAD_KEEP_FOLDERS is set.
class InFolder : public testing::Test {
 protected:
  void SetUp() override { folder_ = tests::fresh_folder(); }
  void TearDown() override {
    if (std::getenv("RAD_KEEP_FOLDERS") == nullptr) std::filesystem::remove_all(folder_);
  }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return at(name);
  }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  std::filesystem::path folder_;
};

/// A closed box that faces outward.
inline const std::string kBox =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// The same with its last face, on line 14, turned inward.
inline const std::string kBoxWithFlippedFace = kBox.substr(0, kBox.rfind("f ")) + "f 8 5 1 4\n";

/// A single square: nothing but notes and warnings.
inline const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

}  // namespace rad::cli
