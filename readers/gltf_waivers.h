// What extras of a glTF document ask of radlint: {"radlint": {"ignore": ["RL221"], "reason": "…"}}.
#pragma once

#include <map>
#include <vector>

#include "readers/gltf_container.h"
#include "scene/waiver.h"

namespace rad::readers::gltf {

/// Objects that were made of each node with a mesh.
using ObjectsOfNodes = std::multimap<std::uint64_t, scene::ObjectId>;

/// Of the document or its asset (all of the file), nodes (their own meshes), meshes, primitives and materials. "ignore"
/// is a rule, a list of rules, or an object of rules and reasons; in place of the object may stand a text as in a
/// comment of OBJ: "ignore RL221 reason".
std::vector<scene::Waiver> read_waivers(const Document& document, const ObjectsOfNodes& objects,
                                        const std::vector<scene::MaterialId>& materials);

}  // namespace rad::readers::gltf
