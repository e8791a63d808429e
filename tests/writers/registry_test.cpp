#include "writers/registry.h"

#include <gtest/gtest.h>

namespace rad::writers {
namespace {

TEST(Registry, FindsAWriterByExtensionInAnyCase) {
  for (const char* name : {"a.obj", "b/c.PLY", "d.Stl", "e.off", "f.x.glb", "g.glTF", "h.Stage.json"}) {
    EXPECT_NE(writer_for(name), nullptr) << name;
  }
  EXPECT_EQ(writer_for("a.GLB"), writer_for("b.glb"));
  EXPECT_NE(writer_for("a.glb"), writer_for("a.gltf"));
  for (const char* name : {"a", "glb", ".glb", "a.dae", "a.glb.gz", "a.json", "stage.json", ""})
    EXPECT_EQ(writer_for(name), nullptr) << name;
}

TEST(Registry, ListsWhatItWrites) { EXPECT_EQ(writable_extensions(), "obj, ply, stl, off, draco.glb, glb, gltf, drc, rad, dxf, city.json, cityjson, 3mf, stage.json"); }

TEST(Registry, KnowsWhatFormatsHold) {
  EXPECT_TRUE(writer_for("a.glb")->triangles_only);
  EXPECT_TRUE(writer_for("a.stl")->triangles_only);
  EXPECT_FALSE(writer_for("a.ply")->triangles_only);
  EXPECT_TRUE(writer_for("a.ply")->carries_light);
  EXPECT_FALSE(writer_for("a.obj")->carries_light);
  EXPECT_TRUE(writer_for("a.stage.json")->between_filters);
  EXPECT_TRUE(writer_for("a.gltf")->carries_legend);
}

}  // namespace
}  // namespace rad::writers
