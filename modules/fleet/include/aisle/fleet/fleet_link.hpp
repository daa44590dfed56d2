#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace aisle {

/// A message on one of a vehicle's topics.
struct FleetMessage {
  std::string topic;  ///< the last word of it: "order", "instantActions"
  std::string json;
};

/// How a vehicle reaches its master control. What is sent while there is no connection is lost: a state is
/// worth nothing once it is old.
class FleetLink {
 public:
  virtual ~FleetLink() = default;
  virtual bool is_connected() const = 0;
  /// How often a connection was made; more than before: the other side may have missed anything.
  virtual std::size_t connections() const = 0;
  /// What has come since the last call, oldest first.
  virtual std::vector<FleetMessage> take_received() = 0;
  virtual void send(const FleetMessage& message, bool is_retained) = 0;
};

}  // namespace aisle
