#include "writers/zip.h"

#include <array>
#include <cstdint>

#include "writers/little_endian.h"

namespace rad::writers {
namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kCentralHeader = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint16_t kVersion = 20;
// 1 January 1980, the first day that the format knows.
constexpr std::uint16_t kNoTime = 0, kNoDate = 0x21;

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? 0xEDB88320u ^ (value >> 1) : value >> 1;
    table[i] = value;
  }
  return table;
}

std::uint32_t crc_of(std::string_view bytes) {
  static constexpr auto kTable = crc_table();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes) crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 0xFF] ^ (crc >> 8);
  return ~crc;
}

// What the local and the central header have in common.
void append_facts(std::string& out, const ZipEntry& entry) {
  append_bytes(out, kVersion);
  append_bytes(out, std::uint16_t{0});  // no flags
  append_bytes(out, std::uint16_t{0});  // stored
  append_bytes(out, kNoTime);
  append_bytes(out, kNoDate);
  append_bytes(out, crc_of(entry.bytes));
  append_bytes(out, static_cast<std::uint32_t>(entry.bytes.size()));
  append_bytes(out, static_cast<std::uint32_t>(entry.bytes.size()));
  append_bytes(out, static_cast<std::uint16_t>(entry.name.size()));
  append_bytes(out, std::uint16_t{0});  // no extra field
}

void append_central(std::string& out, const ZipEntry& entry, std::uint32_t offset) {
  append_bytes(out, kCentralHeader);
  append_bytes(out, kVersion);
  append_facts(out, entry);
  append_bytes(out, std::uint16_t{0});  // no comment
  append_bytes(out, std::uint16_t{0});  // first disk
  append_bytes(out, std::uint16_t{0});
  append_bytes(out, std::uint32_t{0});
  append_bytes(out, offset);
  out += entry.name;
}

}  // namespace

std::string zip_of(std::span<const ZipEntry> entries) {
  std::string archive, central;
  for (const ZipEntry& entry : entries) {
    append_central(central, entry, static_cast<std::uint32_t>(archive.size()));
    append_bytes(archive, kLocalHeader);
    append_facts(archive, entry);
    archive += entry.name;
    archive += entry.bytes;
  }
  const auto start = static_cast<std::uint32_t>(archive.size());
  archive += central;
  append_bytes(archive, kEnd);
  append_bytes(archive, std::uint32_t{0});  // one disk
  append_bytes(archive, static_cast<std::uint16_t>(entries.size()));
  append_bytes(archive, static_cast<std::uint16_t>(entries.size()));
  append_bytes(archive, static_cast<std::uint32_t>(central.size()));
  append_bytes(archive, start);
  append_bytes(archive, std::uint16_t{0});  // no comment
  return archive;
}

}  // namespace rad::writers
