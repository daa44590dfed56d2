#include "aisle/connection/connected_vehicle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/formats/sessions/ros_time.hpp"
#include "command_outlet.hpp"
#include "command_topic.hpp"
#include "first_contact.hpp"
#include "odometry_reading.hpp"
#include "robot_intake.hpp"
#include "scan_fitting.hpp"

namespace aisle {
namespace {

constexpr double kAsk_s = 0.02;           // how long it waits before it looks again
constexpr double kOdometryWait_s = 0.06;  // for odometry as new as the scan
constexpr double kLookAtTopic_s = 0.1;    // how often it looks who else commands
constexpr double kClockLate_s = 0.5;      // of aisle's own time: held
constexpr double kClockStands_s = 10;     // of aisle's own time: the mission ends
constexpr double kOdometryGone = 4;       // times silent_max_s: the mission ends
constexpr double kAfterJump_s = 1;        // it stands still for so long after a jump that was left out

bool is_silent(const SwitchState& state, double silent_max_s, double now_s) {
  return silent_max_s > 0 && now_s - state.arrived_s > silent_max_s;
}

}  // namespace

/// The cycle of a connected vehicle: what arrived becomes an observation, or a reason to hold or to end.
class ConnectedVehicle::Cycle {
 public:
  Cycle(const Connection& connection, Surroundings surroundings, std::unique_ptr<RobotIntake> intake,
        FirstContact contact, std::unique_ptr<WirePublisher> publisher)
      : connection_(connection),
        surroundings_(std::move(surroundings)),
        intake_(std::move(intake)),
        contact_(std::move(contact)),
        command_topic_(connection.topic(connection.commands.topic)),
        outlet_(
            std::move(publisher), {contact_.commands, connection.commands.age_max_s, connection.frames.base},
            contact_.vehicle, [this] { return now_s(); }, [this] { return stamp_now(); }) {
    const auto lock = intake_->lock();
    intake_->state().scans.clear();  // they are from before the vehicle was looked at
    connected_s_ = intake_->now_s();
  }

  const VehicleDescription& description() const { return contact_.vehicle; }
  const std::string& end_reason() const { return end_reason_; }
  const Odometry& odometry() const { return odometry_; }

  void act(const Command& command) {
    steering_rad_ = within(contact_.vehicle.limits, command).steering_rad;
    outlet_.act(command);
  }

  void fall_silent(bool is_silent) { outlet_.fall_silent(is_silent); }
  Arc commanded() { return outlet_.commanded(); }

  std::optional<Observation> sense() {
    for (;;) {
      surroundings_.progress.report(is_held() ? "held" : "driving", 0, 0);
      look_at_command_topic();
      judge();
      if (!end_reason_.empty()) return std::nullopt;
      if (is_held() && surroundings_.progress.shall_end()) {
        end_reason_ = "ended while held: " + held_because_;
        return std::nullopt;
      }
      auto lock = intake_->lock();
      if (is_held()) {
        drop_scans();
      } else if (!intake_->state().scans.empty()) {
        return observe(lock);
      }
      intake_->wait(lock, kAsk_s);
    }
  }

  ConnectionCounts counts() const {
    const auto lock = intake_->lock();
    ConnectionCounts counts = intake_->state().counts;
    counts.commands_aged = outlet_.aged();
    counts.holds = holds_;
    counts.held_s = held_s_;
    counts.scan_age_s = intake_->now_s() - intake_->state().scan_arrived_s;
    counts.odometry_age_s = intake_->now_s() - intake_->state().odometry_arrived_s;
    return counts;
  }

 private:
  double now_s() const {
    const auto lock = intake_->lock();
    return intake_->now_s();
  }

  ros::Stamp_ns stamp_now() const {
    const auto lock = intake_->lock();
    return ros::stamp_ns(intake_->robot_time_s());
  }

  /// Looks seldom, without the intake's lock: the wire has locks of its own.
  void look_at_command_topic() {
    const double now_s = surroundings_.clock.now_s();
    if (now_s - looked_s_ < kLookAtTopic_s) return;
    looked_s_ = now_s;
    obstacle_ = command_obstacle(surroundings_.wire.endpoints(), command_topic_, contact_.commands);
  }

  /// Holds, goes on or ends. The outlet is told without the intake's lock, which it takes itself.
  void judge() {
    std::string because;
    {
      const auto lock = intake_->lock();
      end_reason_ = why_end();
      because = why_held();
    }
    if (!end_reason_.empty()) return outlet_.hold(true);
    if (because == held_because_) return;
    if (!is_held()) ++holds_;
    held_because_ = because;
    outlet_.hold(is_held());
    surroundings_.note(is_held() ? "held: " + because : std::string("goes on"));
  }

  std::string why_end() const {
    const RobotState& state = intake_->state();
    if (!state.broken.empty()) return state.broken;
    const double now_s = intake_->now_s();
    const auto silent_s = [&](double arrived_s) { return now_s - std::max(arrived_s, connected_s_); };
    if (connection_.clock == ConnectedClock::kRos &&
        surroundings_.clock.now_s() - state.clock_arrived_s > kClockStands_s)
      return fmt::format("/clock stands still for {:.0f} s", kClockStands_s);
    const auto needed = intake_->needed_topics();
    if (silent_s(state.scan_arrived_s) > connection_.scan.silent_max_s)
      return silence(needed[0], connection_.scan.silent_max_s);
    const double odometry_max_s = kOdometryGone * connection_.odometry.silent_max_s;
    if (silent_s(state.odometry_arrived_s) > odometry_max_s) return silence(needed[1], odometry_max_s);
    return {};
  }

  std::string silence(const NeededTopic& needed, double silent_s) const {
    const auto& unreadable = intake_->state().unreadable_in_a_row;
    const bool arrives = unreadable.count(needed.type) > 0 && unreadable.at(needed.type) > 0;
    return fmt::format("{} silent for {:.1f} s{}", needed.topic, silent_s,
                       arrives ? fmt::format(": what arrives cannot be read as {}", needed.type) : "");
  }

  std::string why_held() const {
    const RobotState& state = intake_->state();
    const double now_s = intake_->now_s();
    for (std::size_t i = 0; i < state.emergency_stops.size(); ++i) {
      const std::string topic = connection_.topic(connection_.emergency_stops[i].topic);
      if (state.emergency_stops[i].is_pressed) return fmt::format("the emergency stop {} is pressed", topic);
      if (is_silent(state.emergency_stops[i], connection_.emergency_stops[i].silent_max_s, now_s))
        return fmt::format("the emergency stop {} is silent", topic);
    }
    if (connection_.clock == ConnectedClock::kRos &&
        surroundings_.clock.now_s() - state.clock_arrived_s > kClockLate_s)
      return "/clock stands still";
    const auto needed = intake_->needed_topics();
    if (now_s - std::max(state.odometry_arrived_s, connected_s_) > connection_.odometry.silent_max_s)
      return fmt::format("{} is silent", needed[1].topic);
    if (now_s - state.jump_s < kAfterJump_s) return state.jump;
    const double scan_late_s = state.trail.newest_s() - state.newest_scan_end_s;
    if (scan_late_s > contact_.vehicle.cycle_s + connection_.commands.age_max_s)
      return fmt::format("{} is far behind {}", needed[0].topic, needed[1].topic);
    if (-scan_late_s > contact_.vehicle.cycle_s + connection_.odometry.silent_max_s)
      return fmt::format("{} is far behind {}", needed[1].topic, needed[0].topic);
    return obstacle_;
  }

  bool is_held() const { return !held_because_.empty(); }

  /// While it is held, the mission's clock stands still; the way that it is pushed is kept.
  void drop_scans() {
    std::deque<BagScan>& scans = intake_->state().scans;
    if (scans.empty()) return;
    is_clock_held_ = true;
    scans.clear();
  }

  Observation observe(std::unique_lock<std::mutex>& lock) {
    RobotState& state = intake_->state();
    BagScan scan = std::move(state.scans.front());
    state.scans.pop_front();
    const double scan_s = end_of_scan_s(scan);
    intake_->wait_for_odometry(lock, scan_s, kOdometryWait_s);
    if (state.trail.newest_s() < scan_s) ++state.counts.odometry_late;
    if (contact_.is_upside_down) turn_over(scan);
    Observation observation;
    observation.stamp_s = mission_s(scan_s);
    observation.scan = RangeScan{
        observation.stamp_s, fitted_ranges(scan, contact_.grid, [&](double s) { return state.trail.at(s); })};
    if (!readings_) readings_.emplace(contact_.vehicle, state.trail.at(scan_s));
    observation.odometry = readings_->read(state.trail.at(scan_s), steering_rad_);
    odometry_ = {ros::stamp_ns(scan_s), state.trail.in_odom(state.trail.at(scan_s))};
    observation.bumper_pressed = touches(state);
    return observation;
  }

  /// The mission's time at a scan: without the time for which the vehicle was held.
  double mission_s(double scan_s) {
    const double cycle_s = contact_.vehicle.cycle_s;
    if (!last_scan_s_) {
      first_s_ = scan_s - cycle_s;
    } else if (is_clock_held_) {
      const double held_s = std::max(0.0, scan_s - *last_scan_s_ - cycle_s);
      first_s_ += held_s;
      held_s_ += held_s;
    }
    is_clock_held_ = false;
    last_scan_s_ = scan_s;
    return scan_s - first_s_;
  }

  bool touches(RobotState& state) const {
    bool touched = false;
    for (std::size_t i = 0; i < state.bumpers.size(); ++i) {
      SwitchState& bumper = state.bumpers[i];
      touched |= bumper.is_pressed || bumper.was_pressed ||
                 is_silent(bumper, connection_.bumpers[i].silent_max_s, intake_->now_s());
      bumper.was_pressed = false;
    }
    return touched;
  }

  const Connection connection_;
  Surroundings surroundings_;
  std::unique_ptr<RobotIntake> intake_;
  const FirstContact contact_;
  const std::string command_topic_;
  std::optional<OdometryReadings> readings_;
  Odometry odometry_;
  double connected_s_ = 0;
  double looked_s_ = kNever_s;
  std::string obstacle_;
  std::string held_because_;
  std::string end_reason_;
  double steering_rad_ = 0;
  double first_s_ = 0;
  std::optional<double> last_scan_s_;
  bool is_clock_held_ = false;
  std::size_t holds_ = 0;
  double held_s_ = 0;
  CommandOutlet outlet_;  ///< last: it uses the intake to its end
};

Result<std::unique_ptr<ConnectedVehicle>> ConnectedVehicle::connect(const Connection& connection,
                                                                    const VehicleDescription& vehicle,
                                                                    Surroundings surroundings) {
  auto intake = RobotIntake::open(surroundings.wire, connection, vehicle, surroundings.clock);
  if (!intake) return intake.problems();
  auto contact = make_contact(connection, vehicle, **intake, surroundings);
  if (!contact) return contact.problems();
  auto publisher = surroundings.wire.advertise(connection.topic(connection.commands.topic),
                                               command_type(contact->commands), WireQuality::kCommand);
  if (!publisher) return publisher.problems();
  auto cycle = std::make_unique<Cycle>(connection, std::move(surroundings), std::move(*intake),
                                       std::move(*contact), std::move(*publisher));
  return std::unique_ptr<ConnectedVehicle>(new ConnectedVehicle(std::move(cycle)));
}

ConnectedVehicle::ConnectedVehicle(std::unique_ptr<Cycle> cycle) : cycle_(std::move(cycle)) {}
ConnectedVehicle::~ConnectedVehicle() = default;

const VehicleDescription& ConnectedVehicle::description() const {
  return cycle_->description();
}

std::optional<Observation> ConnectedVehicle::sense() {
  return cycle_->sense();
}

std::string ConnectedVehicle::end_reason() const {
  return cycle_->end_reason();
}

void ConnectedVehicle::act(const Command& command) {
  cycle_->act(command);
}

void ConnectedVehicle::fall_silent(bool is_silent) {
  cycle_->fall_silent(is_silent);
}

const ConnectedVehicle::Odometry& ConnectedVehicle::odometry() const {
  return cycle_->odometry();
}

Arc ConnectedVehicle::commanded() const {
  return cycle_->commanded();
}

ConnectionCounts ConnectedVehicle::counts() const {
  return cycle_->counts();
}

}  // namespace aisle
