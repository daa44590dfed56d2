#include "aisle/connection/connected_vehicle.hpp"

#include <utility>

#include "camera_cycle.hpp"
#include "command_outlet.hpp"
#include "command_topic.hpp"
#include "first_contact.hpp"
#include "mission_clock.hpp"
#include "odometry_reading.hpp"
#include "robot_intake.hpp"
#include "robot_monitor.hpp"
#include "scan_fitting.hpp"

namespace aisle {
namespace {

constexpr double kAsk_s = 0.02;           // how long it waits before it looks again
constexpr double kOdometryWait_s = 0.06;  // for odometry as new as the scan
constexpr double kLookAtTopic_s = 0.1;    // how often it looks who else commands

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
        monitor_(connection_, contact_.vehicle, *intake_, surroundings_.clock),
        mission_clock_(contact_.vehicle.cycle_s) {
    if (contact_.commands)
      outlet_.emplace(
          std::move(publisher),
          CommandOutlet::Settings{*contact_.commands, connection.commands.age_max_s, connection.frames.base},
          contact_.vehicle, [this] { return now_s(); }, [this] { return stamp_now(); });
    const auto lock = intake_->lock();
    drop_readings();  // they are from before the vehicle was looked at
  }

  const VehicleDescription& description() const { return contact_.vehicle; }
  const std::string& end_reason() const { return end_reason_; }
  const Odometry& odometry() const { return odometry_; }

  void act(const Command& command) {
    steering_rad_ = within(contact_.vehicle.limits, command).steering_rad;
    if (outlet_) outlet_->act(command);
  }

  void fall_silent(bool is_silent) {
    if (outlet_) outlet_->fall_silent(is_silent);
  }
  Arc commanded() { return outlet_ ? outlet_->commanded() : Arc{}; }

  std::optional<Observation> sense() {
    for (;;) {
      surroundings_.progress.report(is_held() ? "held" : "driving", 0, 0);
      look_at_command_topic();
      judge();
      if (is_held() && end_reason_.empty() && surroundings_.progress.shall_end())
        end_reason_ = "ended while held: " + held_because_;
      if (!end_reason_.empty()) return std::nullopt;
      auto lock = intake_->lock();
      if (is_held()) {
        if (drop_readings()) mission_clock_.hold();
      } else if (auto observation = observe(lock)) {
        return observation;
      }
      intake_->wait(lock, kAsk_s);
    }
  }

  std::optional<Battery> battery() const {
    const auto lock = intake_->lock();
    const RobotState& state = intake_->state();
    if (!state.charge) return std::nullopt;
    return Battery{*state.charge, surroundings_.clock.now_s() - state.charge_arrived_s};
  }

  ConnectionCounts counts() const {
    const auto lock = intake_->lock();
    ConnectionCounts counts = intake_->state().counts;
    counts.commands_aged = outlet_ ? outlet_->aged() : 0;
    counts.holds = holds_;
    counts.held_s = mission_clock_.held_s();
    monitor_.add_ages(counts);
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
    if (!outlet_ || now_s - looked_s_ < kLookAtTopic_s) return;
    looked_s_ = now_s;
    obstacle_ = command_obstacle(surroundings_.wire.endpoints(), command_topic_, *contact_.commands);
  }

  /// Holds, goes on or ends. The outlet is told without the intake's lock, which it takes itself.
  void judge() {
    std::string because;
    {
      const auto lock = intake_->lock();
      intake_->take_live_images();
      end_reason_ = monitor_.why_end();
      because = monitor_.why_held();
    }
    if (because.empty()) because = obstacle_;
    if (!end_reason_.empty()) return hold(true);
    if (because == held_because_) return;
    if (!is_held()) ++holds_;
    held_because_ = because;
    hold(is_held());
    surroundings_.note(is_held() ? "held: " + because : std::string("goes on"));
  }

  void hold(bool is_held) {
    if (outlet_) outlet_->hold(is_held);
  }

  bool is_held() const { return !held_because_.empty(); }

  bool has_scanner() const { return contact_.vehicle.scanner.has_value(); }

  /// While it is held, the mission's clock stands still; the way that it is pushed is kept.
  /// @return whether a cycle would have ended
  bool drop_readings() {
    RobotState& state = intake_->state();
    const bool ends_cycle = has_scanner() ? !state.scans.empty() : !state.cameras.front().images.empty();
    state.scans.clear();
    for (ArrivingImages& camera : state.cameras) camera.images.clear();
    return ends_cycle;
  }

  /// A scan ends a cycle, or where there is no scanner, the newest image of the first camera.
  std::optional<BagScan> take_scan() {
    std::deque<BagScan>& scans = intake_->state().scans;
    if (scans.empty()) return std::nullopt;
    BagScan scan = std::move(scans.front());
    scans.pop_front();
    if (contact_.is_upside_down) turn_over(scan);
    return scan;
  }

  /// @return nullopt if nothing came that ends a cycle
  std::optional<Observation> observe(std::unique_lock<std::mutex>& lock) {
    RobotState& state = intake_->state();
    const auto scan = take_scan();
    if (has_scanner() ? !scan : state.cameras.front().images.empty()) return std::nullopt;
    const double end_s = scan ? end_of_scan_s(*scan) : state.cameras.front().images.back().stamp_s;
    std::vector<CameraImage> images =
        decoded(take_images(state, end_s), contact_.vehicle.cameras, *intake_, lock);
    if (!scan && (images.empty() || images.front().stamp_s != end_s)) return std::nullopt;
    intake_->wait_for_odometry(lock, end_s, kOdometryWait_s);
    if (state.trail.newest_s() < end_s) ++state.counts.odometry_late;
    Observation observation;
    observation.stamp_s = mission_clock_.at(end_s);
    if (scan)
      observation.scan =
          RangeScan{observation.stamp_s,
                    fitted_ranges(*scan, contact_.grid, [&](double s) { return state.trail.at(s); })};
    for (CameraImage& image : images) image.stamp_s += observation.stamp_s - end_s;
    observation.images = std::move(images);
    if (!readings_) readings_.emplace(contact_.vehicle, state.trail.at(end_s));
    observation.odometry = readings_->read(state.trail.at(end_s), steering_rad_);
    odometry_ = {ros::stamp_ns(end_s), state.trail.in_odom(state.trail.at(end_s))};
    observation.bumper_pressed = touches(state);
    if (state.joystick) observation.operator_input = state.joystick->input(intake_->now_s());
    return observation;
  }

  bool touches(RobotState& state) const {
    bool touched = false;
    for (std::size_t i = 0; i < state.bumpers.size(); ++i) {
      SwitchState& bumper = state.bumpers[i];
      touched |= bumper.is_pressed || bumper.was_pressed ||
                 bumper.is_silent(connection_.bumpers[i].silent_max_s, intake_->now_s());
      bumper.was_pressed = false;
    }
    return touched;
  }

  const Connection connection_;
  Surroundings surroundings_;
  std::unique_ptr<RobotIntake> intake_;
  const FirstContact contact_;
  const std::string command_topic_;
  const RobotMonitor monitor_;
  std::optional<OdometryReadings> readings_;
  Odometry odometry_;
  double looked_s_ = kNever_s;
  std::string obstacle_;
  std::string held_because_;
  std::string end_reason_;
  double steering_rad_ = 0;
  MissionClock mission_clock_;
  std::size_t holds_ = 0;
  std::optional<CommandOutlet> outlet_;  ///< last: it uses the intake to its end; none: nothing is sent
};

Result<std::unique_ptr<ConnectedVehicle>> ConnectedVehicle::connect(const Connection& connection,
                                                                    const VehicleDescription& vehicle,
                                                                    Surroundings surroundings) {
  auto intake = RobotIntake::open(surroundings.wire, connection, vehicle, surroundings.clock);
  if (!intake) return intake.problems();
  auto contact = make_contact(connection, vehicle, **intake, surroundings);
  if (!contact) return contact.problems();
  std::unique_ptr<WirePublisher> publisher;
  if (contact->commands) {
    auto advertised = surroundings.wire.advertise(connection.topic(connection.commands.topic),
                                                  command_type(*contact->commands), WireQuality::kCommand);
    if (!advertised) return advertised.problems();
    publisher = std::move(*advertised);
  }
  auto cycle = std::make_unique<Cycle>(connection, std::move(surroundings), std::move(*intake),
                                       std::move(*contact), std::move(publisher));
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

std::optional<ConnectedVehicle::Battery> ConnectedVehicle::battery() const {
  return cycle_->battery();
}

Arc ConnectedVehicle::commanded() const {
  return cycle_->commanded();
}

ConnectionCounts ConnectedVehicle::counts() const {
  return cycle_->counts();
}

}  // namespace aisle
