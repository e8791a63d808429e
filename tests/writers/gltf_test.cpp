#include "writers/gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/writers/written_files.h"

namespace rad::writers {
namespace {

using namespace tests;
using nlohmann::json;
using scene::Scene;
using ::testing::HasSubstr;

std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// The parts of a GLB, after its lengths have been held against each other.
struct Glb {
  json document;
  std::string binary;

  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(bytes, 4), 2u);
    EXPECT_EQ(word_at(bytes, 8), bytes.size());
    const std::size_t text = word_at(bytes, 12), binary_at = 20 + text;
    EXPECT_EQ(text % 4, 0u);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    document = json::parse(bytes.substr(20, text));
    EXPECT_EQ(bytes.substr(binary_at + 4, 4), std::string("BIN\0", 4));
    binary = bytes.substr(binary_at + 8);
    EXPECT_EQ(word_at(bytes, binary_at), binary.size());
    EXPECT_EQ(document["buffers"][0]["byteLength"], binary.size());
  }

  [[nodiscard]] const char* element(const json& accessor, std::size_t index) const {
    const json& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t stride = view.contains("byteStride") ? view["byteStride"].get<std::size_t>() : 0;
    return binary.data() + view["byteOffset"].get<std::size_t>() + accessor["byteOffset"].get<std::size_t>() +
           index * stride;
  }
};

Glb written(const Output& output, const std::string& name) {
  const auto path = fresh_folder(name) / "model.glb";
  EXPECT_EQ(write_glb(output, path).problem, "");
  return Glb(bytes_of(path));
}

TEST(Gltf, HasANodeForEachObjectAndAPrimitiveForEachMaterial) {
  Scene scene = two_plates();
  scene.objects.emplace_back("without a face");
  const json document = written({scene}, "gltf_nodes").document;
  ASSERT_EQ(document["nodes"].size(), 2u);
  EXPECT_EQ(document["nodes"][0]["name"], "left");
  EXPECT_EQ(document["scenes"][0]["nodes"], json({0, 1})) << "no root where the origin is zero";
  EXPECT_EQ(document["materials"].size(), 2u) << "the unnamed material has no face";
  const json& right = document["meshes"][1]["primitives"];
  ASSERT_EQ(right.size(), 2u);
  EXPECT_EQ(right[0]["attributes"], right[1]["attributes"]) << "one vertex buffer";
  EXPECT_EQ(document["accessors"][right[0]["attributes"]["POSITION"].get<std::size_t>()]["count"], 4);
}

TEST(Gltf, ReadsBackOneSetOfVerticesForPrimitivesThatShareIt) {
  const auto path = fresh_folder("gltf_shared") / "model.glb";
  const Scene scene = two_plates();
  ASSERT_TRUE(write_glb({scene}, path).ok());
  EXPECT_EQ(readers::read_file(path).scene.vertices.size(), 8u) << "4 of each object";
}

TEST(Gltf, PutsTheLatticeOriginIntoTheRootNode) {
  Scene scene = two_plates({1e6, 2e6, 0});
  const scene::RecordedLattice lattice = lattice_of(scene);
  snap(scene, lattice.lattice);
  const Glb glb = written({.scene = scene, .lattice = lattice}, "gltf_root");
  const json& root = glb.document["nodes"][0];
  EXPECT_EQ(glb.document["scenes"][0]["nodes"], json({0}));
  EXPECT_EQ(root["children"], json({1, 2}));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(root["translation"][static_cast<std::size_t>(axis)].get<double>(), lattice.lattice.origin[axis]);
  }
  const json& record = glb.document["asset"]["extras"]["radfix"];
  EXPECT_EQ(record["tolerance"].get<double>(), lattice.tolerance);
  EXPECT_EQ(record["pitch"].get<double>(), lattice.lattice.pitch);
  EXPECT_EQ(record["origin"], root["translation"]);
  EXPECT_FALSE(record.contains("incomplete"));
  EXPECT_FALSE(record.contains("exposure"));
}

TEST(Gltf, StatesTheExactBoundsOfPositions) {
  Scene scene = two_plates({0.1, 0.2, 0.3});
  const Glb glb = written({scene}, "gltf_bounds");
  for (const json& accessor : glb.document["accessors"]) {
    if (!accessor.contains("min")) continue;
    glm::vec3 low(1e9f), high(-1e9f);
    for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i) {
      glm::vec3 position;
      std::memcpy(&position, glb.element(accessor, i), sizeof position);
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(accessor["min"][static_cast<std::size_t>(axis)].get<double>(), low[axis]);
      EXPECT_EQ(accessor["max"][static_cast<std::size_t>(axis)].get<double>(), high[axis]);
    }
  }
}

TEST(Gltf, GivesExitanceAsLuminanceWithAStrength) {
  Scene scene = two_plates();
  const json lamp = written({scene}, "gltf_emission").document["materials"][1];
  EXPECT_DOUBLE_EQ(lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 30 / std::numbers::pi);
  EXPECT_EQ(lamp["emissiveFactor"][0], 1.0);
  EXPECT_DOUBLE_EQ(lamp["emissiveFactor"][2], 1.0 / 3);
  scene.materials[2].emission = {0.5, 0, 0};
  scene.materials[2].emission_unit = scene::Material::EmissionUnit::Luminance;
  const json faint = written({scene}, "gltf_faint").document;
  EXPECT_EQ(faint["materials"][1]["emissiveFactor"], json({0.5, 0.0, 0.0}));
  EXPECT_FALSE(faint.contains("extensionsUsed"));
}

TEST(Gltf, ReadsMaterialsBackWithAndWithoutLight) {
  const auto path = fresh_folder("gltf_materials") / "model.glb";
  Scene scene = two_plates();
  scene.materials[1].double_sided = true;
  const scene::VertexLight light = light_on(scene);
  for (const scene::VertexLight* lit : {static_cast<const scene::VertexLight*>(nullptr), &light}) {
    ASSERT_TRUE(write_glb({scene, lit}, path).ok());
    const std::vector<scene::Material> read = readers::read_file(path).scene.materials;
    ASSERT_EQ(read.size(), 3u) << "the unnamed one first";
    for (const std::size_t i : {1u, 2u}) {
      EXPECT_EQ(read[i].name, scene.materials[i].name);
      EXPECT_EQ(bits_of(read[i].reflectance), bits_of(scene.materials[i].reflectance));
      EXPECT_TRUE(read[i].reflectance_stated);
      EXPECT_EQ(read[i].double_sided, scene.materials[i].double_sided);
      const bool luminance = read[i].emission_unit == scene::Material::EmissionUnit::Luminance;
      EXPECT_EQ(luminance, lit == nullptr);
      const geom::dvec3 exitance = read[i].emission * (luminance ? std::numbers::pi : 1.0);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(exitance[c], scene.materials[i].emission[c], lit == nullptr ? 1e-13 : 0);
    }
  }
}

TEST(Gltf, RemembersThatAReflectanceIsNotStated) {
  const auto path = fresh_folder("gltf_unstated") / "model.glb";
  Scene scene = two_plates();
  scene.materials[1].reflectance_stated = false;
  scene.materials[2].reflectance = {1.5, -0.25, std::nan("")};
  ASSERT_TRUE(write_glb({scene}, path).ok());
  EXPECT_EQ(Glb(bytes_of(path)).document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"],
            json({1.0, 0.0, 0.0, 1.0}));
  const std::vector<scene::Material> read = readers::read_file(path).scene.materials;
  EXPECT_FALSE(read[1].reflectance_stated);
  EXPECT_EQ(bits_of(read[2].reflectance), bits_of({1.5, -0.25, 0}));
}

TEST(Gltf, ShowsLightAsColoursOfUnlitMaterials) {
  const Scene scene = two_plates();
  const scene::VertexLight light = light_on(scene);
  const Glb glb = written({.scene = scene, .light = &light, .marked_incomplete = true}, "gltf_light");
  EXPECT_EQ(glb.document["extensionsUsed"], json({"KHR_materials_unlit"}));
  EXPECT_TRUE(glb.document["materials"][0]["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(glb.document["materials"][1]["extras"]["radfix"]["exitance"], json({30.0, 20.0, 10.0}));
  const json& record = glb.document["asset"]["extras"]["radfix"];
  EXPECT_EQ(record, json({{"exposure", 0.125}, {"clampedShare", 0.25}, {"curve", "linear"}, {"incomplete", true}}));
  const json& attributes = glb.document["meshes"][1]["primitives"][0]["attributes"];
  const json& colours = glb.document["accessors"][attributes["COLOR_0"].get<std::size_t>()];
  const json& radiosity = glb.document["accessors"][attributes["_RADIOSITY"].get<std::size_t>()];
  EXPECT_EQ(colours["normalized"], true);
  constexpr std::array<std::size_t, 4> kVerticesOfRight = {1, 2, 4, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<std::uint16_t, 4> colour;
    std::memcpy(colour.data(), glb.element(colours, i), sizeof colour);
    glm::vec3 b;
    std::memcpy(&b, glb.element(radiosity, i), sizeof b);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(b[c], static_cast<float>(light.radiosity[kVerticesOfRight[i]][c]));
      EXPECT_NEAR(colour[static_cast<std::size_t>(c)], 65535 * light.colour[kVerticesOfRight[i]][c], 0.5);
    }
    EXPECT_EQ(colour[3], 65535);
  }
}

TEST(Gltf, KeepsNamesAndReplacesBytesThatAreNotUtf8) {
  const auto folder = fresh_folder("gltf_names");
  Scene scene = two_plates();
  scene.objects[1] = "Küche \"groß\" 台所";
  scene.objects[2] = "bad \xFF byte";
  scene.materials[1].name = "pale blue #2";
  for (const char* name : {"a b.glb", "Küche 100%.gltf"}) {
    ASSERT_EQ(write({scene}, folder / name), "");
    const readers::ReadResult read = readers::read_file(folder / name);
    EXPECT_TRUE(read.issues.all().empty()) << read.issues.all().front().what;
    EXPECT_EQ(read.scene.objects[1], scene.objects[1]);
    EXPECT_EQ(read.scene.objects[2], "bad \xEF\xBF\xBD byte");
    EXPECT_EQ(read.scene.materials[1].name, "pale blue #2");
  }
  EXPECT_THAT(bytes_of(folder / "Küche 100%.gltf"), HasSubstr("\"uri\":\"K%C3%BCche%20100%25.bin\""));
}

// A strip of triangles with so many vertices in one object.
Scene strip(std::size_t vertices) {
  scene::SceneBuilder builder("", "obj");
  for (std::size_t i = 0; i < vertices; ++i) {
    builder.add_vertex({static_cast<double>(i / 2), static_cast<double>(i % 2), 0});
  }
  for (scene::VertexId i = 0; i + 2 < vertices; ++i) {
    builder.add_face(std::vector<scene::VertexId>{i + i % 2, i + 1 - i % 2, i + 2}, i);
  }
  return builder.take();
}

TEST(Gltf, CountsVerticesIn16BitsAsLongAsTheyFit) {
  const auto path = fresh_folder("gltf_many") / "model.glb";
  for (const std::size_t vertices : {65534u, 65535u, 70001u}) {
    const Scene scene = strip(vertices);
    ASSERT_TRUE(write_glb({scene}, path).ok());
    const json document = Glb(bytes_of(path)).document;
    EXPECT_EQ(document["accessors"][1]["componentType"], vertices < 65535 ? 5123 : 5125);
    const Scene read = readers::read_file(path).scene;
    EXPECT_EQ(read.vertices.size(), vertices);
    EXPECT_EQ(facets_of(read, false), facets_of(scene, false));
  }
}

TEST(Gltf, AlignsEveryViewAndAccessor) {
  Scene scene = two_plates();
  const scene::VertexLight light = light_on(scene);
  const json document = written({scene, &light}, "gltf_aligned").document;
  for (const json& view : document["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
  for (const json& accessor : document["accessors"]) {
    const json& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const bool indices = accessor["type"] == "SCALAR";
    EXPECT_EQ(view["target"], indices ? 34963 : 34962);
    EXPECT_EQ(view.contains("byteStride"), !indices);
    EXPECT_EQ(accessor["byteOffset"].get<int>() % (indices ? 2 : 4), 0);
  }
}

}  // namespace
}  // namespace rad::writers
