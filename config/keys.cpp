#include "config/keys.h"

namespace rad::config {

const std::string& Entry::text() const {
  if (member.value.kind != Value::Kind::Text) fail("a text in quotes is expected");
  return member.value.text;
}

double Entry::number() const {
  if (member.value.kind != Value::Kind::Number) fail("a number is expected");
  return member.value.number;
}

std::vector<std::string> Entry::texts() const {
  if (member.value.kind == Value::Kind::Text) return {member.value.text};
  if (member.value.kind != Value::Kind::List) fail("a list of texts is expected");
  std::vector<std::string> texts;
  for (const Value& item : member.value.items) {
    if (item.kind != Value::Kind::Text) {
      throw ConfigFault(file, item.line, member.key + ": a list of texts is expected, and here is something else");
    }
    texts.push_back(item.text);
  }
  return texts;
}

const Value& Entry::table() const {
  if (member.value.kind != Value::Kind::Table) fail("a table is expected");
  return member.value;
}

const std::vector<Value>& Entry::tables() const {
  const auto is_table = [](const Value& item) { return item.kind == Value::Kind::Table; };
  if (member.value.kind != Value::Kind::List || !std::ranges::all_of(member.value.items, is_table)) {
    fail("tables are expected: [[" + member.key + "]]");
  }
  return member.value.items;
}

void TableReader::refuse_others() const {
  for (const Member& member : table_.members) {
    if (std::ranges::find(known_, member.key) != known_.end()) continue;
    const std::string in = name_.empty() ? std::string() : " in " + std::string(name_);
    throw ConfigFault(file_, member.line,
                      "unknown key '" + member.key + "'" + in + did_you_mean(nearest(member.key, known_)));
  }
}

}  // namespace rad::config
