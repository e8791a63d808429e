#include "writers/text_line.h"

namespace rad::writers {

std::string one_line(std::string_view text) {
  std::string clean(text);
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '_';
  }
  if (!clean.empty() && clean.back() == '\\') clean.back() = '_';
  return clean;
}

}  // namespace rad::writers
