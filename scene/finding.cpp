#include "scene/finding.h"

namespace rad::scene {

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "error";
}

std::string_view name(FindingKind kind) {
  switch (kind) {
    case FindingKind::Fail:
      return "fail";
    case FindingKind::Review:
      return "review";
    case FindingKind::Informational:
      return "informational";
  }
  return "fail";
}

std::string_view name(FixClass applicability) {
  switch (applicability) {
    case FixClass::Safe:
      return "safe";
    case FixClass::Unsafe:
      return "unsafe";
    case FixClass::Manual:
      return "manual";
    case FixClass::None:
      return "none";
  }
  return "none";
}

}  // namespace rad::scene
