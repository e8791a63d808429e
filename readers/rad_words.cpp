#include "readers/rad_words.h"

#include <algorithm>

namespace rad::readers::radiance {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

void Words::skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

void Words::skip_blanks() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      skip_line();
    } else if (is_blank(text_[at_])) {
      next_line_ += text_[at_] == '\n' ? 1 : 0;
      ++at_;
    } else {
      return;
    }
  }
}

std::string_view Words::next() {
  skip_blanks();
  line_ = next_line_;
  if (at_ == text_.size()) return {};
  const char first = text_[at_];
  const std::size_t begin = at_;
  if (first == '"' || first == '\'') {
    const std::size_t end = std::min(text_.find_first_of(std::string{first, '\n'}, begin + 1), text_.size());
    at_ = end < text_.size() && text_[end] == first ? end + 1 : end;
    // Two quotes in a row are no end of the text.
    if (end > begin + 1) return text_.substr(begin + 1, end - begin - 1);
    return text_.substr(begin, 1);
  }
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

bool Words::at_end() {
  skip_blanks();
  return at_ == text_.size();
}

bool Words::at_command() {
  skip_blanks();
  return at_ < text_.size() && text_[at_] == '!';
}

std::string Words::command() {
  std::string command;
  line_ = next_line_;
  ++at_;
  while (true) {
    const std::size_t begin = at_;
    skip_line();
    command.append(text_.substr(begin, at_ - begin));
    if (!command.empty() && command.back() == '\r') command.pop_back();
    if (command.empty() || command.back() != '\\' || at_ == text_.size()) return command;
    command.back() = ' ';
    ++at_;
    ++next_line_;
  }
}

}  // namespace rad::readers::radiance
