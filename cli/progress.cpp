#include "cli/progress.h"

#include <fmt/format.h>

#include "report/text_layout.h"

namespace rad::cli {

void Progress::show(std::size_t index, std::string_view path) {
  line_.show(fmt::format("{}/{} {}", index + 1, total_, report::printable(path)));
}

}  // namespace rad::cli
