#include "config/fault.h"

#include "report/printable.h"

namespace rad::config {

namespace {

std::string full_text(const std::string& file, std::uint64_t line, const std::string& what) {
  const std::string place = line > 0 ? file + ":" + std::to_string(line) : file;
  return report::printable(place + ": " + what);
}

}  // namespace

ConfigFault::ConfigFault(const std::string& file, std::uint64_t line, const std::string& what)
    : std::runtime_error(full_text(file, line, what)), line_(line), clause_(report::printable(what)) {}

}  // namespace rad::config
