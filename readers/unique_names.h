// Names made unique: formats let any number of nodes and materials share one.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rad::readers {

class UniqueNames {
 public:
  /// The name itself where it is new, else "name (2)", "name (3)"….
  std::string claim(const std::string& name) {
    std::uint64_t& uses = uses_[name];
    if (++uses == 1) return name;
    while (true) {
      std::string numbered = name + " (" + std::to_string(uses) + ")";
      if (uses_.emplace(numbered, 1).second) return numbered;
      ++uses;
    }
  }

 private:
  std::map<std::string, std::uint64_t> uses_;
};

}  // namespace rad::readers
