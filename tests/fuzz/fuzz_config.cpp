// Arbitrary bytes as a radlint.toml: understood, or refused with a line and a reason.
#include <cstdint>
#include <cstdlib>

#include "config/config_file.h"
#include "config/fault.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    rad::config::config_of({reinterpret_cast<const char*>(data), size}, "/fuzzed/radlint.toml", "radlint.toml");
  } catch (const rad::config::ConfigFault& fault) {
    if (fault.clause().empty()) std::abort();
  }
  return 0;
}
