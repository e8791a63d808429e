#include "bake/exr.h"

#include <gtest/gtest.h>
#include <openexr.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

namespace rad::bake {
namespace {

// Read by OpenEXR's C interface, which shares no code with the writer.
struct Opened {
  std::string bytes;
  exr_context_t context = nullptr;

  explicit Opened(std::string from) : bytes(std::move(from)) {
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.user_data = this;
    setup.read_fn = read;
    setup.size_fn = [](exr_const_context_t, void* self) {
      return static_cast<std::int64_t>(static_cast<Opened*>(self)->bytes.size());
    };
    EXPECT_EQ(exr_start_read(&context, "memory", &setup), EXR_ERR_SUCCESS);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() { exr_finish(&context); }

  static std::int64_t read(exr_const_context_t, void* self, void* into, std::uint64_t size, std::uint64_t offset,
                           exr_stream_error_func_ptr_t) {
    const std::string& all = static_cast<Opened*>(self)->bytes;
    const std::uint64_t count = offset < all.size() ? std::min<std::uint64_t>(size, all.size() - offset) : 0;
    std::memcpy(into, all.data() + offset, count);
    return static_cast<std::int64_t>(count);
  }

  std::string text(const char* name) const {
    const exr_attribute_t* attribute = nullptr;
    EXPECT_EQ(exr_get_attribute_by_name(context, 0, name, &attribute), EXR_ERR_SUCCESS) << name;
    return {attribute->string->str, static_cast<std::size_t>(attribute->string->length)};
  }

  // Values of every channel, by rows.
  std::map<std::string, std::vector<float>> values(int width, int height) {
    std::map<std::string, std::vector<float>> all;
    std::int32_t lines = 0;
    exr_get_scanlines_per_chunk(context, 0, &lines);
    for (int y = 0; y < height; y += lines) {
      exr_chunk_info_t chunk;
      exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
      EXPECT_EQ(exr_read_scanline_chunk_info(context, 0, y, &chunk), EXR_ERR_SUCCESS);
      EXPECT_EQ(exr_decoding_initialize(context, 0, &chunk, &decoder), EXR_ERR_SUCCESS);
      const auto rows = static_cast<std::size_t>(chunk.height), count = rows * static_cast<std::size_t>(width);
      std::vector<std::vector<float>> planes(static_cast<std::size_t>(decoder.channel_count),
                                             std::vector<float>(count));
      for (int i = 0; i < decoder.channel_count; ++i) {
        exr_coding_channel_info_t& channel = decoder.channels[i];
        channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(planes[static_cast<std::size_t>(i)].data());
        channel.user_bytes_per_element = 4;
        channel.user_data_type = EXR_PIXEL_FLOAT;
        channel.user_pixel_stride = 4;
        channel.user_line_stride = 4 * width;
      }
      EXPECT_EQ(exr_decoding_choose_default_routines(context, 0, &decoder), EXR_ERR_SUCCESS);
      EXPECT_EQ(exr_decoding_run(context, 0, &decoder), EXR_ERR_SUCCESS);
      for (int i = 0; i < decoder.channel_count; ++i) {
        std::vector<float>& into = all[decoder.channels[i].channel_name];
        const std::vector<float>& plane = planes[static_cast<std::size_t>(i)];
        into.insert(into.end(), plane.begin(), plane.end());
      }
      exr_decoding_destroy(context, &decoder);
    }
    return all;
  }
};

// Asymmetric, so that a row or a channel in the wrong place shows.
struct Picture {
  std::vector<float> rgb, coverage;
  Picture(std::uint32_t width, std::uint32_t height) {
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        rgb.insert(rgb.end(), {static_cast<float>(x), static_cast<float>(y), 0.25f * static_cast<float>(x + y)});
        coverage.push_back(y == 0 ? 0.5f : 1.0f);
      }
    }
  }
};

class ReadBack : public testing::TestWithParam<ExrPrecision> {};

TEST_P(ReadBack, EveryTexel_IsWhereItWas) {
  const Picture picture(37, 50);
  Opened file(exr_bytes({37, 50, picture.rgb, picture.coverage, GetParam()}, {"irradiance", "W/m2", "a", "b", {}}));
  const auto values = file.values(37, 50);
  ASSERT_EQ(values.size(), 4u);
  EXPECT_EQ(values.at("coverage"), picture.coverage);
  for (std::size_t i = 0; i < picture.coverage.size(); ++i) {
    EXPECT_EQ(values.at("R")[i], picture.rgb[3 * i]);
    EXPECT_EQ(values.at("G")[i], picture.rgb[3 * i + 1]);
    EXPECT_EQ(values.at("B")[i], picture.rgb[3 * i + 2]);
  }
}
INSTANTIATE_TEST_SUITE_P(Exr, ReadBack, testing::Values(ExrPrecision::Half, ExrPrecision::Float));

TEST(Exr, Header_SaysWhatTheNumbersAre) {
  const Picture picture(2, 2);
  Opened file(exr_bytes({2, 2, picture.rgb, picture.coverage, ExrPrecision::Half},
                        {"radiant exitance", "W/m2", "radfix 1", "page 0", 0.25}));
  EXPECT_EQ(file.text("quantity"), "radiant exitance");
  EXPECT_EQ(file.text("units"), "W/m2");
  EXPECT_EQ(file.text("software"), "radfix 1");
  EXPECT_EQ(file.text("comments"), "page 0");
  float white = 0;
  EXPECT_EQ(exr_attr_get_float(file.context, 0, "whiteLuminance", &white), EXR_ERR_SUCCESS);
  EXPECT_EQ(white, 0.25f);
  exr_attr_chromaticities_t primaries;
  EXPECT_EQ(exr_attr_get_chromaticities(file.context, 0, "chromaticities", &primaries), EXR_ERR_SUCCESS);
  EXPECT_FLOAT_EQ(primaries.red_x, 0.64f);
  EXPECT_FLOAT_EQ(primaries.white_y, 0.329f);
}

TEST(Exr, Precision_IsHalfWhereAllBitsAreKept) {
  EXPECT_EQ(precision_for(0x1p-14, 65504), ExrPrecision::Half);
  EXPECT_EQ(precision_for(0x1p-15, 1), ExrPrecision::Float);
  EXPECT_EQ(precision_for(1, 65505), ExrPrecision::Float);
  EXPECT_EQ(precision_for(std::numeric_limits<double>::infinity(), 0), ExrPrecision::Half);
}

}  // namespace
}  // namespace rad::bake
