// The variants of corpus/judge/scene_variants.h, for tests.
#pragma once

#include "corpus/judge/scene_variants.h"

namespace rad::tests {

using corpus::moved;
using corpus::rewritten;
using corpus::scaled;
using corpus::shuffled;

}  // namespace rad::tests
