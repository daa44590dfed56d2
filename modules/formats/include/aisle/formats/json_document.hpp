#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// The JSON document, or a problem with the line where it is malformed. Its values may take 16 times the
/// memory of the text, and whoever copies or prints them calls itself for every level: more than 16 MiB, or
/// levels that nest deeper than 64, are a problem, too.
/// @tparam Json  nlohmann::json, or nlohmann::ordered_json where the order of keys matters
template <class Json = nlohmann::json>
Result<Json> parse_json(std::string_view text, const std::string& name);

}  // namespace aisle
