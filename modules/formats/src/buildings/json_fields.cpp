#include "buildings/json_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPathPointsMax = 100'000;

std::string number_json(double value, Digits digits) {
  switch (digits.kind) {
    case Digits::Kind::kDecimals:
      return decimals(value, digits.count);
    case Digits::Kind::kAllDecimals:
      return fmt::format("{:.{}f}", value, digits.count);
    case Digits::Kind::kSignificant:
      return fmt::format("{:.{}g}", value, digits.count);
  }
  return {};
}

void read_word(const JsonValue& value, const WordTarget& target) {
  const auto& words = target.words;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (value.is(words[i])) return target.choose(i);
  }
  const std::span but_last = words.first(words.size() - 1);
  if (words.size() == 2) return value.wrong(fmt::format(R"(is neither "{}" nor "{}")", words[0], words[1]));
  value.wrong(fmt::format(R"(is none of "{}" and "{}")", fmt::join(but_last, R"(", ")"), words.back()));
}

/// Writes the value that each kind of target has.
struct TargetText {
  Digits digits;
  double inner_unit;
  std::string_view separator;

  std::string operator()(const double* real) const { return number_json(*real / inner_unit, digits); }
  std::string operator()(const bool* flag) const { return *flag ? "true" : "false"; }
  std::string operator()(const std::string* text) const { return quoted_json(*text); }
  std::string operator()(const WordTarget& word) const {
    return fmt::format("\"{}\"", word.words[word.index()]);
  }
  std::string operator()(const PointTarget& point) const {
    std::vector<std::string> texts;
    for (const double* coordinate : point.coordinates) texts.push_back(number_json(*coordinate, digits));
    return fmt::format("[{}]", fmt::join(texts, separator));
  }
  std::string operator()(const std::vector<Vec2>* points) const {
    std::vector<std::string> texts;
    for (const Vec2& p : *points) texts.push_back(point_json(p, digits.count));
    return fmt::format("[{}]", fmt::join(texts, separator));
  }
  template <class Whole>
  std::string operator()(const Whole* whole) const {
    return std::to_string(*whole);
  }
};

/// Reads the value of each kind of target.
struct TargetReader {
  const JsonValue& value;
  const ObjectField& field;

  void operator()(double* real) const {
    double in_unit = std::nan("");
    value.read_number(in_unit, field.range);
    if (!std::isnan(in_unit)) *real = in_unit * field.inner_unit;
  }
  void operator()(int* count) const { value.read_count(*count, field.range); }
  void operator()(std::uint64_t* count) const { value.read_count(*count); }
  void operator()(bool* flag) const { value.read(*flag); }
  void operator()(std::string* text) const { field.is_needed ? value.read_name(*text) : value.read(*text); }
  void operator()(const WordTarget& word) const { read_word(value, word); }
  void operator()(const PointTarget& point) const { value.read_numbers(point.coordinates, field.range); }
  void operator()(std::vector<Vec2>* points) const {
    if (!value.is_list_up_to(kPathPointsMax)) return;
    for (std::size_t i = 0; i < value.size(); ++i) {
      Vec2& p = points->emplace_back(0, 0);
      value.element(i).read_numbers(std::array{&p.x(), &p.y()}, field.range);
    }
  }
};

std::string written_value(const JsonField& field, std::string_view separator) {
  if (const auto* part = std::get_if<JsonPart>(&field)) return part->text();
  return field_json(std::get<ObjectField>(field), separator);
}

std::string_view key_of(const JsonField& field) {
  return std::visit([](const auto& any) { return any.key; }, field);
}

}  // namespace

JsonPart needed(JsonPart part) {
  part.is_needed = true;
  return part;
}

JsonPart unless_empty(JsonPart list) {
  list.text = [text = std::move(list.text)] {
    std::string written = text();
    return written == list_json({}) ? "" : written;
  };
  return list;
}

void read_field(const JsonValue& value, const ObjectField& field) {
  std::visit(TargetReader{value, field}, field.target);
}

std::string field_json(const ObjectField& field, std::string_view separator) {
  return std::visit(TargetText{field.digits, field.inner_unit, separator}, field.target);
}

std::vector<std::string_view> keys_of(const JsonFields& fields) {
  std::vector<std::string_view> keys(fields.size());
  std::transform(fields.begin(), fields.end(), keys.begin(), key_of);
  return keys;
}

bool read_object(const JsonValue& value, const JsonFields& fields) {
  if (!value.is_object_of(keys_of(fields))) return false;
  for (const JsonField& field : fields) {
    const bool is_needed = std::visit([](const auto& any) { return any.is_needed; }, field);
    const auto member = is_needed ? value.require(key_of(field)) : value.find(key_of(field));
    if (!member) continue;
    if (const auto* part = std::get_if<JsonPart>(&field)) {
      part->read(*member);
    } else {
      read_field(*member, std::get<ObjectField>(field));
    }
  }
  return true;
}

std::string members_json(const JsonFields& fields, std::string_view separator) {
  std::vector<std::string> members;
  for (const JsonField& field : fields) {
    const std::string text = written_value(field, ", ");
    if (!text.empty()) members.push_back(fmt::format("\"{}\": {}", key_of(field), text));
  }
  return fmt::format("{}", fmt::join(members, separator));
}

std::string object_json(const JsonFields& fields) {
  return "{" + members_json(fields) + "}";
}

std::string row_json(const JsonFields& fields) {
  std::string row;
  for (const JsonField& field : fields) {
    const std::string text = written_value(field, ",");
    row += (row.empty() ? "[" : ",") + (text.empty() ? "null" : text);
  }
  return row + "]";
}

JsonPart heading_part(std::string_view key, double& heading_rad, int decimal_count) {
  return {key,
          [&heading_rad, decimal_count] {
            const std::string text = decimals(to_degrees(wrap_angle(heading_rad)), decimal_count);
            return text == "180" ? "-180" : text;  // as it is read again
          },
          [&heading_rad](const JsonValue& value) {
            read_field(value, field::angle("", heading_rad));
            heading_rad = wrap_angle(heading_rad);
          }};
}

}  // namespace aisle
