#include "config/toml_tree.h"

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
// On text that is damaged in some places the parser contradicts its own assumptions before it reports the fault.
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_MAX_NESTED_VALUES 16
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>

#include "config/fault.h"
#include "config/toml_outline.h"

namespace rad::config {

namespace {

static_assert(TOML_MAX_NESTED_VALUES == kDeepestValue);

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

Value value_of(const toml::node& node);

Value table_of(const toml::table& table) {
  Value value;
  value.kind = Value::Kind::Table;
  for (const auto& [key, node] : table) {
    value.members.push_back({plain_text(key.str()), key.source().begin.line, value_of(node)});
  }
  std::ranges::stable_sort(value.members, {}, &Member::line);
  return value;
}

Value list_of(const toml::array& array) {
  Value value;
  value.kind = Value::Kind::List;
  for (const toml::node& item : array) value.items.push_back(value_of(item));
  return value;
}

Value scalar_of(const toml::node& node) {
  Value value;
  if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::Text;
    value.text = plain_text(text->get());
  } else if (const auto* flag = node.as_boolean()) {
    value.kind = Value::Kind::Boolean;
    value.boolean = flag->get();
  } else if (const auto number = node.value<double>(); number && node.is_number()) {
    value.kind = Value::Kind::Number;
    value.number = *number;
  }
  return value;
}

Value value_of(const toml::node& node) {
  Value value = node.is_table()   ? table_of(*node.as_table())
                : node.is_array() ? list_of(*node.as_array())
                                  : scalar_of(node);
  value.line = node.source().begin.line;
  return value;
}

}  // namespace

Value parse_toml(std::string_view text, const std::string& file) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const AsciiToml ascii = ascii_toml(text, kMostNameParts);
  if (ascii.line > 0) throw ConfigFault(file, ascii.line, ascii.fault);
  const toml::parse_result result = toml::parse(std::string_view(ascii.text));
  if (!result) throw ConfigFault(file, result.error().source().begin.line, std::string(result.error().description()));
  return value_of(result.table());
}

std::string read_text(const std::string& path, const std::string& shown) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) throw ConfigFault(shown, 0, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kLargestFile) throw ConfigFault(shown, 0, "is larger than 1 MiB");
  return text;
}

}  // namespace rad::config
