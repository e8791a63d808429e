// "Did you mean", as the command line uses it.
#pragma once

#include "config/nearest.h"

namespace rad::cli {

using config::did_you_mean;
using config::nearest;

}  // namespace rad::cli
