#include "buildings/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "aisle/core/former_keys.hpp"

namespace aisle {
namespace {

constexpr std::size_t kNameBytesMax = 200;
constexpr std::size_t kColumnsMax = 100;

}  // namespace

bool JsonValue::is_text() const {
  if (!value_.is_string()) wrong("is not a text");
  return value_.is_string();
}

void JsonValue::read(std::string& target) const {
  if (is_text()) target = value_.get<std::string>();
}

void JsonValue::read(bool& target) const {
  if (!value_.is_boolean()) return wrong("is neither true nor false");
  target = value_.get<bool>();
}

void JsonValue::read_name(std::string& target) const {
  std::string name;
  if (value_.is_string()) name = value_.get<std::string>();
  if (name.empty() || name.size() > kNameBytesMax)
    return wrong(fmt::format("is not a text of 1 to {} bytes", kNameBytesMax));
  target = std::move(name);
}

void JsonValue::read_count(int& target, Range range) const {
  if (value_.is_number_integer() && value_ >= range.min && value_ <= range.max) {
    target = value_.get<int>();
  } else if (range.min == 0 && range.max == std::numeric_limits<int>::max()) {
    wrong("is not a whole number from 0 on");
  } else {
    wrong(fmt::format("is not a whole number from {} to {}", static_cast<int>(range.min),
                      static_cast<int>(range.max)));
  }
}

void JsonValue::read_count(std::uint64_t& target) const {
  if (!value_.is_number_unsigned()) return wrong("is not a whole number from 0 on");
  target = value_.get<std::uint64_t>();
}

void JsonValue::read_number(double& target, Range range) const {
  const bool fits =
      value_.is_number() && value_.get<double>() >= range.min && value_.get<double>() <= range.max;
  if (!fits) return wrong(fmt::format("is not a number from {:g} to {:g}", range.min, range.max));
  target = value_.get<double>();
}

void JsonValue::read_numbers(std::span<double* const> targets, Range range) const {
  if (!is_list_of(targets.size())) return;
  for (std::size_t i = 0; i < targets.size(); ++i) element(i).read_number(*targets[i], range);
}

bool JsonValue::is_list() const {
  if (!value_.is_array()) wrong("is not a list");
  return value_.is_array();
}

bool JsonValue::is_list_of(std::size_t count) const {
  const bool fits = value_.is_array() && value_.size() == count;
  if (!fits) wrong(fmt::format("is not a list of {}", count));
  return fits;
}

bool JsonValue::is_list_up_to(std::size_t count_max) const {
  if (!is_list()) return false;
  if (value_.size() > count_max) wrong(fmt::format("has more than {} elements", count_max));
  return value_.size() <= count_max;
}

JsonValue JsonValue::element(std::size_t index) const {
  return {value_[index], fmt::format("{}[{}]", path_, index), problems_};
}

void JsonValue::for_each_object(std::size_t count_max,
                                const std::function<void(const JsonValue&)>& read) const {
  if (!value_.is_object()) {
    if (!is_list_up_to(count_max)) return;
    for (std::size_t i = 0; i < size(); ++i) read(element(i));
    return;
  }
  is_object_of({"columns", "rows"});
  const auto columns = require("columns"), rows = require("rows");
  if (!columns || !rows || !columns->is_list_up_to(kColumnsMax) || !rows->is_list_up_to(count_max)) return;
  std::vector<std::string> keys(columns->size());
  for (std::size_t c = 0; c < keys.size(); ++c) columns->element(c).read(keys[c]);
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const JsonValue row = rows->element(i);
    if (!row.is_list_of(keys.size())) continue;
    auto object = nlohmann::json::object();
    for (std::size_t c = 0; c < keys.size(); ++c) {
      if (!row.value_[c].is_null()) object[keys[c]] = row.value_[c];
    }
    read(JsonValue(object, row.path_, problems_));
  }
}

bool JsonValue::is_object_of(const std::vector<std::string_view>& known) const {
  if (!value_.is_object()) {
    wrong("is not an object");
    return false;
  }
  const auto is_known = [&](std::string_view key) {
    return std::find(known.begin(), known.end(), key) != known.end();
  };
  for (const auto& member : value_.items()) {
    if (is_known(member.key())) continue;
    const std::string present = present_key(member.key());
    if (!is_known(present)) {
      problems_.add(0, path_to(member.key()), "unknown key");
    } else if (value_.contains(present)) {
      problems_.add(
          0, path_to(member.key()),
          fmt::format("is the former name of `{}`, which is there too: one of them is needed", present));
    }
  }
  return true;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  auto member = value_.find(key);
  if (member == value_.end()) {
    key = former_key(key);
    member = value_.find(key);
  }
  if (member == value_.end()) return std::nullopt;
  return JsonValue(*member, path_to(key), problems_);
}

std::optional<JsonValue> JsonValue::require(std::string_view key) const {
  auto member = find(key);
  if (!member) problems_.add(0, path_to(key), "is missing");
  return member;
}

std::string JsonValue::path_to(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

}  // namespace aisle
