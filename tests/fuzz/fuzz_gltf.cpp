// Arbitrary bytes as glTF or GLB: the reader must come back with a sound scene, whatever the bytes say.
#include <cstdint>
#include <cstdlib>

#include "readers/reader.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
extern const Reader gltf_reader;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rad::readers::Input input;
  input.path = "fuzzed.glb";
  // No companion can be found in a folder that does not exist.
  input.directory = "no-such-folder";
  input.bytes = {reinterpret_cast<const char*>(data), size};
  input.limits.vertices = 100'000;
  input.limits.faces = 100'000;
  input.limits.corners = 300'000;
  input.limits.instances = 1'000;
  const rad::readers::ReadResult result = rad::readers::gltf_reader.read(input);
  if (!rad::tests::broken_invariant(result.scene).empty()) std::abort();
  return 0;
}
