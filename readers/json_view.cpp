#include "readers/json_view.h"

#include <cmath>

namespace rad::readers {

namespace {

// glTF allows a whole number to be spelt with a fraction of zero; beyond 2^53 a double no longer says which is meant.
constexpr double kWholeDoubles = 9007199254740992.0;

std::optional<std::uint64_t> as_whole(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const double number = value.get<double>();
  if (!(number >= 0 && number <= kWholeDoubles) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

}  // namespace

std::optional<Json> parse_json_object(std::string_view text, std::uint64_t offset, std::string_view format,
                                      scene::ReadIssues& issues) {
  std::string what;
  std::uint64_t at = offset;
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (json.is_object()) return json;
    what = "the JSON is not an object, so this is not " + std::string(format);
  } catch (const Json::parse_error& error) {
    what = "not well-formed JSON";
    at += error.byte > 0 ? error.byte - 1 : 0;
  } catch (const Json::exception&) {
    what = "the JSON holds a number that no double can";
  }
  scene::ReadIssue issue;
  issue.what = std::move(what);
  issue.place.byte_offset = at;
  issues.add(std::move(issue));
  return std::nullopt;
}

std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

void add_parse_error(scene::ReadIssues& issues, std::string what, std::string pointer) {
  scene::ReadIssue issue;
  issue.kind = scene::ReadIssueKind::ParseError;
  issue.what = std::move(what);
  issue.place.pointer = std::move(pointer);
  issues.add(std::move(issue));
}

const Json* JsonView::find(std::string_view key) const {
  if (object_ == nullptr || !object_->is_object()) return nullptr;
  const auto found = object_->find(key);
  return found == object_->end() ? nullptr : &*found;
}

const Json* JsonView::find_array(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return nullptr;
  if (value->is_array()) return value;
  report(key, "an array");
  return nullptr;
}

std::string JsonView::pointer_to(std::string_view key) const { return pointer_ + "/" + std::string(key); }

void JsonView::report(std::string_view key, std::string_view expected) const {
  add_parse_error(*issues_, "\"" + std::string(key) + "\" is not " + std::string(expected), pointer_to(key));
}

std::optional<std::uint64_t> JsonView::whole(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto number = as_whole(*value);
  if (!number) report(key, "a whole number from 0");
  return number;
}

std::optional<double> JsonView::number(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) return value->get<double>();
  report(key, "a number");
  return std::nullopt;
}

std::optional<bool> JsonView::flag(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_boolean()) return value->get<bool>();
  report(key, "true or false");
  return std::nullopt;
}

std::string JsonView::text(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  report(key, "a string");
  return {};
}

std::optional<std::vector<double>> JsonView::numbers(std::string_view key, std::size_t count) const {
  const Json* array = find_array(key);
  if (array == nullptr) return std::nullopt;
  std::vector<double> result;
  for (const Json& value : *array) {
    if (value.is_number() && result.size() < count) result.push_back(value.get<double>());
  }
  if (array->size() == count && result.size() == count) return result;
  report(key, "an array of " + std::to_string(count) + " numbers");
  return std::nullopt;
}

std::vector<std::uint64_t> JsonView::wholes(std::string_view key) const {
  std::vector<std::uint64_t> result;
  const Json* array = find_array(key);
  if (array == nullptr) return result;
  for (std::size_t i = 0; i < array->size(); ++i) {
    if (const auto number = as_whole((*array)[i])) {
      result.push_back(*number);
    } else {
      add_parse_error(*issues_, "not a whole number from 0", pointer_to(key) + "/" + std::to_string(i));
    }
  }
  return result;
}

std::vector<std::string> JsonView::texts(std::string_view key) const {
  std::vector<std::string> result;
  const Json* array = find_array(key);
  if (array == nullptr) return result;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Json& value = (*array)[i];
    if (value.is_string()) {
      result.push_back(value.get<std::string>());
    } else {
      add_parse_error(*issues_, "not a string", pointer_to(key) + "/" + std::to_string(i));
    }
  }
  return result;
}

JsonView JsonView::object(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return {};
  if (value->is_object()) return JsonView(*value, pointer_to(key), *issues_);
  report(key, "an object");
  return {};
}

JsonView JsonView::extension(std::string_view name) const {
  if (!has("extensions")) return {};
  return object("extensions").object(name);
}

const Json* JsonView::recorded(std::string_view key) const {
  const Json* json = object_;
  for (const std::string_view step : {std::string_view("extras"), std::string_view("radfix"), key}) {
    if (json == nullptr || !json->is_object()) return nullptr;
    const auto found = json->find(step);
    json = found == json->end() ? nullptr : &*found;
  }
  return json;
}

std::size_t JsonView::length(std::string_view key) const {
  const Json* array = find_array(key);
  return array == nullptr ? 0 : array->size();
}

JsonView JsonView::item(std::string_view key, std::uint64_t index) const {
  if (object_ == nullptr) return {};
  const Json* array = find_array(key);
  const std::string pointer = pointer_to(key) + "/" + std::to_string(index);
  if (array == nullptr || index >= array->size()) {
    add_parse_error(*issues_, "the file refers to " + pointer + ", which does not exist", pointer);
    return {};
  }
  const Json& value = (*array)[index];
  if (value.is_object()) return JsonView(value, pointer, *issues_);
  add_parse_error(*issues_, "not an object", pointer);
  return {};
}

}  // namespace rad::readers
