// ZIP archives whose files are stored as they are, without compression (PKWARE APPNOTE 4.3).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rad::writers {

struct ZipEntry {
  std::string_view name;  ///< ASCII, '/' between its parts
  std::string_view bytes;
};

/// The archive; entries carry no date, so that the same entries give the same bytes. Each must be below 4 GiB, and so
/// must their sum.
std::string zip_of(std::span<const ZipEntry> entries);

}  // namespace rad::writers
