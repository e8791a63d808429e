#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/readers/read_text.h"
#include "tests/support/fresh_folder.h"

namespace rad::readers {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using tests::issue_text;

std::string format_of(std::string_view bytes, const char* path) {
  const Reader* const reader = find_reader(bytes, path);
  return reader == nullptr ? "" : std::string(reader->format);
}

TEST(Registry, ContentComesBeforeTheSuffix) {
  EXPECT_EQ(format_of("ply\nformat ascii 1.0\n", "a.obj"), "ply");
  EXPECT_EQ(format_of("\xEF\xBB\xBFOFF\n1 0 0\n", "a.stl"), "off");
  EXPECT_EQ(format_of("solid a\nfacet normal 0 0 1\n", "a.txt"), "stl");
  EXPECT_EQ(format_of("# x\nv 0 0 0\nv 1 0 0\n", "model"), "obj");
  EXPECT_EQ(format_of("{\"asset\": {\"version\": \"2.0\"}}", "a.json"), "gltf");
}

TEST(Registry, TheSuffixDecidesWhereContentDoesNot) {
  EXPECT_EQ(format_of("", "a.OBJ"), "obj");
  EXPECT_EQ(format_of("solid", "a.Stl"), "stl");
  EXPECT_EQ(format_of("1 2 3", "dir.obj/a.off"), "off");
  EXPECT_EQ(format_of("hello", "a.txt"), "");
  EXPECT_EQ(format_of("hello", "obj"), "");
}

TEST(Registry, NamesSuffixesOfFormatsThatAreRead) {
  EXPECT_THAT(model_suffixes(), Contains(".obj"));
  EXPECT_THAT(model_suffixes(), Contains(".glb"));
  EXPECT_THAT(model_suffixes(), Contains(".off"));
  EXPECT_THAT(model_suffixes(), Not(Contains(".dwg")));
  EXPECT_THAT(model_suffixes(), Contains(".dxf"));
  EXPECT_THAT(model_suffixes(), Contains(".city.json"));
  EXPECT_GE(all_readers().size(), 10u);
}

TEST(Registry, SaysWhatToDoAboutFormatsThatAreNotRead) {
  EXPECT_EQ(issue_text(tests::read_text("AC1032", "plan.DWG")),
            "line 0: DWG is not read yet; export OBJ, glTF, PLY, STL or OFF\n");
  for (const char* path : {"a.gbxml", "a.usdz", "a.skp", "a.dwg", "a.blend", "a.rvt"}) {
    EXPECT_THAT(issue_text(tests::read_text("x", path)), HasSubstr("is not read yet; export")) << path;
  }
  EXPECT_THAT(issue_text(tests::read_text("hello", "a.txt")), HasSubstr("the format is not known; export"));
}

TEST(Registry, HandlesByteOrderMarks) {
  const auto utf8 = tests::read_text("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(issue_text(utf8), "");
  EXPECT_EQ(utf8.scene.faces.size(), 1u);
  EXPECT_EQ(issue_text(tests::read_text(std::string_view("\xFF\xFEv\0 \0", 6), "a.obj")),
            "line 0: the text is UTF-16; save the file as UTF-8\n");
}

TEST(ReadFile, SaysWhyAFileCannotBeRead) {
  const auto folder = tests::fresh_folder();
  EXPECT_THAT(issue_text(read_file(folder / "no such file.obj")), HasSubstr("the file cannot be read: No such file"));
  EXPECT_THAT(issue_text(read_file(folder)), HasSubstr("the file cannot be read: it is a folder"));
  const auto path = folder / "rad_registry_test.obj";
  std::ofstream(path).flush();
  EXPECT_EQ(issue_text(read_file(path)), "line 0: the file is empty\n");
  EXPECT_EQ(read_file(path).scene.materials.size(), 1u);
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(read_file(path).scene.faces.size(), 1u);
  EXPECT_EQ(read_file(path).scene.path, path.string());
  Limits limits;
  limits.file_bytes = 8;
  EXPECT_THAT(issue_text(read_file(path, limits)), HasSubstr("larger than the limit of 8 bytes"));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace rad::readers
