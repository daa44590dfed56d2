#include "aisle/simulation/operators/tour_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kTourStep_s = 0.02;

/// One run at the fixed step: pose i is the one at i * kTourStep_s.
struct Run {
  std::vector<Pose2> T_world_vehicle;
  std::vector<Pose2> T_odom_vehicle;

  double duration_s() const { return static_cast<double>(T_world_vehicle.size() - 1) * kTourStep_s; }
};

Pose2 pose_at(const std::vector<Pose2>& poses, double time_s) {
  const double last = static_cast<double>(poses.size() - 1);
  const double position = std::clamp(time_s / kTourStep_s, 0.0, last);
  const auto before = static_cast<std::size_t>(position);
  const std::size_t after = std::min(before + 1, poses.size() - 1);
  return interpolate(poses[before], poses[after], position - static_cast<double>(before));
}

Arc counted_by_wheels(const Arc& driven, const OdometryNoiseParams& noise, Random& random) {
  const double root_m = std::sqrt(std::abs(driven.length_m));
  const double root_rad = std::sqrt(std::abs(driven.turn_rad));
  return {driven.length_m * (1 + noise.distance_error) + random.normal(noise.slip_sigma_m) * root_m,
          driven.turn_rad * (1 + noise.rotation_error) + noise.drift_rad_per_m * driven.length_m +
              random.normal(noise.drift_sigma_rad) * root_m +
              random.normal(noise.rotation_sigma_rad) * root_rad};
}

Run drive(const World& world, const TourParams& params, Random& random, Progress& progress) {
  TourDriver driver(world.tour, params.driver);
  Run run{{driver.pose()}, {Pose2{}}};
  while (!driver.has_arrived()) {
    progress.report("driving", driver.waypoints_passed(), driver.waypoints());
    const Arc counted = counted_by_wheels(driver.step(kTourStep_s), params.odometry, random);
    run.T_world_vehicle.push_back(driver.pose());
    run.T_odom_vehicle.push_back(run.T_odom_vehicle.back() * end_pose(counted));
  }
  return run;
}

}  // namespace

TourRecording record_tour(const World& world, const TourParams& params, std::uint64_t seed,
                          Progress& progress) {
  Random random(seed);
  Random scanner_random(random.bits());
  const Run run = drive(world, params, random, progress);
  const RangeScanner scanner(world, params.scanner);

  TourRecording recording;
  recording.log.laser() = scanner.description();
  const auto last = static_cast<std::size_t>(run.duration_s() / params.scan_period_s);
  for (std::size_t i = 0; i <= last; ++i) {
    const double time_s = static_cast<double>(i) * params.scan_period_s;
    const Pose2 T_world_vehicle = pose_at(run.T_world_vehicle, time_s);
    recording.T_world_vehicle.push_back(T_world_vehicle);
    recording.log.odometry.push_back({time_s, pose_at(run.T_odom_vehicle, time_s + params.odometry_delay_s)});
    recording.log.scans.push_back({time_s, time_s, scanner.scan(T_world_vehicle, scanner_random), i + 1});
    progress.report("scanning", i + 1, last + 1);
  }
  return recording;
}

}  // namespace aisle
