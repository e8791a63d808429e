// One finding in the list of a page.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "report/html/model_view.h"
#include "scene/finding.h"

namespace rad::report::html {

/// Where a finding stands on the page and in its view.
struct ItemPlace {
  std::string id;               ///< of the element
  std::size_t model = 0;        ///< number of the model on the page
  std::string fault;            ///< number of the fault in the view of the model; empty for none
  std::string attributes = {};  ///< more attributes, with a blank before each
  std::string remark = {};      ///< below the message
  const FaultView* view = nullptr;
};

std::string finding_item(const scene::Finding& finding, std::optional<double> metres_per_unit, const ItemPlace& place);

}  // namespace rad::report::html
