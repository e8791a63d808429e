#include "readers/components.h"

#include <algorithm>
#include <array>

#include "readers/unread_formats.h"

namespace rad::readers {

#ifdef RAD_WITH_ASSIMP
extern const Reader assimp_reader;
std::string assimp_version();
#endif
#ifdef RAD_WITH_OCCT
extern const Reader occt_reader;
std::string occt_version();
#endif
extern const Reader ifc_reader;
std::string ifc_version();

namespace {

std::array<Component, 3> make_components() {
  std::array<Component, 3> all = {{{"assimp", "COLLADA, FBX, 3DS, 3MF, X3D and LWO", kAssimpSuffixes, nullptr, {}},
                                   {"web-ifc", "IFC", kIfcSuffixes, nullptr, {}},
                                   {"OpenCASCADE", "STEP and IGES", kOcctSuffixes, nullptr, {}}}};
#ifdef RAD_WITH_ASSIMP
  all[0].reader = &assimp_reader;
  all[0].version = assimp_version();
#endif
#ifdef RAD_WITH_OCCT
  all[2].reader = &occt_reader;
  all[2].version = occt_version();
#endif
  all[1].reader = &ifc_reader;
  all[1].version = ifc_version();
  return all;
}

}  // namespace

std::span<const Component> components() {
  static const std::array<Component, 3> kComponents = make_components();
  return kComponents;
}

const Component* missing_component(const std::filesystem::path& path) {
  const std::string name = lower_case_name(path);
  for (const Component& component : components()) {
    const bool its_own = std::ranges::any_of(component.suffixes, [&](auto suffix) { return name.ends_with(suffix); });
    if (its_own && component.reader == nullptr) return &component;
  }
  return nullptr;
}

}  // namespace rad::readers
