#include "aisle/commands/set_down.hpp"

#include "aisle/core/random.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

constexpr std::uint64_t kSetDown = 0x5e7d03;  // separates these random streams from the vehicle's
constexpr std::uint64_t kSetDownAtHome = 0x6d1de;

Pose2 or_exact(const SimulationSetting& setting, const Pose2& T_world_vehicle, const Pose2& T_world_start) {
  return fits(setting.world, setting.vehicle.description.footprint, T_world_vehicle) ? T_world_vehicle
                                                                                     : T_world_start;
}

}  // namespace

Pose2 set_down(const SimulationSetting& setting, const UncertainPose2& T_world_start, std::uint64_t seed) {
  Random random(seed ^ kSetDown);
  const Vec3 sigmas = T_world_start.covariance.diagonal().cwiseSqrt();
  const Pose2 off{random.normal(sigmas.x()), random.normal(sigmas.y()), random.normal(sigmas.z())};
  return or_exact(setting, T_world_start.mean * off, T_world_start.mean);
}

Pose2 set_down_for_landmarks(const SimulationSetting& setting, const Pose2& T_world_start,
                             std::uint64_t seed) {
  return set_down(setting, about(T_world_start, 0.05, 1 * kDegree), seed);
}

Pose2 set_down_on_route(const SimulationSetting& setting, const Pose2& T_world_start, std::uint64_t seed) {
  return set_down(setting, about(T_world_start, 0.02, 1 * kDegree), seed);
}

Pose2 set_down_at_home(const SimulationSetting& setting, const Pose2& T_world_home, std::uint64_t seed) {
  constexpr double kSigma_m = 0.05, kSigma_rad = 1 * kDegree;
  Random random(seed ^ kSetDownAtHome);
  const Pose2 off{random.normal(kSigma_m), random.normal(kSigma_m), random.normal(kSigma_rad)};
  return or_exact(setting, T_world_home * off, T_world_home);
}

Problems set_down_at_home_or(const std::optional<Pose2>& T_world_start, DrivenVehicle& driven,
                             std::uint64_t seed) {
  SimulationSetting* const setting = driven.setting();
  if (setting == nullptr) return {};
  const auto home = start_in(*setting);
  if (!home) return home.problems();
  if (T_world_start && !fits(setting->world, setting->vehicle.description.footprint, *T_world_start))
    return {{{"--start"}, "the vehicle does not fit there"}};
  driven.set_down(T_world_start.value_or(set_down_at_home(*setting, *home, seed)));
  return {};
}

}  // namespace aisle
