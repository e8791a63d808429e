// Reads any bytes as a model and judges what was read: the whole way of `radlint FILE`.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "readers/reader.h"
#include "validate/lint.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rad;
  readers::Input input;
  input.path = "model.obj";
  input.directory = "/nonexistent";
  input.bytes = {reinterpret_cast<const char*>(data), size};
  input.limits.vertices = input.limits.faces = input.limits.corners = 2000;
  const readers::ReadResult read = readers::read_bytes(input);
  const validate::LintResult result = validate::lint(read.scene, read.issues, {});
  for (const scene::Finding& finding : result.findings) {
    if (finding.message.empty() || finding.fingerprint.empty() || finding.count == 0) std::abort();
  }
  return 0;
}
