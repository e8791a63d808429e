#include "writers/gltf_manifold.h"

#include <gmock/gmock.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/writers/written_files.h"

namespace rad::writers::gltf {
namespace {

using namespace tests;
using nlohmann::json;

const std::vector<std::uint32_t> kTetrahedron{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

TEST(ClosedManifold, IsATetrahedron_AndNothingThatIsOpenOrTurned) {
  EXPECT_TRUE(is_closed_manifold(kTetrahedron));
  EXPECT_FALSE(is_closed_manifold({}));
  EXPECT_FALSE(is_closed_manifold(std::span(kTetrahedron).first(9)));
  std::vector<std::uint32_t> turned = kTetrahedron;
  std::swap(turned[0], turned[1]);
  EXPECT_FALSE(is_closed_manifold(turned));
  std::vector<std::uint32_t> twice = kTetrahedron;
  twice.insert(twice.end(), kTetrahedron.begin(), kTetrahedron.end());
  EXPECT_FALSE(is_closed_manifold(twice));
}

/// A box in two materials, with its lid or without.
scene::Scene box(bool closed) {
  scene::SceneBuilder builder("box.obj", "obj");
  for (int i = 0; i < 8; ++i) builder.add_vertex({i & 1, i >> 1 & 1, i >> 2});
  const std::vector<std::vector<scene::VertexId>> faces{{0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5},
                                                        {3, 2, 6, 7}, {2, 0, 4, 6}, {4, 5, 7, 6}};
  builder.use_object(builder.object("box"));
  for (std::size_t i = 0; i < (closed ? 6 : 5); ++i) {
    builder.use_material(builder.material(i < 3 ? "oak" : "paint"));
    builder.add_face(faces[i], i);
  }
  return builder.take();
}

json document_of(const scene::Scene& scene, const std::string& name) {
  const auto path = fresh_folder(name) / (name + ".glb");
  EXPECT_EQ(tests::write({scene}, path), "");
  const std::string bytes = bytes_of(path);
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  EXPECT_EQ(facets_of(readers::read_file(path).scene, true).size(), facets_of(scene, true).size());
  return json::parse(bytes.substr(20, length));
}

TEST(MeshManifold, IsNamedForASolid_AcrossItsMaterials) {
  const json document = document_of(box(true), "solid");
  EXPECT_THAT(document["extensionsUsed"], testing::Contains(kManifold));
  EXPECT_FALSE(document.contains("extensionsRequired"));
  const json& mesh = document["meshes"][0];
  ASSERT_EQ(mesh["primitives"].size(), 2u);
  const json& solid = mesh["extensions"][kManifold]["manifoldPrimitive"];
  EXPECT_EQ(solid["attributes"]["POSITION"], mesh["primitives"][0]["attributes"]["POSITION"]);
  const auto indices = [&](const json& primitive) { return document["accessors"][primitive["indices"].get<int>()]; };
  EXPECT_EQ(indices(solid)["count"], 36);
  EXPECT_EQ(indices(solid)["byteOffset"], indices(mesh["primitives"][0])["byteOffset"]);
}

TEST(MeshManifold, IsNotNamedForAnOpenBox) {
  const json document = document_of(box(false), "open");
  EXPECT_FALSE(document.contains("extensionsUsed"));
  EXPECT_FALSE(document["meshes"][0].contains("extensions"));
}

TEST(MeshManifold, IsNotNamedInADracoTwin) {
  const json document = document_of(box(true), "twin.draco");
  EXPECT_EQ(document["extensionsUsed"], json::array({"KHR_draco_mesh_compression"}));
  EXPECT_FALSE(document["meshes"][0].contains("extensions"));
}

}  // namespace
}  // namespace rad::writers::gltf
