// Images of models go where the result goes.
#include <gmock/gmock.h>

#include "cli/radfix.h"
#include "readers/reader.h"
#include "run.h"
#include "tests/support/red_pixel.h"

namespace rad::cli {
namespace {

using testing::HasSubstr;

const std::string kFloor =
    "mtllib floor.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl oak\nf 1/1 2/2 3/3 4/4\n";
const std::string kPicture(tests::kRedPixel);

class CarriedImages : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("in/floor.mtl", "newmtl oak\nKd 0.5 0.5 0.5\nmap_Kd wood/oak.png\n");
    write("in/floor.obj", kFloor);
    write("in/wood/oak.png", kPicture);
    std::filesystem::create_directories(at("out"));
  }
  [[nodiscard]] int convert(const std::string& from, const std::string& to) const {
    return outcome_of(&run_radfix, {"convert", at(from), at(to)}).exit_code;
  }
  [[nodiscard]] scene::Image image_of(const std::string& file) const {
    const scene::Scene scene = readers::read_file(at(file)).scene;
    for (const scene::Material& material : scene.materials) {
      if (material.texture) return *material.texture->image;
    }
    ADD_FAILURE() << file << " has no image";
    return {};
  }
};

TEST_F(CarriedImages, LieInAGlb) {
  ASSERT_EQ(convert("in/floor.obj", "out/floor.glb"), 0);
  const scene::Image image = image_of("out/floor.glb");
  EXPECT_TRUE(image.embedded());
  EXPECT_EQ(image.media_type, "image/png");
  EXPECT_EQ(image.bytes, kPicture);
  EXPECT_FALSE(std::filesystem::exists(at("out/wood")));
}

TEST_F(CarriedImages, LieInAGlbAfterRepairToo) {
  const Outcome outcome = outcome_of(&run_radfix, {at("in/floor.obj"), "-o", at("out/floor.glb")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(image_of("out/floor.glb").bytes, kPicture);
}

TEST_F(CarriedImages, LieBesideOtherFormats) {
  for (const char* name : {"out/floor.obj", "out/floor.gltf"}) {
    ASSERT_EQ(convert("in/floor.obj", name), 0);
    EXPECT_EQ(image_of(name).path, "wood/oak.png");
    EXPECT_EQ(read("out/wood/oak.png"), kPicture);
  }
}

TEST_F(CarriedImages, OfAGlbBecomeFilesBesideAnObj) {
  ASSERT_EQ(convert("in/floor.obj", "in/floor.glb"), 0);
  ASSERT_EQ(convert("in/floor.glb", "out/back.obj"), 0);
  EXPECT_EQ(image_of("out/back.obj").path, "back.image-1.png");
  EXPECT_EQ(read("out/back.image-1.png"), kPicture);
}

TEST_F(CarriedImages, FromAboveTheFolderComeByTheirNames) {
  write("in/floor.mtl", "newmtl oak\nKd 0.5 0.5 0.5\nmap_Kd ../pictures/oak.png\n");
  write("pictures/oak.png", kPicture);
  std::filesystem::create_directories(at("deep/out"));
  ASSERT_EQ(convert("in/floor.obj", "deep/out/floor.obj"), 0);
  EXPECT_EQ(image_of("deep/out/floor.obj").path, "oak.png");
  EXPECT_EQ(read("deep/out/oak.png"), kPicture);
}

TEST_F(CarriedImages, NeverTakeThePlaceOfAnother) {
  write("out/wood/oak.png", "mine");
  const Outcome outcome = outcome_of(&run_radfix, {"convert", at("in/floor.obj"), at("out/floor.obj")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is there already and is another image"));
  EXPECT_EQ(read("out/wood/oak.png"), "mine");
  EXPECT_FALSE(std::filesystem::exists(at("out/floor.obj")));
}

TEST_F(CarriedImages, ThatAreNowhere_StayNamed) {
  std::filesystem::remove(at("in/wood/oak.png"));
  for (const char* name : {"out/floor.obj", "out/floor.gltf", "out/floor.glb"}) {
    ASSERT_EQ(convert("in/floor.obj", name), 0);
    EXPECT_EQ(image_of(name).path, "wood/oak.png");
  }
}

}  // namespace
}  // namespace rad::cli
