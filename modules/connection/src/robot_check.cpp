#include "aisle/connection/robot_check.hpp"

#include <fmt/format.h>

#include "first_contact.hpp"
#include "robot_intake.hpp"

namespace aisle {
namespace {

constexpr double kListenAgain_s = 0.05;
constexpr double kClockOffset_s = 0.1;  // clocks of machines that are kept together differ by less
constexpr double kScanRateMin_hz = 4;   // at half a metre a second: a scan every 12 cm
constexpr double kOdometryRateMin_hz = 10;
constexpr double kMoved_m = 0.02;

void warn(RobotCheck& check, const std::string& topic, std::string what) {
  check.warnings.push_back({{topic}, std::move(what)});
}

void judge_pace(RobotCheck& check, const std::string& topic, const TopicPace& pace, double rate_min_hz,
                double silent_max_s) {
  if (pace.rate_hz() < rate_min_hz)
    warn(check, topic,
         fmt::format("comes {:.1f} times a second; aisle wants {:.0f} or more", pace.rate_hz(), rate_min_hz));
  if (pace.gap_max_s > silent_max_s / 2)
    warn(check, topic,
         fmt::format("was silent for {:.2f} s; a mission ends after {:.2f} s", pace.gap_max_s, silent_max_s));
}

void judge_clock(RobotCheck& check, const std::string& topic, const TopicPace& pace) {
  if (std::abs(pace.age_min_s) > kClockOffset_s)
    warn(check, topic,
         fmt::format("its stamps are {:.2f} s {} this machine's clock: they come late, or the clocks of two "
                     "machines differ",
                     std::abs(pace.age_min_s), pace.age_min_s > 0 ? "behind" : "ahead of"));
}

void judge_counts(RobotCheck& check, const std::string& place) {
  const ConnectionCounts& counts = check.counts;
  if (counts.unreadable > 0)
    warn(check, place, fmt::format("{} messages could not be read", counts.unreadable));
  if (counts.scans_foreign > 0)
    warn(check, place,
         fmt::format("{} scans or images have another frame: two sensors publish on one topic",
                     counts.scans_foreign));
  if (counts.out_of_order > 0)
    warn(check, place, fmt::format("{} stamps were not newer than the one before", counts.out_of_order));
  if (counts.odometry_leaps > 0)
    warn(check, "odometry", fmt::format("it leapt {} times", counts.odometry_leaps));
}

}  // namespace

Result<RobotCheck> check_robot(const Connection& connection, const VehicleDescription& vehicle,
                               const ConnectedVehicle::Surroundings& surroundings, double listen_s) {
  auto intake = RobotIntake::open(surroundings.wire, connection, vehicle, surroundings.clock);
  if (!intake) return intake.problems();
  auto contact = make_contact(connection, vehicle, **intake, surroundings);
  if (!contact) return contact.problems();
  const double until_s = surroundings.clock.now_s() + listen_s;
  auto lock = (*intake)->lock();
  RobotState& state = (*intake)->state();
  state.scan.pace = state.odometry_pace = {};
  for (ArrivingImages& camera : state.cameras) camera.stream.pace = {};
  const Pose2 T_start = state.trail.at(state.trail.newest_s());
  while (surroundings.clock.now_s() < until_s && state.broken.empty()) {
    lock.unlock();
    surroundings.progress.report("listening", 0, 0);
    lock.lock();
    (*intake)->wait(lock, kListenAgain_s);
  }
  if (!state.broken.empty()) return Problem{{connection.file}, state.broken};
  RobotCheck check{.vehicle = contact->vehicle,
                   .beams = contact->grid.beams,
                   .is_upside_down = contact->is_upside_down,
                   .command_type = contact->commands ? command_type(*contact->commands) : std::string(),
                   .scan = state.scan.pace,
                   .odometry = state.odometry_pace,
                   .cameras = contact->cameras,
                   .counts = state.counts};
  check.counts.scans_skipped = check.counts.images_skipped = 0;  // nobody takes them here
  check.standing_m = (state.trail.at(state.trail.newest_s()).position() - T_start.position()).norm();
  const bool has_own_stamps = connection.clock == ConnectedClock::kStamps;
  if (!connection.scan.topic.empty()) {
    const std::string& topic = (*intake)->scans().topic;
    judge_pace(check, topic, check.scan, kScanRateMin_hz, connection.scan.silent_max_s);
    if (has_own_stamps) judge_clock(check, topic, check.scan);
  }
  for (std::size_t i = 0; i < check.cameras.size(); ++i) {
    SeenCamera& camera = check.cameras[i];
    camera.pace = state.cameras[i].stream.pace;
    judge_pace(check, camera.images, camera.pace, kScanRateMin_hz, connection.cameras[i].silent_max_s);
    if (has_own_stamps) judge_clock(check, camera.images, camera.pace);
  }
  const std::string& odometry = (*intake)->odometry().topic;
  judge_pace(check, odometry, check.odometry, kOdometryRateMin_hz, connection.odometry.silent_max_s);
  judge_counts(check, connection.file);
  if (check.standing_m > kMoved_m)
    warn(check, odometry,
         fmt::format("says that the robot moved by {:.2f} m though nothing was commanded", check.standing_m));
  return check;
}

}  // namespace aisle
