// Lists of the keys that files of configuration may hold, for documents and for completion.
#pragma once

#include <vector>

#include "config/keys.h"

namespace rad::config {

enum class ConfigTable : unsigned char { Top, Files, Objects };

/// All keys of a table, in the order in which they are documented.
std::vector<KeyText> keys_of(ConfigTable table);

}  // namespace rad::config
