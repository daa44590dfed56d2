#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "vehicle/vehicle_eyes.hpp"

namespace aisle {
namespace {

constexpr double kPhysicsStep_s = 0.01;
constexpr double kKeptFromMovers_m = 0.2;
constexpr double kContactLeft_m = 0.01;
constexpr double kContactLeft_rad = 1 * kDegree;

long steps_per_cycle(double cycle_s) {
  return std::max(1L, std::lround(cycle_s / kPhysicsStep_s));
}

std::optional<RangeScanner> scanner_of(const World& world, const VehicleModel& model) {
  if (!model.description.scanner) return std::nullopt;
  return RangeScanner(world, {.laser = *model.description.scanner, .sensor = model.simulated.scanner});
}

}  // namespace

std::optional<Pose2> start_pose(const World& world) {
  if (world.start) return world.start;
  const auto next = std::find_if(world.tour.begin(), world.tour.end(),
                                 [&](const Vec2& p) { return p != world.tour.front(); });
  if (next == world.tour.end()) return std::nullopt;
  const Vec2 first = world.tour.front(), along = *next - first;
  return Pose2{first.x(), first.y(), heading_of(along)};
}

bool fits(const World& world, const Footprint& footprint, const Pose2& T_world_vehicle) {
  return !Obstacles(world, footprint).touch(T_world_vehicle);
}

SimulatedVehicle::SimulatedVehicle(const World& world, const VehicleModel& model, const Scenario& scenario,
                                   const SimulationOptions& options, Operator* driver)
    : model_(model),
      play_(scenario),
      driver_(driver),
      dynamics_(model.description),
      seeds_(options.seed),
      odometry_(model.description, model.simulated.odometry, Random(seeds_.bits())),
      slip_random_(seeds_.bits()),
      scanner_(scanner_of(world, model)),
      scanner_random_(seeds_.bits()),
      obstacles_(world, model.description.footprint),
      bodies_(world.people) {
  if (!options.T_world_start.is_finite()) throw std::invalid_argument("a start pose must be finite");
  if (options.takes_images && !model.description.cameras.empty()) {
    eyes_ = std::make_unique<VehicleEyes>(world, model, seeds_);
  }
  truth_.T_world_vehicle = options.T_world_start;
}

SimulatedVehicle::~SimulatedVehicle() = default;

std::optional<Observation> SimulatedVehicle::sense() {
  const long steps = steps_per_cycle(model_.description.cycle_s);
  for (long i = 0; i < steps; ++i) step(model_.description.cycle_s / static_cast<double>(steps));

  Observation observation{.stamp_s = truth_.stamp_s};
  if (eyes_) observation.images = eyes_->deliver(truth_.stamp_s);
  observation.odometry = odometry_.read();
  observation.scan = scan();
  observation.bumper_pressed = T_world_contact_.has_value();
  if (driver_ != nullptr) observation.operator_input = driver_->look(view());
  return observation;
}

void SimulatedVehicle::act(const Command& command) {
  const bool is_command = std::isfinite(command.speed_mps) && std::isfinite(command.steering_rad) &&
                          std::isfinite(command.turn_rate_rad_s);
  command_ = is_command ? command : Command{};
  command_stamp_s_ = truth_.stamp_s;
}

Command SimulatedVehicle::commanded() const {
  const double age_s = truth_.stamp_s - command_stamp_s_;
  if (age_s <= model_.description.limits.command_age_max_s) return command_;
  return {.steering_rad = command_.steering_rad};
}

void SimulatedVehicle::step(double time_s) {
  truth_.stamp_s = static_cast<double>(++steps_) * time_s;
  play_.advance(truth_.stamp_s, truth_.T_world_vehicle.position());
  bodies_.step(truth_.stamp_s, time_s, play_, model_.description.footprint, truth_.T_world_vehicle);
  obstacles_.set_movers(bodies_.outlines());
  kidnap_if_due();
  drive(time_s);
  if (eyes_) {
    eyes_->look(truth_.stamp_s,
                {.T_world_vehicle = truth_.T_world_vehicle,
                 .speed_mps = truth_.speed_mps,
                 .turn_rate_rad_s = truth_.turn_rate_rad_s},
                bodies_.all(), play_);
  }
}

void SimulatedVehicle::drive(double time_s) {
  const WheelErrors& errors = model_.simulated.odometry;
  const Travel travel = dynamics_.step(commanded(), time_s);
  Arc path = arc_of(model_.description, travel, errors.steering_bias_rad + play_.steering_bias_rad());
  path.turn_rad +=
      slip_random_.normal(errors.heading_slip_rad_per_sqrt_m) * std::sqrt(std::abs(path.length_m));
  move(travel, path, time_s);
}

void SimulatedVehicle::move(const Travel& travel, const Arc& path, double time_s) {
  const bool stands = path.length_m == 0 && path.turn_rad == 0;
  const double free = stands ? 1 : obstacles_.free_share(truth_.T_world_vehicle, path);
  const Arc driven{free * path.length_m, free * path.turn_rad};
  truth_.T_world_vehicle = truth_.T_world_vehicle * end_pose(driven);
  truth_.speed_mps = driven.length_m / time_s;
  truth_.turn_rate_rad_s = driven.turn_rad / time_s;
  truth_.path_m += std::abs(driven.length_m);
  odometry_.count(free * travel, play_.spin());
  feel_bumper(free);
}

void SimulatedVehicle::feel_bumper(double free_share) {
  if (free_share < 1) {
    dynamics_.halt();
    if (T_world_contact_) return;
    ++truth_.collisions;
    T_world_contact_ = truth_.T_world_vehicle;
  } else if (T_world_contact_) {
    const Pose2 T_contact_vehicle = between(*T_world_contact_, truth_.T_world_vehicle);
    const bool has_left = T_contact_vehicle.position().norm() > kContactLeft_m ||
                          std::abs(T_contact_vehicle.theta) > kContactLeft_rad;
    if (has_left) T_world_contact_.reset();
  }
}

/// The wheels do not turn meanwhile. Nobody puts a vehicle down on an obstacle.
void SimulatedVehicle::kidnap_if_due() {
  for (std::size_t event = 0; event < play_.size(); ++event) {
    const auto* lifted = std::get_if<Lifted>(&play_.fault(event));
    if (lifted == nullptr || !play_.is_on(event) || lifts_done_.contains(event)) continue;
    if (obstacles_.touch(lifted->T_world_vehicle)) continue;
    truth_.T_world_vehicle = lifted->T_world_vehicle;
    T_world_contact_.reset();
    dynamics_.halt();
    lifts_done_.insert(event);
  }
}

std::optional<RangeScan> SimulatedVehicle::scan() {
  if (!scanner_) return std::nullopt;
  const std::vector<Segment2> movers = bodies_.outlines(model_.simulated.scanner.height_m);
  return RangeScan{.stamp_s = truth_.stamp_s,
                   .ranges_m = scanner_->scan(truth_.T_world_vehicle, scanner_random_, movers)};
}

OperatorView SimulatedVehicle::view() {
  obstacles_.set_movers(bodies_.outlines(0, kKeptFromMovers_m));  // until the next step
  const Command& motion = dynamics_.state();
  const bool goes_back = motion.speed_mps < 0;
  Arc ahead = arc_of(model_.description, {.distance_m = goes_back ? -kSeenAhead_m : kSeenAhead_m,
                                          .steering_rad = motion.steering_rad});
  return {.stamp_s = truth_.stamp_s,
          .T_world_vehicle = truth_.T_world_vehicle,
          .speed_mps = truth_.speed_mps,
          .turn_rate_rad_s = truth_.turn_rate_rad_s,
          .free_ahead_m = kSeenAhead_m * obstacles_.free_share(truth_.T_world_vehicle, ahead),
          .bumper_pressed = T_world_contact_.has_value()};
}

}  // namespace aisle
