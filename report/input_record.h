// The report of one input as bytes: between processes, and in the cache.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "report/report.h"

namespace rad::report {

/// All that an InputReport holds but what an HTML report shows.
std::string record_of(const InputReport& input);

/// Nothing where the bytes are no record of this version.
std::optional<InputReport> input_of_record(std::string_view bytes);

}  // namespace rad::report
