#include "readers/late_parts.h"

#include "readers/ifc_helper.h"

namespace rad::readers {

namespace fs = std::filesystem;

fs::path step_library() {
#ifdef RAD_WITH_OCCT
  for (const char* candidate : {RAD_STEP_LIBRARY_BUILT, RAD_STEP_LIBRARY_INSTALLED}) {
    std::error_code error;
    if (fs::is_regular_file(candidate, error)) return candidate;
  }
#endif
  return {};
}

std::vector<fs::path> late_parts() {
  std::vector<fs::path> parts;
  for (fs::path part : {step_library(), ifc_helper()}) {
    if (!part.empty()) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace rad::readers
