// What a user chooses about reading.
#pragma once

#include <optional>

namespace rad::readers {

struct Choices {
  std::optional<double> level_of_detail;  ///< of CityJSON; nothing: the finest of each object. 2 stands for 2.x too
  bool allow_commands = false;            ///< run the "!command" lines of Radiance scenes
};

}  // namespace rad::readers
