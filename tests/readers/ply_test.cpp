#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/readers/read_text.h"
#include "tests/support/corner_values_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::issue_text;
using tests::outer_loop;

ReadResult read_ply(std::string_view bytes) { return tests::read_text(bytes, "model.ply"); }

constexpr std::string_view kHeader =
    "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
constexpr std::string_view kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n";

std::string text_ply() { return std::string(kHeader) + std::string(kBody); }

template <typename Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// The same model in the byte order of the machine, which the tests take to be little-endian.
std::string binary_ply() {
  std::string bytes(kHeader);
  bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, number);
  append(bytes, std::uint8_t{4});
  for (const std::int32_t index : {0, 1, 2, 3}) append(bytes, index);
  append(bytes, std::uint8_t{3});
  for (const std::int32_t index : {0, 1, 2}) append(bytes, index);
  return bytes;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Ply, ReadsTextureCoordinatesAndNormalsOfVertices) {
  for (const auto& [u, v] : {std::pair{"s", "t"}, std::pair{"u", "v"}, std::pair{"texture_u", "texture_v"}}) {
    const std::string header =
        with(std::string(kHeader), "property float z\n",
             std::string("property float nx\nproperty float ") + v + "\nproperty float z\nproperty " +
                 "double ny\nproperty float nz\nproperty float " + u + "\n");
    const ReadResult result = read_ply(header +
                                       "0 0 0 .25 0 0 1 .5\n1 0 0 1 0 0 1 2\n1 1 0 3 0 0 1 4\n0 1 0 5 0 1 0 6\n"
                                       "4 0 1 2 3\n3 0 1 2\n");
    EXPECT_EQ(issue_text(result), "");
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
    using scene::dvec2;
    EXPECT_THAT(tests::texture_of(result.scene, 0), ElementsAre(dvec2(.5, .25), dvec2(2, 1), dvec2(4, 3), dvec2(6, 5)));
    EXPECT_THAT(tests::normals_of(result.scene, 1), ElementsAre(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1)));
    EXPECT_TRUE(result.scene.splits_vertices);
  }
  EXPECT_TRUE(read_ply(text_ply()).scene.attributes.empty());
  EXPECT_FALSE(read_ply(text_ply()).scene.splits_vertices);
}

TEST(Ply, ReadsText) {
  const ReadResult result = read_ply(text_ply());
  EXPECT_EQ(issue_text(result), "");
  EXPECT_TRUE(result.scene.single_precision);
  EXPECT_FALSE(result.scene.triangles_only);
  EXPECT_THAT(result.scene.vertex_records, ElementsAre(11, 12, 13, 14));
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(result.scene.faces[0].source.record, 15u);
}

TEST(Ply, ReadsLittleEndian) {
  const std::string bytes = binary_ply();
  const ReadResult result = read_ply(bytes);
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.vertices, read_ply(text_ply()).scene.vertices);
  EXPECT_THAT(outer_loop(result.scene, 1), ElementsAre(0, 1, 2));
  EXPECT_EQ(result.scene.sections[0].kind, scene::RecordKind::ByteOffset);
  EXPECT_EQ(result.scene.faces[0].source.record, bytes.size() - 30);
}

TEST(Ply, ReadsBigEndianWithFacesBeforeVerticesAndPropertiesInAnyOrder) {
  const ReadResult result =
      read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/ply/tetrahedron_big_endian.ply");
  EXPECT_EQ(issue_text(result), "line 12: edges\n");
  EXPECT_FALSE(result.scene.single_precision);
  EXPECT_THAT(result.scene.vertices, ElementsAre(dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)));
  ASSERT_EQ(result.scene.faces.size(), 4u);
  EXPECT_THAT(outer_loop(result.scene, 2), ElementsAre(1, 2, 3));
}

TEST(Ply, ABinaryBodyMayBeginWithTheByteOfALineEnd) {
  std::string header =
      "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar x\rproperty uchar y\r"
      "property uchar z\rend_header\r";
  const ReadResult lone = read_ply(header + "\n\r\n");
  EXPECT_EQ(issue_text(lone), "");
  EXPECT_THAT(lone.scene.vertices, ElementsAre(dvec3(10, 13, 10)));
  std::string pairs;
  for (const char c : header) pairs += c == '\r' ? std::string("\r\n") : std::string(1, c);
  EXPECT_THAT(read_ply(pairs + "\n\r\n").scene.vertices, ElementsAre(dvec3(10, 13, 10)));
}

TEST(Ply, ReadsEveryTypeOfCoordinate) {
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint8",
                           "int16", "uint16", "int32", "uint32", "float32", "float64"}) {
    const ReadResult result = read_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty " + std::string(type) +
                                       " x\nproperty int y\nproperty int z\nend_header\n7 8 9\n");
    EXPECT_EQ(issue_text(result), "") << type;
    EXPECT_THAT(result.scene.vertices, ElementsAre(dvec3(7, 8, 9))) << type;
  }
}

TEST(Ply, StepsOverPropertiesAndElementsThatHoldNoSurface) {
  const ReadResult result = read_ply(
      "ply\nformat ascii 1.0\nelement camera 1\nproperty float a\nelement vertex 3\nproperty list uchar int tags\n"
      "property float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list int int "
      "vertex_indices\n"
      "element nothing 5\nelement face 1\nproperty list uchar float texcoord\nproperty list uchar int vertex_index\n"
      "property int flags\nend_header\n5\n2 8 9 0 0 0\n0 1 0 0\n1 7 0 1 0\n3 0 1 2\n2 0.5 0.5 3 0 1 2 9\n");
  EXPECT_EQ(issue_text(result), "line 10: triangle strips (tristrips)\n");
  EXPECT_EQ(result.scene.vertices[2], dvec3(0, 1, 0));
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(0, 1, 2));
}

TEST(Ply, RefusesUnsoundHeaders) {
  const auto issue = [](const std::string& from, const std::string& to) {
    return issue_text(read_ply(with(text_ply(), from, to)));
  };
  EXPECT_EQ(issue("format ascii", "format utf"), "line 2: 'utf' is not a format of PLY\n");
  EXPECT_EQ(issue("float x", "half x"), "line 5: 'half' is not a type of PLY\n");
  EXPECT_EQ(issue("list uchar", "list float"), "line 9: 'float' is not an integer type of PLY\n");
  EXPECT_EQ(issue("vertex 4", "vertex four"), "line 4: an element needs a name and a count\n");
  EXPECT_EQ(issue("vertex 4", "vertex -4"), "line 4: an element needs a name and a count\n");
  EXPECT_EQ(issue("comment x", "remark x"), "line 3: header lines of no known statement\n");
  EXPECT_EQ(issue("element face 2", "element vertex 2"), "line 8: the element 'vertex' is declared twice\n");
  EXPECT_EQ(issue("format ascii 1.0", "comment"), "line 10: the header names no format\n");
  EXPECT_THAT(issue("float z", "float w"), HasSubstr("the vertices have no property 'z'"));
  EXPECT_THAT(issue("vertex_indices", "corners"), HasSubstr("the faces have no list 'vertex_indices'"));
  EXPECT_THAT(issue("end_header", "comment"), HasSubstr("line 16: the header has no end_header"));
}

TEST(Ply, RefusesHeadersOfTooManyElements) {
  std::string header = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 1500; ++i) header += "element e" + std::to_string(i) + " 0\n";
  EXPECT_EQ(issue_text(read_ply(header + "end_header\n")), "line 1003: the header declares more than 1000 elements\n");
}

TEST(Ply, RefusesHugeCountsAtOnceAndReadsWhatIsThere) {
  const ReadResult vertices = read_ply(with(text_ply(), "vertex 4", "vertex 999999999999"));
  EXPECT_THAT(issue_text(vertices),
              HasSubstr("line 4: the header states 999999999999 of 'vertex', the bytes that follow hold at most 7"));
  EXPECT_EQ(vertices.scene.faces.size(), 0u);
  const ReadResult faces = read_ply(with(binary_ply(), "face 2", "face 4000000000"));
  EXPECT_THAT(issue_text(faces), HasSubstr("line 8: the header states 4000000000 of 'face'"));
  EXPECT_EQ(faces.scene.faces.size(), 2u);
  std::string list = binary_ply();
  list[list.size() - 30] = '\xff';
  EXPECT_THAT(issue_text(read_ply(list)), HasSubstr("the file ends after 0 of 2 of 'face'"));
}

TEST(Ply, LeavesOutFacesWithBadIndices) {
  const ReadResult result = read_ply(with(with(text_ply(), "0 1 2 3", "0 1 2 4"), "3 0 1 2\n", "3 0 1 -2\n"));
  EXPECT_EQ(result.scene.faces.size(), 0u);
  EXPECT_EQ(
      issue_text(result),
      "line 15: vertex index 4 is outside the 4 vertices, which count from 0\nline 16: vertex index -2 is negative\n");
}

TEST(Ply, ReportsLinesThatTheHeaderDoesNotAccountFor) {
  EXPECT_EQ(issue_text(read_ply(text_ply() + "\n\n3 0 1 2\n")),
            "line 19: lines follow the last element that the header states; they are left out\n");
  EXPECT_EQ(issue_text(read_ply("ply\nformat ascii 1.0\nend_header\n")), "");
}

TEST(Ply, KeepsVerticesThatCannotBeRead) {
  const ReadResult result = read_ply(with(with(text_ply(), "1 0 0\n", "1 0\n"), "1 1 0\n", "1 nan x\n"));
  ASSERT_EQ(result.scene.vertices.size(), 4u);
  EXPECT_TRUE(std::isnan(result.scene.vertices[1].z));
  EXPECT_EQ(issue_text(result), "line 12: the value of 'z' is missing\nline 13: the value of 'z' is not a number\n");
  EXPECT_EQ(result.scene.faces.size(), 2u);
}

TEST(Ply, LivesThroughTruncationAtEveryByte) {
  for (const std::string& bytes : {text_ply(), binary_ply()}) {
    // Without its line end, the text is still whole.
    for (std::size_t size = 4; size < bytes.size() - 1; ++size) {
      const ReadResult result = read_ply(std::string_view(bytes).substr(0, size));
      EXPECT_EQ(tests::broken_invariant(result.scene), "");
      EXPECT_GE(result.issues.all().size(), 1u) << size;
      EXPECT_LE(result.issues.all().size(), 3u) << size << issue_text(result);
    }
  }
  const std::string bytes = binary_ply();
  const ReadResult result = read_ply(std::string_view(bytes).substr(0, bytes.size() - 2));
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(issue_text(result),
            "byte " + std::to_string(bytes.size() - 13) + ": the file ends after 1 of 2 of 'face'\n");
}

}  // namespace
}  // namespace rad::readers
