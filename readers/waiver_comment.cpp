#include "readers/waiver_comment.h"

#include <algorithm>

namespace rad::readers {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kForm = "write '# radlint: ignore[RL221] reason' or '# radlint: ignore-file[RL221] reason'";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text = trimmed(text.substr(word.size()));
  return true;
}

void add_rules(std::string_view list, std::vector<std::string>& rules) {
  while (!list.empty()) {
    const std::string_view item = trimmed(list.substr(0, list.find(',')));
    list.remove_prefix(
        std::min(list.size(), list.find(',') == std::string_view::npos ? list.size() : list.find(',') + 1));
    if (!item.empty()) rules.emplace_back(item);
  }
}

// "[RL221, RL240] reason", or "RL221 reason".
void read_rules(std::string_view text, scene::Waiver& waiver) {
  const bool in_brackets = text.starts_with('[');
  const std::size_t end = in_brackets ? text.find(']') : std::min(text.find_first_of(kBlanks), text.size());
  if (end != std::string_view::npos) {
    add_rules(text.substr(in_brackets ? 1 : 0, end - (in_brackets ? 1 : 0)), waiver.rules);
    waiver.reason = trimmed(text.substr(std::min(text.size(), end + 1)));
  }
  if (waiver.rules.empty()) waiver.fault = "it names no rule; " + std::string(kForm);
}

}  // namespace

std::optional<WaiverComment> waiver_of_comment(std::string_view comment) {
  std::string_view text = trimmed(comment);
  while (text.starts_with('#')) text.remove_prefix(1);
  text = trimmed(text);
  if (!take(text, "radlint:")) return std::nullopt;
  WaiverComment result;
  result.whole_file = take(text, "ignore-file");
  if (result.whole_file || take(text, "ignore")) {
    read_rules(text, result.waiver);
  } else {
    result.waiver.fault = "it is not understood; " + std::string(kForm);
  }
  return result;
}

}  // namespace rad::readers
