#pragma once

#include <string>
#include <variant>

#include "driver.hpp"
#include "ros/messages.hpp"
#include "ros/participant.hpp"

namespace robots {

/// Commands from /cmd_vel, in one of three types.
class CommandIntake {
 public:
  /// @param kind "twist", "twist_stamped" or "ackermann"
  CommandIntake(const Participant& participant, const std::string& topic, const std::string& kind);

  /// The oldest command that has not been taken. One with a stamp was given then, the others now.
  std::optional<Command> take(double now_s, const Time& now) const;

 private:
  using AnySubscription =
      std::variant<Subscription<Twist>, Subscription<TwistStamped>, Subscription<AckermannDriveStamped>>;

  AnySubscription subscription_;
};

}  // namespace robots
