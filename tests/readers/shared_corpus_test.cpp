// Every file of the acceptance corpus in a text or binary mesh format, found through RAD_SHARED.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

struct Entry {
  std::string path;
  std::string format;
  std::string faces;  ///< as a plain counter of records found them; empty where it could not
};

std::vector<Entry> manifest(const std::filesystem::path& corpus, const std::vector<std::string>& formats) {
  std::vector<Entry> entries;
  std::ifstream stream(corpus / "manifest.tsv");
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string field; std::getline(parts, field, '\t');) fields.push_back(field);
    if (fields.size() < 10) continue;
    if (std::ranges::find(formats, fields[1]) != formats.end()) entries.push_back({fields[0], fields[1], fields[9]});
  }
  return entries;
}

const std::vector<std::string> kMeshFormats = {"obj", "stl", "ply", "off"};
const std::vector<std::string> kCadFormats = {"dxf", "cityjson", "rad"};

class SharedCorpus : public testing::Test {
 protected:
  void SetUp() override {
    const char* const shared = std::getenv("RAD_SHARED");
    if (shared == nullptr) GTEST_SKIP() << "RAD_SHARED names no folder";
    corpus_ = std::filesystem::path(shared) / "corpus";
  }

  std::filesystem::path corpus_;
};

// Faces that are left out because of an index or a record that is at fault are counted with those that are read.
TEST_F(SharedCorpus, HoldsTheFacesThatItsManifestStates) {
  const auto entries = manifest(corpus_, kMeshFormats);
  ASSERT_GT(entries.size(), 70u);
  for (const Entry& entry : entries) {
    const ReadResult result = read_file(corpus_ / entry.path);
    EXPECT_EQ(tests::broken_invariant(result.scene), "") << entry.path;
    if (entry.faces.empty()) continue;
    std::uint64_t left_out = 0;
    for (const scene::ReadIssue& issue : result.issues.all()) {
      if (issue.kind == scene::ReadIssueKind::IndexOutOfRange) left_out += issue.count;
    }
    EXPECT_EQ(result.scene.faces.size() + left_out, std::stoull(entry.faces)) << entry.path << "\n"
                                                                              << tests::issue_text(result);
  }
}

TEST_F(SharedCorpus, SoundFilesReadWithoutParseErrors) {
  for (const Entry& entry : manifest(corpus_, kMeshFormats)) {
    if (entry.path.starts_with("malformed/")) continue;
    const ReadResult result = read_file(corpus_ / entry.path);
    EXPECT_EQ(result.scene.format, entry.format) << entry.path;
    EXPECT_FALSE(result.issues.any(scene::ReadIssueKind::ParseError)) << entry.path << "\n"
                                                                      << tests::issue_text(result);
    EXPECT_FALSE(result.issues.any(scene::ReadIssueKind::IndexOutOfRange)) << entry.path;
  }
}

/// Faces that a counter of records would find: of Radiance polygons alone, of DXF 3DFACEs.
std::size_t counted_faces(const scene::Scene& scene) {
  if (scene.format != "rad") return scene.faces.size();
  return static_cast<std::size_t>(std::ranges::count_if(
      scene.faces, [&](const scene::Face& face) { return scene.entities[face.entity].starts_with("polygon "); }));
}

// The manifest counts records: those of blocks and of coarser levels of detail too, and of DXF only 3DFACEs.
TEST_F(SharedCorpus, CadFilesHoldTheFacesThatItsManifestStates) {
  const auto entries = manifest(corpus_, kCadFormats);
  ASSERT_GT(entries.size(), 20u);
  for (const Entry& entry : entries) {
    if (entry.path.starts_with("malformed/")) continue;
    const ReadResult result = read_file(corpus_ / entry.path);
    EXPECT_EQ(tests::broken_invariant(result.scene), "") << entry.path;
    EXPECT_EQ(result.scene.format, entry.format) << entry.path;
    EXPECT_FALSE(result.issues.any(scene::ReadIssueKind::ParseError)) << entry.path << "\n"
                                                                      << tests::issue_text(result);
    const bool repeated = entry.path.ends_with("multi_lod.json");
    if (entry.faces.empty() || entry.faces == "0" || repeated) continue;
    // Two of its 3DFACEs stand in a block that nothing places.
    const std::size_t unplaced = entry.path.ends_with("3dface.dxf") ? 2 : 0;
    EXPECT_EQ(counted_faces(result.scene) + unplaced, std::stoull(entry.faces)) << entry.path << "\n" << tests::issue_text(result);
  }
}

}  // namespace
}  // namespace rad::readers
