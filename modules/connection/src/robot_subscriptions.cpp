/// The part of a robot's intake that is about who says what.

#include <utility>

#include "robot_intake.hpp"

namespace aisle {

Problems RobotIntake::subscribe(Wire& wire) {
  Problems problems;
  const auto add = [&](Problems found) { problems.insert(problems.end(), found.begin(), found.end()); };
  if (!connection_.scan.topic.empty())
    add(subscribe(wire, connection_.topic(connection_.scan.topic), WireQuality::kSensor,
                  &RobotIntake::take_scan, &scans_));
  add(subscribe_odometry(wire));
  add(subscribe(wire, "/tf_static", WireQuality::kLatched, &RobotIntake::take_fixed_transforms));
  if (connection_.clock == ConnectedClock::kRos)
    add(subscribe(wire, "/clock", WireQuality::kSensor, &RobotIntake::take_clock));
  if (!connection_.battery.topic.empty())
    add(subscribe(wire, connection_.topic(connection_.battery.topic), WireQuality::kSensor,
                  &RobotIntake::take_battery));
  if (!connection_.joystick.topic.empty()) {
    state_.joystick.emplace(connection_.joystick);
    add(subscribe(wire, connection_.topic(connection_.joystick.topic), WireQuality::kSensor,
                  &RobotIntake::take_joystick));
  }
  add(subscribe_switches(wire, connection_.bumpers, state_.bumpers));
  add(subscribe_switches(wire, connection_.emergency_stops, state_.emergency_stops));
  return problems;
}

Problems RobotIntake::subscribe(Wire& wire, NeededTopic& needed, WireQuality quality, Wire::Sink take) {
  auto subscription = wire.subscribe(needed.topic, needed.type, quality, std::move(take));
  if (!subscription) return subscription.problems();
  needed.subscription = subscription->get();
  subscriptions_.push_back(std::move(*subscription));
  return {};
}

template <class Message>
Problems RobotIntake::subscribe(Wire& wire, const std::string& topic, WireQuality quality,
                                bool (RobotIntake::*take)(const Message&), NeededTopic* needed) {
  NeededTopic unneeded;
  NeededTopic& subscribed = needed == nullptr ? unneeded : *needed;
  subscribed = {topic, Message::kType};
  return subscribe(wire, subscribed, quality, [this, take](std::string_view bytes) {
    arrive<Message>(bytes, [&](const Message& message) { return (this->*take)(message); });
  });
}

Problems RobotIntake::subscribe_odometry(Wire& wire) {
  const std::string topic = connection_.topic(connection_.odometry.topic);
  using Source = ConnectedOdometry::Source;
  if (connection_.odometry.source == Source::kOdometry)
    return subscribe(wire, topic, WireQuality::kSensor, &RobotIntake::take_odometry, &odometry_);
  if (connection_.odometry.source == Source::kTransforms)
    return subscribe(wire, "/tf", WireQuality::kSensor, &RobotIntake::take_odometry_transforms, &odometry_);
  return subscribe(wire, topic, WireQuality::kSensor, &RobotIntake::take_wheels, &odometry_);
}

Problems RobotIntake::subscribe_switches(Wire& wire, const std::vector<ConnectedSwitch>& switches,
                                         std::vector<SwitchState>& states) {
  states.resize(switches.size());
  Problems problems;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    NeededTopic topic{connection_.topic(switches[i].topic), ros::Bool::kType};
    const auto take = [this, &state = states[i]](std::string_view bytes) {
      arrive<ros::Bool>(bytes, [&](const ros::Bool& message) {
        state.is_pressed = message.data;
        state.was_pressed |= message.data;
        state.arrived_s = now_s();
        return true;
      });
    };
    // Latched as well: one that was pressed before this program began says so once, if at all.
    for (const WireQuality quality : {WireQuality::kSensor, WireQuality::kLatched}) {
      for (Problem& problem : subscribe(wire, topic, quality, take)) problems.push_back(std::move(problem));
    }
  }
  return problems;
}

}  // namespace aisle
