// Suppressions beside a model that cannot hold comments, or that is not one's own: room.stl.radlint.toml.
#pragma once

#include <string>
#include <vector>

#include "config/keys.h"
#include "scene/waiver.h"

namespace rad::config {

/// Where the suppressions of a model are looked for.
std::string sidecar_path(const std::string& model);

/// What the file at this path asks; nothing where there is none. A file that is not understood gives a waiver with a
/// fault and no other.
std::vector<scene::Waiver> read_sidecar(const std::string& path);

/// Keys of [[suppress]], the only table of such a file.
std::vector<KeyText> sidecar_keys();

}  // namespace rad::config
