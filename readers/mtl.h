// MTL material libraries, as OBJ files name them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::readers {

/// The materials of a library in its order, one for each newmtl. Kd becomes the reflectance, Ke the exitance, map_Kd
/// the texture, with Kd as its factor; Ks, d, Tr, map_d and map_Ke become what a diffuse solution leaves out; every
/// other property is passed over. `path` is where issues say that they are.
std::vector<scene::Material> read_mtl(std::string_view bytes, const std::string& path, scene::ReadIssues& issues);

}  // namespace rad::readers
