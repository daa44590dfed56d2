#pragma once
/// The keys of an object in a building, each described in one line. From such a list follow which keys are
/// known, the reader and the writer.

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "buildings/json_text.hpp"
#include "buildings/json_value.hpp"
#include "object_fields.hpp"

namespace aisle {

inline constexpr Range kMapCoordinate_m = {-1e6, 1e6};

/// A key whose value is more than a plain field: a list, an object, or a text of its own kind.
struct JsonPart {
  std::string_view key;
  std::function<std::string()> text;  ///< as JSON; empty: the key is left out
  std::function<void(const JsonValue&)> read;
  bool is_needed = false;
};

using JsonField = std::variant<ObjectField, JsonPart>;

/// In the order in which they are read and written. Valid as long as the described object lives.
using JsonFields = std::vector<JsonField>;

JsonPart needed(JsonPart part);

/// A list that is left out where it is empty.
JsonPart unless_empty(JsonPart list);

/// Reads the value of one plain field.
void read_field(const JsonValue& value, const ObjectField& field);

/// The value of one plain field.
/// @param separator  between the numbers of a list
std::string field_json(const ObjectField& field, std::string_view separator = ", ");

std::vector<std::string_view> keys_of(const JsonFields& fields);

/// Reads all fields; unknown keys and missing needed ones are problems.
/// @return false if the value is not an object
bool read_object(const JsonValue& value, const JsonFields& fields);

/// `"key": value` of all fields that are not left out.
std::string members_json(const JsonFields& fields, std::string_view separator = ", ");

std::string object_json(const JsonFields& fields);

/// The values alone, as compact as they can be, for a table with the keys as columns; null: left out.
std::string row_json(const JsonFields& fields);

/// A heading in degrees, wrapped to [-180, 180).
JsonPart heading_part(std::string_view key, double& heading_rad, int decimal_count);

/// An object inside another; `fields_of` describes it.
template <class Object>
JsonPart object_part(std::string_view key, Object& object, JsonFields (*fields_of)(Object&)) {
  return {key, [&object, fields_of] { return object_json(fields_of(object)); },
          [&object, fields_of](const JsonValue& value) { read_object(value, fields_of(object)); }};
}

/// A list with one item a line.
/// @param text_of  an item as JSON  @param read  the value of an item
template <class Item, class TextOf, class Read>
JsonPart list_part(std::string_view key, std::vector<Item>& items, std::size_t count_max, TextOf text_of,
                   Read read) {
  return {key,
          [&items, text_of] {
            std::vector<std::string> texts;
            texts.reserve(items.size());
            for (Item& item : items) texts.push_back(text_of(item));
            return list_json(texts);
          },
          [&items, count_max, read](const JsonValue& value) {
            if (!value.is_list_up_to(count_max)) return;
            items.reserve(value.size());
            for (std::size_t i = 0; i < value.size(); ++i) items.push_back(read(value.element(i)));
          }};
}

/// A list of objects; `fields_of` describes one.
template <class Item>
JsonPart objects_part(std::string_view key, std::vector<Item>& items, std::size_t count_max,
                      JsonFields (*fields_of)(Item&)) {
  return list_part(
      key, items, count_max, [fields_of](Item& item) { return object_json(fields_of(item)); },
      [fields_of](const JsonValue& value) {
        Item item;
        read_object(value, fields_of(item));
        return item;
      });
}

}  // namespace aisle
