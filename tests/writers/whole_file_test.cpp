#include "writers/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/writers/written_files.h"

namespace rad::writers {
namespace {

using namespace tests;
using ::testing::HasSubstr;

std::size_t entries_of(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(WholeFiles, ReplaceWhatWasThere) {
  const auto folder = fresh_folder("replaced");
  write_bytes(folder / "a", "old");
  const std::array<WholeFile, 2> files{{{folder / "a", "new"}, {folder / "b", ""}}};
  EXPECT_EQ(write_whole_files(files), "");
  EXPECT_EQ(bytes_of(folder / "a"), "new");
  EXPECT_EQ(entries_of(folder), 2u);
}

TEST(WholeFiles, AreAllAsTheyWereWhereOneCannotBeWritten) {
  const auto folder = fresh_folder("kept");
  write_bytes(folder / "a", "old");
  for (const char* blocked : {"folder", "none/b"}) {
    std::filesystem::create_directories(folder / "folder");
    const std::array<WholeFile, 2> files{{{folder / "a", "new"}, {folder / blocked, "new"}}};
    EXPECT_NE(write_whole_files(files), "");
    EXPECT_EQ(bytes_of(folder / "a"), "old");
    EXPECT_EQ(entries_of(folder), 2u) << "nothing partial is left";
  }
}

TEST(WholeFiles, OfGltfStayTogether) {
  const auto folder = fresh_folder("gltf_kept");
  write_bytes(folder / "room.gltf", "old document");
  write_bytes(folder / "room.bin", "old bytes");
  std::filesystem::create_directories(folder / "room.gltf.partial" / "blocked");
  EXPECT_THAT(write({two_plates()}, folder / "room.gltf"), HasSubstr("cannot be opened for writing"));
  EXPECT_EQ(bytes_of(folder / "room.gltf"), "old document");
  EXPECT_EQ(bytes_of(folder / "room.bin"), "old bytes");
}

}  // namespace
}  // namespace rad::writers
