#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aisle/formats/sessions/ros_time.hpp"
#include "scan_fitting.hpp"

namespace aisle {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr double kWall_m = 2;

Pose2 stands(double /*stamp_s*/) {
  return {};
}

BagScan scan_of(std::vector<float> ranges_m, ScanBeams beams) {
  BagScan scan;
  scan.time.stamp = ros::stamp_ns(100.0);
  scan.ranges_m = std::move(ranges_m);
  scan.beams = beams;
  return scan;
}

BeamGrid grid_of(double first_deg, double step_deg, std::size_t beams) {
  return {{first_deg * kDegree, step_deg * kDegree, 12, {}}, beams};
}

/// Range of a wall at x = 2 m from a scanner.
double wall_range_m(const Pose2& T_world_laser, double angle_rad) {
  return (kWall_m - T_world_laser.x) / std::cos(T_world_laser.theta + angle_rad);
}

/// A scan from right to left of the wall, by a vehicle that moves meanwhile.
BagScan scan_while(const std::function<Pose2(double)>& T_world_vehicle, const BeamGrid& grid,
                   double period_s) {
  std::vector<float> ranges_m;
  for (std::size_t i = 0; i < grid.beams; ++i) {
    const double stamp_s = 100 + period_s * static_cast<double>(i);
    ranges_m.push_back(static_cast<float>(
        wall_range_m(T_world_vehicle(stamp_s) * grid.scanner.T_vehicle_laser, grid.scanner.beam_angle(i))));
  }
  return scan_of(ranges_m, {grid.scanner.first_angle_rad, grid.scanner.angle_step_rad, period_s});
}

TEST(ScanFitting, ReadingsOfTheSameBeamsStayAsTheyAre) {
  const BeamGrid grid = grid_of(-1, 1, 3);
  const auto scan = scan_of({1, 0, kNothing}, {-1 * kDegree, 1 * kDegree, 0});
  EXPECT_EQ(fitted_ranges(scan, grid, stands), (std::vector<float>{1, 0, 12}));
}

TEST(ScanFitting, BeamsBetweenTwoReadingsOfAWallLieOnTheWall) {
  const BeamGrid coarse = grid_of(-40, 2, 41), fine = grid_of(-40, 1, 81);
  const auto ranges_m = fitted_ranges(scan_while(stands, coarse, 0), fine, stands);
  for (std::size_t i = 0; i < fine.beams; ++i)
    EXPECT_NEAR(ranges_m[i], wall_range_m({}, fine.scanner.beam_angle(i)), 1e-5) << i;
}

TEST(ScanFitting, BeamsBetweenTwoSurfacesAreUnknown) {
  const BeamGrid grid = grid_of(0, 1, 5);
  const auto ranges_m = fitted_ranges(scan_of({1, 1, 5}, {0, 2 * kDegree, 0}), grid, stands);
  EXPECT_NEAR(ranges_m[1], 1, 1e-3);
  EXPECT_EQ(ranges_m[3], 0);
  EXPECT_NEAR(ranges_m[4], 5, 1e-5);
}

TEST(ScanFitting, AVehicleThatTurnsWhileItScansSeesTheWallWhereItIsAtTheEnd) {
  const auto turning = [](double stamp_s) { return Pose2{0, 0, 0.9 * (stamp_s - 100.1)}; };
  BeamGrid grid = grid_of(-40, 1, 81);
  grid.scanner.T_vehicle_laser = {0.1, 0, 0};
  const auto scan = scan_while(turning, grid, 0.1 / 80);
  EXPECT_DOUBLE_EQ(end_of_scan_s(scan), 100.1);
  const auto ranges_m = fitted_ranges(scan, grid, turning);
  for (std::size_t i = 10; i < 70; ++i)
    EXPECT_NEAR(ranges_m[i], wall_range_m(grid.scanner.T_vehicle_laser, grid.scanner.beam_angle(i)), 1e-3)
        << i;
}

TEST(ScanFitting, AVehicleThatDrivesWhileItScansSeesTheWallWhereItIsAtTheEnd) {
  const auto driving = [](double stamp_s) { return Pose2{0.5 * (stamp_s - 100.1), 0, 0}; };
  const BeamGrid grid = grid_of(-40, 1, 81);
  const auto ranges_m = fitted_ranges(scan_while(driving, grid, 0.1 / 80), grid, driving);
  for (std::size_t i = 3; i < 78; ++i)
    EXPECT_NEAR(ranges_m[i], wall_range_m({}, grid.scanner.beam_angle(i)), 1e-3) << i;
}

TEST(ScanFitting, AFullCircleGoesOnAtItsEnd) {
  const BeamGrid grid = grid_of(-180, 1, 360);
  std::vector<float> ranges_m(360, 3);
  ranges_m[359] = kNothing;
  const auto scan = scan_of(ranges_m, {0, 1 * kDegree, 0});  // the same circle, begun ahead
  const auto fitted = fitted_ranges(scan, grid, stands);
  EXPECT_NEAR(fitted[0], 3, 1e-6);
  EXPECT_EQ(fitted[179], 12) << "the beam to the right of ahead";
  EXPECT_NEAR(fitted[180], 3, 1e-6);
}

}  // namespace
}  // namespace aisle
