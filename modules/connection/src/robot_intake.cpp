#include "robot_intake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {
namespace {

constexpr std::size_t kScansWaiting = 2;
constexpr std::size_t kPeriodsKept = 5;
constexpr double kClockJump_s = 1;
constexpr double kLeapsApart_s = 10;  // two leaps within this: the odometry is broken
constexpr int kUnreadableInARow = 10;
constexpr double kUnreadableShare = 0.01;
constexpr std::size_t kUnreadableLeast = 10;

using Source = ConnectedOdometry::Source;

/// Wheel angles of a left and a right joint; nullopt: the message has not both.
std::optional<std::pair<double, double>> wheel_angles(const ros::JointState& message,
                                                      const ConnectedOdometry& odometry) {
  const auto angle_of = [&](const std::string& joint) -> std::optional<double> {
    const auto found = std::find(message.name.begin(), message.name.end(), joint);
    const auto index = static_cast<std::size_t>(found - message.name.begin());
    if (found == message.name.end() || index >= message.position.size()) return std::nullopt;
    return message.position[index];
  };
  const auto left = angle_of(odometry.left_joint), right = angle_of(odometry.right_joint);
  if (!left || !right || !std::isfinite(*left) || !std::isfinite(*right)) return std::nullopt;
  return std::pair(*left, *right);
}

}  // namespace

RobotIntake::RobotIntake(const Connection& connection, const VehicleDescription& vehicle, const Clock& clock)
    : connection_(connection),
      vehicle_(vehicle),
      clock_(clock),
      state_(OdometryTrail(connection.odometry.jump_max_m, vehicle.limits.speed_max_mps)) {}

Result<std::unique_ptr<RobotIntake>> RobotIntake::open(Wire& wire, const Connection& connection,
                                                       const VehicleDescription& vehicle,
                                                       const Clock& clock) {
  auto intake = std::make_unique<RobotIntake>(connection, vehicle, clock);
  if (Problems problems = intake->subscribe(wire); !problems.empty()) return problems;
  return intake;
}

std::vector<NeededTopic> RobotIntake::needed_topics() const {
  const char* const odometry_type = connection_.odometry.source == Source::kOdometry ? ros::Odometry::kType
                                    : connection_.odometry.source == Source::kTransforms
                                        ? ros::TFMessage::kType
                                        : ros::JointState::kType;
  const std::string odometry_topic = connection_.odometry.source == Source::kTransforms
                                         ? std::string("/tf")
                                         : connection_.topic(connection_.odometry.topic);
  return {{connection_.topic(connection_.scan.topic), ros::LaserScan::kType},
          {odometry_topic, odometry_type}};
}

void RobotIntake::wait(std::unique_lock<std::mutex>& lock, double most_s) {
  arrived_.wait_for(lock, std::chrono::duration<double>(most_s), [this] { return has_news_; });
  has_news_ = false;
}

void RobotIntake::wait_for_odometry(std::unique_lock<std::mutex>& lock, double stamp_s, double most_s) {
  arrived_.wait_for(lock, std::chrono::duration<double>(most_s),
                    [&] { return state_.trail.newest_s() >= stamp_s; });
}

double RobotIntake::now_s() const {
  if (connection_.clock == ConnectedClock::kRos && state_.ros_clock_s) return *state_.ros_clock_s;
  return clock_.now_s();
}

Problems RobotIntake::subscribe(Wire& wire) {
  Problems problems;
  const auto add = [&](Problems found) { problems.insert(problems.end(), found.begin(), found.end()); };
  add(subscribe(wire, connection_.topic(connection_.scan.topic), WireQuality::kSensor,
                &RobotIntake::take_scan));
  add(subscribe_odometry(wire));
  add(subscribe(wire, "/tf_static", WireQuality::kLatched, &RobotIntake::take_fixed_transforms));
  if (connection_.clock == ConnectedClock::kRos)
    add(subscribe(wire, "/clock", WireQuality::kSensor, &RobotIntake::take_clock));
  if (!connection_.battery.topic.empty())
    add(subscribe(wire, connection_.topic(connection_.battery.topic), WireQuality::kSensor,
                  &RobotIntake::take_battery));
  add(subscribe_switches(wire, connection_.bumpers, state_.bumpers));
  add(subscribe_switches(wire, connection_.emergency_stops, state_.emergency_stops));
  return problems;
}

template <class Message>
Problems RobotIntake::subscribe(Wire& wire, const std::string& topic, WireQuality quality,
                                void (RobotIntake::*take)(const Message&)) {
  auto subscription = wire.subscribe(topic, Message::kType, quality, [this, take](std::string_view bytes) {
    arrive<Message>(bytes, [&](const Message& message) { (this->*take)(message); });
  });
  if (!subscription) return subscription.problems();
  subscriptions_.push_back(std::move(*subscription));
  return {};
}

Problems RobotIntake::subscribe_odometry(Wire& wire) {
  const std::string topic = needed_topics()[1].topic;
  if (connection_.odometry.source == Source::kOdometry)
    return subscribe(wire, topic, WireQuality::kSensor, &RobotIntake::take_odometry);
  if (connection_.odometry.source == Source::kTransforms)
    return subscribe(wire, topic, WireQuality::kSensor, &RobotIntake::take_odometry_transforms);
  return subscribe(wire, topic, WireQuality::kSensor, &RobotIntake::take_wheels);
}

Problems RobotIntake::subscribe_switches(Wire& wire, const std::vector<ConnectedSwitch>& switches,
                                         std::vector<SwitchState>& states) {
  states.resize(switches.size());
  for (std::size_t i = 0; i < switches.size(); ++i) {
    auto subscription = wire.subscribe(connection_.topic(switches[i].topic), ros::Bool::kType,
                                       WireQuality::kSensor, [this, &state = states[i]](std::string_view b) {
                                         arrive<ros::Bool>(b, [&](const ros::Bool& message) {
                                           state.is_pressed = message.data;
                                           state.was_pressed |= message.data;
                                           state.arrived_s = now_s();
                                         });
                                       });
    if (!subscription) return subscription.problems();
    subscriptions_.push_back(std::move(*subscription));
  }
  return {};
}

template <class Message, class Take>
void RobotIntake::arrive(std::string_view bytes, const Take& take) {
  const auto message = parse_cdr<Message>(bytes);
  {
    const std::lock_guard lock(mutex_);
    ConnectionCounts& counts = state_.counts;
    ++counts.messages;
    has_news_ = true;
    if (message) {
      state_.unreadable_in_a_row = 0;
      take(*message);
    } else {
      ++counts.unreadable;
      const bool are_many =
          counts.unreadable >= kUnreadableLeast &&
          static_cast<double>(counts.unreadable) > kUnreadableShare * static_cast<double>(counts.messages);
      if (++state_.unreadable_in_a_row >= kUnreadableInARow || are_many)
        be_broken(fmt::format("{} of {} messages cannot be read, the last of them {}", counts.unreadable,
                              counts.messages, Message::kType));
    }
  }
  arrived_.notify_all();
}

void RobotIntake::take_scan(const ros::LaserScan& message) {
  ScanDoubts doubts;
  const ros::Stamp_ns stamp = stamp_of(message.header);
  const double stamp_s = ros::stamp_s(stamp);
  auto scan = bag_scan(message, {.stamp = stamp}, doubts);
  if (!scan) {
    ++state_.counts.unreadable;
    return;
  }
  if (state_.scan_frame.empty()) state_.scan_frame = scan->frame;
  if (scan->frame != state_.scan_frame) {
    ++state_.counts.scans_foreign;
    return;
  }
  if (state_.newest_scan_s) {
    const double gap_s = stamp_s - *state_.newest_scan_s;
    if (gap_s < -kClockJump_s)
      be_broken(fmt::format("the clock of its scans jumped back by {:.1f} s", -gap_s));
    if (gap_s > kClockJump_s) ++state_.counts.clock_gaps;
    if (gap_s <= 0) {
      ++state_.counts.out_of_order;
      return;
    }
    if (state_.scan_periods_s.size() < kPeriodsKept) state_.scan_periods_s.push_back(gap_s);
  }
  state_.newest_scan_s = stamp_s;
  state_.scan_arrived_s = now_s();
  state_.scan_pace.take(now_s(), age_s(stamp_s));
  state_.scans.push_back(std::move(*scan));
  if (state_.scans.size() > kScansWaiting) {
    state_.scans.pop_front();
    ++state_.counts.scans_skipped;
  }
}

void RobotIntake::take_odometry(const ros::Odometry& message) {
  const ros::Pose& pose = message.pose.pose;
  take_pose(ros::stamp_s(stamp_of(message.header)), pose.position, pose.orientation);
}

void RobotIntake::take_odometry_transforms(const ros::TFMessage& message) {
  for (const ros::TransformStamped& transform : message.transforms) {
    if (frame_name(transform.header.frame_id) == connection_.frames.odom &&
        frame_name(transform.child_frame_id) == connection_.frames.base)
      take_pose(ros::stamp_s(stamp_of(transform.header)), transform.transform.translation,
                transform.transform.rotation);
  }
}

void RobotIntake::take_wheels(const ros::JointState& message) {
  const auto angles_rad = wheel_angles(message, connection_.odometry);
  if (!angles_rad) return;  // other joints have messages of their own
  if (wheels_rad_) {
    const double radius_m = vehicle_.differential.wheel_radius_m;
    const double left_m = radius_m * (angles_rad->first - wheels_rad_->first);
    const double right_m = radius_m * (angles_rad->second - wheels_rad_->second);
    const double turn_rad = (right_m - left_m) / vehicle_.differential.wheel_separation_m;
    T_odom_wheels_ = T_odom_wheels_ * end_pose({(left_m + right_m) / 2, turn_rad});
  }
  wheels_rad_ = angles_rad;
  take_base(ros::stamp_s(stamp_of(message.header)), T_odom_wheels_);
}

void RobotIntake::take_fixed_transforms(const ros::TFMessage& message) {
  for (const ros::TransformStamped& transform : message.transforms) {
    const auto T = isometry(transform.transform.translation, transform.transform.rotation);
    if (T)
      state_.transforms.add(frame_name(transform.header.frame_id), frame_name(transform.child_frame_id), *T);
  }
}

void RobotIntake::take_battery(const ros::BatteryState& message) {
  if (message.percentage >= 0 && message.percentage <= 1) state_.charge = message.percentage;
}

void RobotIntake::take_clock(const ros::Clock& message) {
  const double clock_s = ros::stamp_s(ros::stamp_ns(message.clock));
  if (state_.ros_clock_s && clock_s < *state_.ros_clock_s - kClockJump_s)
    be_broken(fmt::format("/clock jumped back by {:.1f} s", *state_.ros_clock_s - clock_s));
  if (!state_.ros_clock_s)
    state_.scan_arrived_s = state_.odometry_arrived_s = clock_s;  // no more aisle's own
  if (!state_.ros_clock_s || clock_s > *state_.ros_clock_s) state_.clock_arrived_s = clock_.now_s();
  state_.ros_clock_s = clock_s;
}

void RobotIntake::take_pose(double stamp_s, const ros::Vector3& position,
                            const ros::Quaternion& orientation) {
  const auto T_odom_base = isometry(position, orientation);
  if (T_odom_base) {
    take_base(stamp_s, in_the_plane(*T_odom_base));
  } else {
    ++state_.counts.unreadable;
  }
}

void RobotIntake::take_base(double stamp_s, const Pose2& T_odom_base) {
  const Vec2& p_base_axle_m = connection_.frames.p_base_axle_m;
  const double now = now_s();
  switch (state_.trail.take(stamp_s, T_odom_base * Pose2{p_base_axle_m.x(), p_base_axle_m.y(), 0})) {
    case OdometryTrail::Taken::kMotion:
      break;
    case OdometryTrail::Taken::kOutOfOrder:
      ++state_.counts.out_of_order;
      return;
    case OdometryTrail::Taken::kRestart:
      be_broken("its odometry began again at zero: the robot was restarted");
      break;
    case OdometryTrail::Taken::kLeap:
      ++state_.counts.odometry_leaps;
      if (now - state_.leap_arrived_s < kLeapsApart_s)
        be_broken(fmt::format("its odometry leapt twice in {:.0f} s", kLeapsApart_s));
      state_.leap_arrived_s = now;
      break;
  }
  state_.odometry_arrived_s = now;
  state_.odometry_pace.take(now_s(), age_s(stamp_s));
}

ros::Stamp_ns RobotIntake::stamp_of(const ros::Header& header) const {
  return connection_.clock == ConnectedClock::kArrival ? ros::stamp_ns(clock_.now_s())
                                                       : ros::stamp_ns(header.stamp);
}

/// By /clock, or by the clock that machines keep together.
double RobotIntake::age_s(double stamp_s) const {
  if (connection_.clock == ConnectedClock::kRos) return now_s() - stamp_s;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count() - stamp_s;
}

void RobotIntake::be_broken(std::string why) {
  if (state_.broken.empty()) state_.broken = std::move(why);
}

}  // namespace aisle
