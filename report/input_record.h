// The report of one input as bytes: between processes, and in the cache.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "report/detail.h"
#include "report/report.h"

namespace rad::report {

/// All that an InputReport of a run holds but what an HTML report shows and what a baseline knows.
std::string record_of(InputReport input);

/// Findings without what goes beyond `detail`: of thousands of inputs, most of the time goes into what few formats
/// show. Nothing where the bytes are no record of this version. Bytes that are damaged give nothing or another report,
/// never a crash: whoever keeps them checks them first.
std::optional<InputReport> input_of_record(std::string_view bytes, Detail detail = Detail::Drawings);

}  // namespace rad::report
