// RL902: a report that lists fewer findings than there are says so.
#pragma once

#include "report/report.h"

namespace rad::report {

/// Adds RL902 at this severity where a list of at most `max_issues` findings of a rule (0: all) leaves something of the
/// input out, or the report that it was read from did. Nothing where it is there already.
void note_truncation(InputReport& input, std::size_t max_issues, scene::Severity severity);

/// Takes RL902 out again: how long a list was is nothing that two judgements of a model differ in.
void forget_truncation(Report& report);

}  // namespace rad::report
