// Folders for what a test writes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace rad::tests {

/// An empty folder of the running test alone: CTest runs the tests of one program beside each other.
/// \param name  tells the folders of one test apart.
inline std::filesystem::path fresh_folder(const std::string& name = "") {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string own = std::string("rad_") + test->test_suite_name() + "." + test->name();
  if (!name.empty()) own += "." + name;
  std::ranges::replace(own, '/', '_');
  const auto folder = (std::filesystem::path(::testing::TempDir()) / own).lexically_normal();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace rad::tests
