#include "aisle/core/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/core/edit_distance.hpp"
#include "aisle/core/former_keys.hpp"

namespace aisle {
namespace {

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// `value` in a larger unit. The change of unit rounds: the 33 degrees that a variable holds must not become
/// 33.00000000000001.
double in_unit(double value, double unit) {
  const double exact = value / unit;
  const double with_fewer_digits = parse_number(fmt::format("{:.15g}", exact)).value_or(exact);
  return with_fewer_digits * unit == value ? with_fewer_digits : exact;
}

std::optional<bool> parse_flag(std::string_view text) {
  if (text == "true" || text == "yes" || text == "on") return true;
  if (text == "false" || text == "no" || text == "off") return false;
  return std::nullopt;
}

}  // namespace

std::string Field::value_text() const {
  if (const auto* real = std::get_if<double*>(&target)) return fmt::format("{}", in_unit(**real, inner_unit));
  if (const auto* count = std::get_if<int*>(&target)) return fmt::format("{}", **count);
  return *std::get<bool*>(target) ? "true" : "false";
}

void FieldList::add(std::string_view key, std::string_view doc, Range range, double inner_unit,
                    std::variant<double*, int*, bool*> target) {
  fields_.push_back({prefix_ + std::string(key), std::string(doc), range, inner_unit, target});
}

void FieldList::real(std::string_view key, double& target, Range range, std::string_view doc) {
  add(key, doc, range, 1, &target);
}

void FieldList::angle(std::string_view key, double& target_rad, Range range_deg, std::string_view doc) {
  add(key, doc, range_deg, kDegree, &target_rad);
}

void FieldList::count(std::string_view key, int& target, Range range, std::string_view doc) {
  add(key, doc, range, 1, &target);
}

void FieldList::flag(std::string_view key, bool& target, std::string_view doc) {
  add(key, doc, {}, 1, &target);
}

Problems FieldList::assign(std::string_view key, std::string_view text, Place where) {
  where.key = std::string(key);
  const auto named = [&](std::string_view name) {
    return std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.key == name; });
  };
  auto field = named(key);
  if (field == fields_.end()) field = named(present_key(key));
  if (field == fields_.end()) {
    std::string what = "unknown key";
    const auto nearest =
        std::min_element(fields_.begin(), fields_.end(), [&](const Field& a, const Field& b) {
          return edit_distance(a.key, key) < edit_distance(b.key, key);
        });
    if (nearest != fields_.end()) what += fmt::format(" (nearest known key: {})", nearest->key);
    return {{where, what}};
  }
  if (auto* flag = std::get_if<bool*>(&field->target)) {
    const auto value = parse_flag(text);
    if (!value) return {{where, fmt::format("'{}' is not true or false", text)}};
    **flag = *value;
    return {};
  }
  const auto value = parse_number(text);
  if (!value) return {{where, fmt::format("'{}' is not a number", text)}};
  if (*value < field->range.min || *value > field->range.max) {
    return {{where, fmt::format("{} is outside {:g} .. {:g}", text, field->range.min, field->range.max)}};
  }
  if (auto* count = std::get_if<int*>(&field->target)) {
    if (*value != std::round(*value)) return {{where, fmt::format("{} is not a whole number", text)}};
    **count = static_cast<int>(*value);
  } else {
    *std::get<double*>(field->target) = *value * field->inner_unit;
  }
  return {};
}

}  // namespace aisle
