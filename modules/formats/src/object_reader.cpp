#include "object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "aisle/core/former_keys.hpp"
#include "field_reader.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kTextMax = 200;
constexpr std::size_t kPointsMax = 10'000;

long line_at(const YAML::Node& node) {
  return std::max(0, node.Mark().line) + 1;
}

std::string text_of(const YAML::Node& node) {
  return node.IsScalar() ? node.Scalar() : std::string("a list or map");
}

std::string known_keys(const ObjectFields& fields, const std::vector<ObjectReader::Section>& sections) {
  std::vector<std::string_view> keys;
  keys.reserve(fields.size() + sections.size());
  for (const ObjectReader::Section& section : sections) keys.push_back(section.key);
  for (const ObjectField& field : fields) keys.push_back(field.key);
  return fmt::format("{}", fmt::join(keys, ", "));
}

template <class Entries>
auto find_key(const Entries& entries, std::string_view key) {
  return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.key == key; });
}

}  // namespace

ObjectReader::Section ObjectReader::constant(std::string_view key, std::string_view value) {
  const auto read = [this, value](const YAML::Node& node, const std::string& path) {
    if (!node.IsScalar() || node.Scalar() != value)
      problem(node, path, fmt::format("is not {}, the only one supported", value));
  };
  return {key, read, true};
}

void ObjectReader::read_map(const YAML::Node& map, const std::string& key, const ObjectFields& fields,
                            const std::vector<Section>& sections) {
  if (!map.IsMap()) {
    return problem(map, key, fmt::format("has no keys (known: {})", known_keys(fields, sections)));
  }
  lines_.emplace(key, line_at(map));
  std::set<std::string> seen;
  for (const auto& entry : map) {
    if (is_hopeless()) return;
    std::string name = text_of(entry.first);
    if (find_key(fields, name) == fields.end() && find_key(fields, present_key(name)) != fields.end())
      name = present_key(name);
    const std::string inner = key.empty() ? printable(name) : key + "." + printable(name);
    lines_.emplace(inner, line_at(entry.first));
    if (!seen.insert(name).second) problem(entry.first, inner, "is given twice");
    if (const auto field = find_key(fields, name); field != fields.end()) {
      read_field(entry.second, inner, *field);
    } else if (const auto section = find_key(sections, name); section != sections.end()) {
      section->read(entry.second, inner);
    } else {
      problem(entry.first, inner, fmt::format("unknown key (known: {})", known_keys(fields, sections)));
    }
  }
  const auto check_needed = [&](const auto& entry) {
    if (!entry.is_needed || seen.count(std::string(entry.key)) > 0) return;
    problem(map, key.empty() ? std::string(entry.key) : fmt::format("{}.{}", key, entry.key), "is missing");
  };
  std::for_each(fields.begin(), fields.end(), check_needed);
  std::for_each(sections.begin(), sections.end(), check_needed);
}

void ObjectReader::read_field(const YAML::Node& node, const std::string& key, const ObjectField& field) {
  if (const auto* real = std::get_if<double*>(&field.target)) {
    if (const auto value = number(node, key, field.range)) **real = *value * field.inner_unit;
  } else if (const auto* whole = std::get_if<std::uint64_t*>(&field.target)) {
    read_whole_number(node, key, **whole);
  } else if (const auto* count = std::get_if<int*>(&field.target)) {
    read_count(node, key, field.range, **count);
  } else if (const auto* flag = std::get_if<bool*>(&field.target)) {
    read_flag(node, key, **flag);
  } else if (const auto* point = std::get_if<PointTarget>(&field.target)) {
    read_point(node, key, field.range, *point);
  } else if (const auto* points = std::get_if<std::vector<Vec2>*>(&field.target)) {
    if (is_list(node, key) && is_room_left(node, key, node.size(), kPointsMax)) {
      read_points(node, key, field.range, **points);
    }
  } else if (const auto* text = std::get_if<std::string*>(&field.target)) {
    read_text(node, key, field, **text);
  } else {
    read_word(node, key, std::get<WordTarget>(field.target));
  }
}

bool ObjectReader::read_point(const YAML::Node& node, const std::string& key, Range range,
                              const PointTarget& target) {
  const std::vector<double*>& coordinates = target.coordinates;
  if (!node.IsSequence() || node.size() != coordinates.size()) {
    problem(node, key, coordinates.size() == 2 ? "is not [x, y]" : "is not [x, y, z]");
    return false;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (const auto value = number(node[i], key, range)) values.push_back(*value);
  }
  if (values.size() < coordinates.size()) return false;
  for (std::size_t i = 0; i < coordinates.size(); ++i) *coordinates[i] = values[i];
  return true;
}

void ObjectReader::read_points(const YAML::Node& node, const std::string& key, Range range,
                               std::vector<Vec2>& target) {
  for (std::size_t i = 0; i < node.size() && !is_hopeless(); ++i) {
    const std::string inner = fmt::format("{}[{}]", key, i);
    lines_.emplace(inner, line_at(node[i]));
    Vec2 p = Vec2::Zero();
    if (read_point(node[i], inner, range, {{&p.x(), &p.y()}})) target.push_back(p);
  }
}

void ObjectReader::read_text(const YAML::Node& node, const std::string& key, const ObjectField& field,
                             std::string& target) {
  if (!node.IsScalar()) return problem(node, key, "is not a text");
  if (node.Scalar().size() > kTextMax) {
    return problem(node, key, fmt::format("is longer than {} bytes", kTextMax));
  }
  if (!is_line_of_text(node.Scalar())) return problem(node, key, "is not a line of UTF-8 text");
  if (field.is_needed && node.Scalar().empty()) return problem(node, key, "is empty");
  target = node.Scalar();
}

void ObjectReader::read_word(const YAML::Node& node, const std::string& key, const WordTarget& target) {
  const auto& words = target.words;
  const auto found = std::find(words.begin(), words.end(), text_of(node));
  if (found != words.end()) return target.choose(static_cast<std::size_t>(found - words.begin()));
  problem(node, key, fmt::format("'{}' is none of {}", printable(text_of(node)), fmt::join(words, ", ")));
}

void ObjectReader::read_whole_number(const YAML::Node& node, const std::string& key, std::uint64_t& target) {
  const std::string text = text_of(node);
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, target);
  if (error == std::errc() && rest == end) return;
  problem(node, key, fmt::format("'{}' is not a whole number from 0 to {}", printable(text), UINT64_MAX));
}

void ObjectReader::read_count(const YAML::Node& node, const std::string& key, Range range, int& target) {
  const auto value = number(node, key, range);
  if (!value) return;
  if (*value != std::floor(*value)) return problem(node, key, "is not a whole number");
  target = static_cast<int>(*value);
}

void ObjectReader::read_flag(const YAML::Node& node, const std::string& key, bool& target) {
  const std::string text = text_of(node);
  if (text != "true" && text != "false") return problem(node, key, "is neither true nor false");
  target = text == "true";
}

std::optional<double> ObjectReader::number(const YAML::Node& node, const std::string& key, Range range) {
  const std::string text = text_of(node);
  const std::optional<double> value = parse_number(text);
  if (!value || !std::isfinite(*value)) {
    problem(node, key, fmt::format("'{}' is not a number", printable(text)));
    return std::nullopt;
  }
  if (*value < range.min || *value > range.max) {
    problem(node, key, fmt::format("{} is outside {:g} .. {:g}", printable(text), range.min, range.max));
    return std::nullopt;
  }
  return value;
}

bool ObjectReader::is_list(const YAML::Node& node, const std::string& key) {
  if (!node.IsSequence()) problem(node, key, "is not a list");
  return node.IsSequence();
}

bool ObjectReader::is_room_left(const YAML::Node& node, const std::string& key, std::size_t count,
                                std::size_t most) {
  if (count > most) problem(node, key, fmt::format("makes {} entries; at most {} are read", count, most));
  return count <= most;
}

void ObjectReader::problem(const YAML::Node& node, const std::string& key, std::string what) {
  problems_.add(line_at(node), key, std::move(what));
}

void ObjectReader::problem(const std::string& key, std::string what) {
  problems_.add(line_of(key), key, std::move(what));
}

/// The line of the key, else of the nearest key that contains it.
long ObjectReader::line_of(std::string key) const {
  while (lines_.count(key) == 0) {
    const std::size_t end = key.find_last_of(".[");
    if (end == std::string::npos) return lines_.at("");  // the file as a whole
    key.resize(end);
  }
  return lines_.at(key);
}

}  // namespace aisle
