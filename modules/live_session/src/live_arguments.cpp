#include "live_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr std::size_t kTextMax = 200;
constexpr std::size_t kNameMax = 64;

bool is_file_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return name.size() <= kNameMax && name.front() != '.' && std::all_of(name.begin(), name.end(), is_plain);
}

}  // namespace

const nlohmann::json* LiveArguments::find(const char* key) {
  known_.insert(key);
  const auto found = json_.find(key);
  return found == json_.end() || found->is_null() ? nullptr : &*found;
}

std::string LiveArguments::text(const char* key) {
  const auto* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_string() || value->get_ref<const std::string&>().size() > kTextMax) {
    wrong(key, fmt::format("must be a text of at most {} characters", kTextMax));
    return {};
  }
  return value->get<std::string>();
}

std::string LiveArguments::needed_text(const char* key) {
  std::string value = text(key);
  if (value.empty()) wrong(key, "is missing");
  return value;
}

std::string LiveArguments::name(const char* key) {
  std::string value = text(key);
  if (value.empty() || is_file_name(value)) return value;
  wrong(key, "must be letters, digits, '-', '_' and '.', at most 64, not beginning with a dot");
  return {};
}

std::string LiveArguments::needed_name(const char* key) {
  const bool is_there = json_.contains(key);
  std::string value = name(key);
  const bool is_empty = is_there && json_[key].is_string() && json_[key].get<std::string>().empty();
  if (!is_there || is_empty) wrong(key, "is missing");
  return value;
}

std::optional<double> LiveArguments::number(const char* key) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number() && std::isfinite(value->get<double>())) return value->get<double>();
  wrong(key, "must be a number");
  return std::nullopt;
}

std::optional<std::uint64_t> LiveArguments::count(const char* key, std::uint64_t max) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number_unsigned() && value->get<std::uint64_t>() <= max) return value->get<std::uint64_t>();
  wrong(key, fmt::format("must be a whole number from 0 to {}", max));
  return std::nullopt;
}

bool LiveArguments::flag(const char* key) {
  const auto* value = find(key);
  if (value == nullptr) return false;
  if (value->is_boolean()) return value->get<bool>();
  wrong(key, "must be true or false");
  return false;
}

Problems LiveArguments::problems() const {
  Problems problems = problems_;
  for (const auto& [key, value] : json_.items()) {
    if (!known_.contains(key)) problems.push_back({{"", 0, key}, "is not known here"});
  }
  return problems;
}

}  // namespace aisle
