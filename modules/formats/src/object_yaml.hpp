#pragma once
/// Objects as YAML, by the lists of their fields. `fields_of` of the object must be declared before.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "object_fields.hpp"

namespace aisle {

/// @param indent  of the lines after the first
std::string yaml_points(const std::vector<Vec2>& points, std::string_view indent);
std::string yaml_value(const ObjectField& field, std::string_view indent);

/// "key: value" of every field that is required or differs from its default.
template <class Object>
std::vector<std::string> yaml_entries(Object object, std::string_view indent) {
  Object plain;
  const ObjectFields fields = fields_of(object), plain_fields = fields_of(plain);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string value = yaml_value(fields[i], indent);
    if (!fields[i].is_needed && value == yaml_value(plain_fields[i], indent)) continue;
    texts.push_back(fmt::format("{}: {}", fields[i].key, value));
  }
  return texts;
}

template <class Object>
std::string yaml_map(const Object& object) {
  return fmt::format("{{{}}}", fmt::join(yaml_entries(object, "     "), ", "));
}

template <class Object>
std::string yaml_list(std::string_view key, const std::vector<Object>& objects) {
  if (objects.empty()) return {};
  std::string text = fmt::format("{}:\n", key);
  for (const Object& object : objects) text += fmt::format("  - {}\n", yaml_map(object));
  return text;
}

}  // namespace aisle
