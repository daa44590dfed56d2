#include "command_intake.hpp"

#include <algorithm>

namespace robots {
namespace {

Command command_of(const Twist& message) {
  return {message.linear.x, message.angular.z, std::nullopt};
}
Command command_of(const TwistStamped& message) {
  return command_of(message.twist);
}
Command command_of(const AckermannDriveStamped& message) {
  return {message.speed, 0, message.steering_angle};
}

/// How long ago; zero without a stamp, and for one from the future, as clocks of two machines may differ.
double age_s(const Twist&, const Time&) {
  return 0;
}
double age_s(const auto& message, const Time& now) {
  const Time& stamp = message.header.stamp;
  const bool is_stamped = stamp.sec != 0 || stamp.nanosec != 0;
  return is_stamped ? std::max(0.0, (now.sec - stamp.sec) + 1e-9 * now.nanosec - 1e-9 * stamp.nanosec) : 0;
}

}  // namespace

CommandIntake::CommandIntake(const Participant& participant, const std::string& topic,
                             const std::string& kind)
    : subscription_([&]() -> AnySubscription {
        if (kind == "ackermann") {
          return Subscription<AckermannDriveStamped>(participant, topic, Quality::kDefault);
        }
        if (kind == "twist_stamped") return Subscription<TwistStamped>(participant, topic, Quality::kDefault);
        return Subscription<Twist>(participant, topic, Quality::kDefault);
      }()) {}

std::optional<Command> CommandIntake::take(double now_s, const Time& now) const {
  return std::visit(
      [&](const auto& subscription) -> std::optional<Command> {
        const auto message = subscription.take();
        if (!message) return std::nullopt;
        Command command = command_of(*message);
        command.given_s = now_s - age_s(*message, now);
        return command;
      },
      subscription_);
}

}  // namespace robots
