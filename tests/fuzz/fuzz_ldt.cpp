// Arbitrary bytes as EULUMDAT: the reader must come back with a sound scene, whatever the bytes say.
#include "tests/fuzz/fuzzed_reader.h"

namespace rad::readers {
extern const Reader ldt_reader;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rad::tests::read_fuzzed(rad::readers::ldt_reader, data, size);
  return 0;
}
