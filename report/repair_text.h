// What a run of radfix did, as text for people.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "report/repair_report.h"

namespace rad::report {

struct RepairTextOptions {
  bool color = false;
  std::size_t width = 80;  ///< columns
  std::string picture;     ///< path of the picture that was written; empty for none
  std::string annotated;   ///< path of the annotated model that was written; empty for none
  bool diff = false;       ///< with what changed, place by place
  std::string twin;        ///< path of the compressed twin that was written; empty for none
  std::uint64_t twin_bytes = 0;
  std::string viewer;  ///< path of the page that shows the solution; empty for none
};

/// Input with its verdict; what repair, mesh and solution did, stage by stage; the written file with its verdict. Needs
/// `report.after`.
std::string text(const RepairReport& report, const RepairTextOptions& options = {});

}  // namespace rad::report
