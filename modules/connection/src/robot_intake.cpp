#include "robot_intake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "scan_fitting.hpp"

namespace aisle {
namespace {

constexpr std::size_t kScansWaiting = 2;
constexpr std::size_t kPeriodsKept = 5;
constexpr double kClockJump_s = 1;
constexpr double kSweepMax_s = 10;        // no scanner takes longer for a scan
constexpr double kLeapsApart_s = 10;      // two leaps within this: the odometry is broken
constexpr double kJumpsTogether_s = 0.5;  // within this, what jumps later does so for the same reason
constexpr int kUnreadableInARow = 10;
constexpr double kUnreadableShare = 0.01;
constexpr std::size_t kUnreadableLeast = 10;

/// The clock that machines keep together.
double wall_clock_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

RobotIntake::RobotIntake(const Connection& connection, const VehicleDescription& vehicle, const Clock& clock)
    : connection_(connection),
      clock_(clock),
      state_(OdometryTrail(connection.odometry.jump_max_m, vehicle.limits.speed_max_mps)),
      wheels_(connection.odometry, vehicle.differential),
      live_cameras_(connection.cameras.size()),
      images_(connection.cameras.size()) {
  state_.cameras.resize(connection.cameras.size());
}

Result<std::unique_ptr<RobotIntake>> RobotIntake::open(Wire& wire, const Connection& connection,
                                                       const VehicleDescription& vehicle,
                                                       const Clock& clock) {
  auto intake = std::make_unique<RobotIntake>(connection, vehicle, clock);
  Problems problems = intake->subscribe(wire);
  for (std::size_t i = 0; i < connection.cameras.size(); ++i) {
    for (Problem& problem : intake->open_camera(wire, i, vehicle)) problems.push_back(std::move(problem));
  }
  if (!problems.empty()) return problems;
  return intake;
}

void RobotIntake::wait(std::unique_lock<std::mutex>& lock, double most_s) {
  take_live_images();
  arrived_.wait_for(lock, std::chrono::duration<double>(most_s), [this] { return has_news_; });
  has_news_ = false;
}

void RobotIntake::wait_for_odometry(std::unique_lock<std::mutex>& lock, double stamp_s, double most_s) {
  arrived_.wait_for(lock, std::chrono::duration<double>(most_s),
                    [&] { return state_.trail.newest_s() >= stamp_s; });
}

double RobotIntake::now_s() const {
  return connection_.clock == ConnectedClock::kRos
             ? state_.ros_clock_s.value_or(0) - state_.ros_clock_skipped_s
             : clock_.now_s();
}

void RobotIntake::arrive(const std::string& type, const std::function<bool()>& take) {
  {
    const std::lock_guard lock(mutex_);
    ++state_.counts.messages;
    has_news_ = true;
    if (take()) {
      state_.unreadable_in_a_row[type] = 0;
    } else {
      count_unreadable(type);
    }
  }
  arrived_.notify_all();
}

void RobotIntake::count_unreadable(const std::string& type) {
  ConnectionCounts& counts = state_.counts;
  ++counts.unreadable;
  const bool are_many =
      counts.unreadable >= kUnreadableLeast &&
      static_cast<double>(counts.unreadable) > kUnreadableShare * static_cast<double>(counts.messages);
  if (++state_.unreadable_in_a_row[type] >= kUnreadableInARow || are_many)
    be_broken(fmt::format("{} of {} messages cannot be read, the last of them {}", counts.unreadable,
                          counts.messages, type));
}

bool RobotIntake::is_next(StreamState& stream, const std::string& frame, double stamp_s,
                          const std::string& name) {
  if (stream.frame.empty()) stream.frame = frame;
  if (frame != stream.frame) {
    ++state_.counts.scans_foreign;
    return false;
  }
  if (stream.newest_s) {
    const double gap_s = stamp_s - *stream.newest_s;
    if (gap_s < -kClockJump_s)
      be_broken(fmt::format("the stamps of {} jumped back by {:.1f} s", name, -gap_s));
    if (gap_s > kClockJump_s) {
      ++state_.counts.clock_gaps;
      note_jump(fmt::format("the stamps of {} jumped ahead by {:.1f} s", name, gap_s));
    }
    if (gap_s <= 0) {
      ++state_.counts.out_of_order;
      return false;
    }
    if (stream.periods_s.size() < kPeriodsKept) stream.periods_s.push_back(gap_s);
  }
  stream.newest_s = stream.newest_end_s = stamp_s;
  stream.arrived_s = now_s();
  stream.pace.take(now_s(), age_s(stamp_s));
  return true;
}

bool RobotIntake::take_scan(const ros::LaserScan& message) {
  ScanDoubts doubts;
  const ros::Stamp_ns stamp = stamp_of(message.header);
  const double stamp_s = ros::stamp_s(stamp);
  auto scan = bag_scan(message, {.stamp = stamp}, doubts);
  if (!scan || stamp < 0 || end_of_scan_s(*scan) > stamp_s + kSweepMax_s) return false;
  if (!is_next(state_.scan, scan->frame, stamp_s, scans_.topic)) return true;
  state_.scan.newest_end_s = end_of_scan_s(*scan);
  state_.scans.push_back(std::move(*scan));
  if (state_.scans.size() > kScansWaiting) {
    state_.scans.pop_front();
    ++state_.counts.scans_skipped;
  }
  return true;
}

bool RobotIntake::take_joystick(const ros::Joy& message) {
  return state_.joystick->take(message, now_s());
}

bool RobotIntake::take_odometry(const ros::Odometry& message) {
  const ros::Pose& pose = message.pose.pose;
  return take_pose(ros::stamp_s(stamp_of(message.header)), pose.position, pose.orientation);
}

bool RobotIntake::take_odometry_transforms(const ros::TFMessage& message) {
  bool makes_sense = true;
  for (const ros::TransformStamped& transform : message.transforms) {
    if (frame_name(transform.header.frame_id) == connection_.frames.odom &&
        frame_name(transform.child_frame_id) == connection_.frames.base)
      makes_sense &= take_pose(ros::stamp_s(stamp_of(transform.header)), transform.transform.translation,
                               transform.transform.rotation);
  }
  return makes_sense;
}

bool RobotIntake::take_wheels(const ros::JointState& message) {
  const auto T_odom_base = wheels_.take(message);
  return !T_odom_base || take_base(ros::stamp_s(stamp_of(message.header)), *T_odom_base);
}

bool RobotIntake::take_fixed_transforms(const ros::TFMessage& message) {
  for (const ros::TransformStamped& transform : message.transforms) {
    const auto T = isometry(transform.transform.translation, transform.transform.rotation);
    if (T)
      state_.transforms.add(frame_name(transform.header.frame_id), frame_name(transform.child_frame_id), *T);
  }
  return true;
}

bool RobotIntake::take_battery(const ros::BatteryState& message) {
  if (message.percentage >= 0 && message.percentage <= 1) {
    state_.charge = message.percentage;
    state_.charge_arrived_s = clock_.now_s();
  }
  return true;  // NaN: unknown
}

bool RobotIntake::take_clock(const ros::Clock& message) {
  const double clock_s = ros::stamp_s(ros::stamp_ns(message.clock));
  if (state_.ros_clock_s && clock_s < *state_.ros_clock_s - kClockJump_s)
    be_broken(fmt::format("/clock jumped back by {:.1f} s", *state_.ros_clock_s - clock_s));
  if (const double ahead_s = clock_s - state_.ros_clock_s.value_or(clock_s); ahead_s > kClockJump_s) {
    state_.ros_clock_skipped_s += ahead_s;
    ++state_.counts.clock_gaps;
    note_jump(fmt::format("/clock jumped ahead by {:.1f} s", ahead_s));
  }
  if (!state_.ros_clock_s || clock_s > *state_.ros_clock_s) state_.clock_arrived_s = clock_.now_s();
  state_.ros_clock_s = clock_s;
  return true;
}

bool RobotIntake::take_pose(double stamp_s, const ros::Vector3& position,
                            const ros::Quaternion& orientation) {
  const auto T_odom_base = isometry(position, orientation);
  return T_odom_base && take_base(stamp_s, in_the_plane(*T_odom_base));
}

bool RobotIntake::take_base(double stamp_s, const Pose2& T_odom_base) {
  const Vec2& p_base_axle_m = connection_.frames.p_base_axle_m;
  const double now = now_s();
  const double gap_s = state_.trail.empty() ? 0 : stamp_s - state_.trail.newest_s();
  if (std::abs(gap_s) > kClockJump_s) {
    const std::string jump = fmt::format("the stamps of {} jumped {} by {:.1f} s", odometry_.topic,
                                         gap_s < 0 ? "back" : "ahead", std::abs(gap_s));
    if (gap_s < 0) be_broken(jump);
    note_jump(jump);
  }
  switch (state_.trail.take(stamp_s, T_odom_base * Pose2{p_base_axle_m.x(), p_base_axle_m.y(), 0})) {
    case OdometryTrail::Taken::kMotion:
      break;
    case OdometryTrail::Taken::kOutOfOrder:
      ++state_.counts.out_of_order;
      return true;
    case OdometryTrail::Taken::kRestart:
      be_broken("its odometry began again at zero: the robot was restarted");
      break;
    case OdometryTrail::Taken::kLeap:
      ++state_.counts.odometry_leaps;
      note_jump("its odometry leapt");
      if (now - state_.leap_arrived_s < kLeapsApart_s)
        be_broken(fmt::format("its odometry leapt twice in {:.0f} s", kLeapsApart_s));
      state_.leap_arrived_s = now;
      break;
  }
  state_.odometry_arrived_s = now;
  state_.odometry_pace.take(now_s(), age_s(stamp_s));
  return true;
}

ros::Stamp_ns RobotIntake::stamp_of(const ros::Header& header) const {
  return connection_.clock == ConnectedClock::kArrival ? ros::stamp_ns(clock_.now_s())
                                                       : ros::stamp_ns(header.stamp);
}

/// By /clock, or by the clock that machines keep together.
double RobotIntake::age_s(double stamp_s) const {
  if (connection_.clock == ConnectedClock::kRos) return state_.ros_clock_s.value_or(0) - stamp_s;
  return wall_clock_s() - stamp_s;
}

double RobotIntake::robot_time_s() const {
  if (connection_.clock == ConnectedClock::kArrival) return wall_clock_s();
  const double newest_s = std::max(state_.scan.newest_s.value_or(0), state_.trail.newest_s());
  const double since_s = now_s() - std::max(state_.scan.arrived_s, state_.odometry_arrived_s);
  return std::max(0.0, newest_s + std::max(0.0, since_s));
}

void RobotIntake::note_jump(std::string what) {
  const bool is_another = now_s() - state_.jump_s > kJumpsTogether_s;
  if (is_another) state_.jump = std::move(what);
  state_.jump_s = now_s();
}

void RobotIntake::be_broken(std::string why) {
  if (state_.broken.empty()) state_.broken = std::move(why);
}

}  // namespace aisle
