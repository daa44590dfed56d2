#pragma once

#include "aisle/maps/room_route.hpp"
#include "option_kinds.hpp"

/// The words for the parking strategies.
/// @tparam Value  that a strategy can be assigned to
template <class Value>
Choices<Value> parking_choices() {
  Choices<Value> choices;
  for (const std::string_view word : aisle::kParkingWords)
    choices.emplace_back(std::string(word), aisle::parking_of(word).value());
  return choices;
}
