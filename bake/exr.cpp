#include "bake/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <half.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace rad::bake {
namespace {

// zlib's 4 of 9: half the time of the default for a few per cent of the size.
constexpr int kZipLevel = 4;
constexpr double kLeastNormalHalf = 0x1p-14, kLargestHalf = 65504;

class StringStream : public Imf::OStream {
 public:
  explicit StringStream(std::string& bytes) : OStream("light map"), bytes_(bytes) {}
  void write(const char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    bytes_.resize(std::max(bytes_.size(), at_ + count));
    std::memcpy(bytes_.data() + at_, c, count);
    at_ += count;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }

 private:
  std::string& bytes_;
  std::size_t at_ = 0;
};

Imf::Header header_of(const ExrPicture& picture, const ExrHeader& said) {
  Imf::Header header(static_cast<int>(picture.width), static_cast<int>(picture.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = kZipLevel;
  const Imf::PixelType type = picture.precision == ExrPrecision::Half ? Imf::HALF : Imf::FLOAT;
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(type));
  header.channels().insert("coverage", Imf::Channel(Imf::HALF));
  Imf::addChromaticities(header, Imf::Chromaticities());  // their default is BT.709 with D65
  if (said.white_luminance) Imf::addWhiteLuminance(header, static_cast<float>(*said.white_luminance));
  Imf::addComments(header, said.comments);
  header.insert("software", Imf::StringAttribute(said.software));
  header.insert("quantity", Imf::StringAttribute(said.quantity));
  header.insert("units", Imf::StringAttribute(said.units));
  return header;
}

std::vector<half> halves_of(std::span<const float> values) {
  std::vector<half> halves(values.size());
  std::transform(values.begin(), values.end(), halves.begin(), [](float value) { return half(value); });
  return halves;
}

// `channels` values for each texel, beginning with those of the first.
template <typename Value>
void insert(Imf::FrameBuffer& buffer, const char* name, const Value* first, std::size_t channels, std::size_t width) {
  const Imf::PixelType type = sizeof(Value) == sizeof(half) ? Imf::HALF : Imf::FLOAT;
  const std::size_t stride = channels * sizeof(Value);
  buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(const_cast<Value*>(first)), stride, stride * width));
}

}  // namespace

ExrPrecision precision_for(double least, double most) {
  return most <= 0 || (least >= kLeastNormalHalf && most <= kLargestHalf) ? ExrPrecision::Half : ExrPrecision::Float;
}

std::string exr_bytes(const ExrPicture& picture, const ExrHeader& header) {
  std::string bytes;
  StringStream stream(bytes);
  const int threads = tbb::this_task_arena::max_concurrency();
  if (Imf::globalThreadCount() < threads) Imf::setGlobalThreadCount(threads);
  const std::vector<half> coverage = halves_of(picture.coverage);
  std::vector<half> halves;
  Imf::FrameBuffer buffer;
  const char* const names[] = {"R", "G", "B"};
  if (picture.precision == ExrPrecision::Half) halves = halves_of(picture.rgb);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (picture.precision == ExrPrecision::Half) {
      insert(buffer, names[channel], halves.data() + channel, 3, picture.width);
    } else {
      insert(buffer, names[channel], picture.rgb.data() + channel, 3, picture.width);
    }
  }
  insert(buffer, "coverage", coverage.data(), 1, picture.width);
  {
    Imf::OutputFile file(stream, header_of(picture, header), threads);
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(picture.height));
  }
  return bytes;
}

}  // namespace rad::bake
