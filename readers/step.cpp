// STEP and IGES: the reader on OpenCASCADE is a library of its own, loaded with the first such file. To load it takes
// longer than to judge a small model of another format.
#include <dlfcn.h>

#include <filesystem>

#include "readers/components.h"
#include "readers/late_parts.h"

namespace rad::readers {

extern const Reader occt_reader;
std::string occt_version();

namespace {

using Read = void (*)(const Input& input, ReadResult& result);

/// Null where the library cannot be loaded; then `why` says so.
Read load(std::string& why) {
  const std::filesystem::path path = step_library();
  void* library = path.empty() ? nullptr : ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* read = library == nullptr ? nullptr : ::dlsym(library, "rad_read_step");
  if (read == nullptr) {
    const char* fault = path.empty() ? nullptr : ::dlerror();
    why = fault == nullptr ? "rad_occt.so is not where it was installed" : fault;
  }
  return reinterpret_cast<Read>(read);
}

ReadResult read_step(const Input& input) {
  static std::string why;
  static const Read kRead = load(why);
  ReadResult result;
  if (kRead != nullptr) {
    kRead(input, result);
    return result;
  }
  result.scene = scene::empty_scene(input.path, "step");
  scene::ReadIssue issue;
  issue.what = "the library that reads STEP and IGES cannot be loaded: " + why;
  result.issues.add(std::move(issue));
  return result;
}

// IGES has no mark at its head: the letter of the section stands in column 73.
bool sniff(std::string_view head) {
  if (head.starts_with("ISO-10303-21;")) return true;
  return head.size() > 80 && head[72] == 'S' && head.substr(73, 7) == "      1";
}

}  // namespace

std::string occt_version() { return RAD_OCCT_VERSION; }

const Reader occt_reader{"step", kOcctSuffixes, sniff, read_step};

}  // namespace rad::readers
