#pragma once

#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/fleet/order.hpp"

namespace aisle {

/// Longer messages are refused unread.
inline constexpr std::size_t kFleetMessage_bytes = std::size_t{1} << 20;

/// Reads an `order`. Whatever the bytes, the result is an order whose sequence fits together, or problems
/// with their key ("nodes[2].sequenceId"). Keys that it does not know are passed over: the interface grows.
Result<Order> read_order(std::string_view json);

/// Reads `instantActions`.
Result<std::vector<FleetAction>> read_instant_actions(std::string_view json);

}  // namespace aisle
