#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::Gt;
using testing::Lt;

World hall() {
  World world{.name = "hall"};
  for (const Segment2& line : {Segment2{{20, -5}, {20, 5}}, Segment2{{20, 5}, {-5, 5}},
                               Segment2{{-5, 5}, {-5, -5}}, Segment2{{-5, -5}, {20, -5}}}) {
    world.walls.push_back({.floor_edge = line});
  }
  return world;
}

VehicleModel cart(const WheelErrors& errors = kPerfectWheels) {
  VehicleModel model;
  model.description.front_steered.wheelbase_m = 0.75;
  model.description.footprint = {.front_m = 1, .rear_m = 0.2, .width_m = 0.6, .height_m = 1.2};
  model.simulated.odometry = errors;
  return model;
}

VehicleModel with_scanner(VehicleModel model) {
  model.description.scanner = kOneReadingADegree;
  return model;
}

/// Everything of a run that can be compared.
struct SimulatedRun {
  std::vector<Observation> observations;
  std::vector<Truth> truths;
};

SimulatedRun drive(const World& world, const VehicleModel& model, const Scenario& scenario,
                   const Command& command, double time_s, std::uint64_t seed = 1) {
  SimulatedVehicle vehicle(world, model, scenario, {.seed = seed, .takes_images = false});
  SimulatedRun run;
  while (vehicle.truth().stamp_s < time_s - 1e-9) {
    vehicle.act(command);
    run.observations.push_back(*vehicle.sense());
    run.truths.push_back(vehicle.truth());
  }
  return run;
}

SimulatedRun drive(const Scenario& scenario, const Command& command = {.speed_mps = 0.5},
                   double time_s = 10) {
  return drive(hall(), with_scanner(cart(WheelErrors{})), scenario, command, time_s);
}

double distance_m(const Observation& observation) {
  return std::get<FrontSteeredMotion>(observation.odometry).distance_m;
}

void expect_same_truth(const SimulatedRun& a, const SimulatedRun& b) {
  ASSERT_EQ(a.truths.size(), b.truths.size());
  for (std::size_t i = 0; i < a.truths.size(); ++i) {
    EXPECT_THAT(a.truths[i].T_world_vehicle, PoseNear(b.truths[i].T_world_vehicle, 0, 0));
  }
}

void expect_same_scans(const SimulatedRun& a, const SimulatedRun& b) {
  ASSERT_EQ(a.observations.size(), b.observations.size());
  for (std::size_t i = 0; i < a.observations.size(); ++i) {
    EXPECT_EQ(a.observations[i].scan->ranges_m, b.observations[i].scan->ranges_m) << i;
  }
}

void expect_same_odometry(const SimulatedRun& a, const SimulatedRun& b) {
  ASSERT_EQ(a.observations.size(), b.observations.size());
  for (std::size_t i = 0; i < a.observations.size(); ++i) {
    EXPECT_EQ(distance_m(a.observations[i]), distance_m(b.observations[i])) << i;
  }
}

TEST(SimulatedVehicle, StandsUntilItIsCommanded) {
  SimulatedVehicle vehicle(hall(), cart(), {}, {.takes_images = false});
  for (int i = 0; i < 5; ++i) (void)vehicle.sense();
  EXPECT_THAT(vehicle.truth().T_world_vehicle, PoseNear(Pose2{}, 0, 0));
  EXPECT_NEAR(vehicle.truth().stamp_s, 0.5, 1e-12);
}

TEST(SimulatedVehicle, PerfectOdometryAddsUpToTheTruth) {
  const VehicleModel model = cart();
  SimulatedVehicle vehicle(hall(), model, {}, {.takes_images = false});
  Pose2 T_start_counted;
  for (int i = 0; i < 100; ++i) {
    vehicle.act({.speed_mps = 0.6, .steering_rad = 0.5 * std::sin(0.05 * i)});
    const auto motion = std::get<FrontSteeredMotion>(vehicle.sense()->odometry);
    T_start_counted = T_start_counted * aisle::drive(model.description.front_steered, motion);
  }
  EXPECT_GT(vehicle.truth().path_m, 4);
  EXPECT_THAT(T_start_counted, PoseNear(vehicle.truth().T_world_vehicle, 0.005, 0.001));
}

TEST(SimulatedVehicle, StopsWhenCommandsStayAway) {
  SimulatedVehicle vehicle(hall(), cart(), {}, {.takes_images = false});
  for (int i = 0; i < 30; ++i) {
    vehicle.act({.speed_mps = 0.5});
    (void)vehicle.sense();
  }
  EXPECT_NEAR(vehicle.truth().speed_mps, 0.5, 1e-9);
  for (int i = 0; i < 4; ++i) (void)vehicle.sense();
  EXPECT_NEAR(vehicle.truth().speed_mps, 0.5, 1e-9);
  for (int i = 0; i < 5; ++i) (void)vehicle.sense();  // 0.5 s of age, 0.33 s of braking
  EXPECT_EQ(vehicle.truth().speed_mps, 0);
}

TEST(SimulatedVehicle, HoldsItsLimitsOfSpeedAndSteeringWhateverItIsCommanded) {
  VehicleModel model = cart();
  model.description.limits.speed_max_mps = 0.4;
  model.description.limits.reverse_speed_max_mps = 0.2;
  model.description.limits.steering_max_rad = 0.3;
  for (const double wild : {9.0, -9.0}) {
    const SimulatedRun run = drive(hall(), model, {}, {.speed_mps = wild, .steering_rad = wild}, 8);
    for (const Truth& truth : run.truths) {
      EXPECT_LE(truth.speed_mps, 0.4 + 1e-9);
      EXPECT_GE(truth.speed_mps, -0.2 - 1e-9);
      EXPECT_LE(std::abs(truth.turn_rate_rad_s), 0.4 * std::sin(0.3) / 0.75 + 1e-9);
    }
    EXPECT_GT(run.truths.back().path_m, 1);
  }
}

TEST(SimulatedVehicle, ACommandThatIsNotANumberMeansStop) {
  const double nan = std::nan("");
  for (const Command& senseless : {Command{nan, 0, 0}, Command{0.3, nan, 0}, Command{0.3, 0, nan}}) {
    SimulatedVehicle vehicle(hall(), cart(), {}, {.takes_images = false});
    for (int i = 0; i < 20; ++i) {
      vehicle.act({.speed_mps = 0.3});
      (void)vehicle.sense();
    }
    for (int i = 0; i < 5; ++i) {
      vehicle.act(senseless);
      (void)vehicle.sense();
    }
    EXPECT_EQ(vehicle.truth().speed_mps, 0);
    EXPECT_TRUE(vehicle.truth().T_world_vehicle.is_finite());
  }
}

TEST(SimulatedVehicle, AWallStopsItAndCountsOnce) {
  const SimulatedRun run = drive(hall(), cart(), {}, {.speed_mps = 1}, 30);
  const Truth& end = run.truths.back();
  EXPECT_NEAR(end.T_world_vehicle.x, 19, 1e-3);  // its front is 1 m ahead
  EXPECT_LT(end.T_world_vehicle.x, 19);
  EXPECT_EQ(end.collisions, 1U);
  EXPECT_EQ(end.speed_mps, 0);
  EXPECT_TRUE(run.observations.back().bumper_pressed);
  EXPECT_FALSE(run.observations.front().bumper_pressed);
}

TEST(SimulatedVehicle, BacksAwayFromAWall) {
  SimulatedVehicle vehicle(hall(), cart(), {}, {.T_world_start = {18.9, 0, 0}, .takes_images = false});
  const auto drive_for = [&](double speed_mps, int cycles) {
    std::optional<Observation> last;
    for (int i = 0; i < cycles; ++i) {
      vehicle.act({.speed_mps = speed_mps});
      last = vehicle.sense();
    }
    return last->bumper_pressed;
  };
  EXPECT_TRUE(drive_for(0.5, 20));
  EXPECT_FALSE(drive_for(-0.5, 20));
  EXPECT_TRUE(drive_for(0.5, 40));
  EXPECT_EQ(vehicle.truth().collisions, 2U);
}

TEST(SimulatedVehicle, CannotBeDrivenThroughAWallByAnyCommands) {
  Random random(5);
  SimulatedVehicle vehicle(hall(), cart(), {}, {.takes_images = false});
  for (int i = 0; i < 3000; ++i) {
    if (i % 20 == 0) {
      vehicle.act({.speed_mps = random.uniform(-1, 1), .steering_rad = random.uniform(-0.7, 0.7)});
    } else {
      vehicle.act({.speed_mps = 1, .steering_rad = random.uniform(-0.7, 0.7)});
    }
    (void)vehicle.sense();
    ASSERT_TRUE(fits(hall(), cart().description.footprint, vehicle.truth().T_world_vehicle));
  }
  EXPECT_THAT(vehicle.truth().collisions, Gt(0U));
}

TEST(SimulatedVehicle, WaitingPeopleAreSeenByTheScanner) {
  World world = hall();
  world.people.push_back({.path = {{5, -3}, {5, 3}}, .start_s = 100});
  world.people.push_back({.path = {{5, 0}, {5, 1}}, .start_s = 100, .height_m = 0.2});  // below the scanner
  VehicleModel model = with_scanner(cart());
  model.simulated.scanner.noise_sigma_m = model.simulated.scanner.dropped_share = 0;
  const SimulatedRun run = drive(world, model, {}, {}, 0.1);
  EXPECT_NEAR(run.observations[0].scan->ranges_m[90], 20, 0.02);
  EXPECT_NEAR(run.observations[0].scan->ranges_m[90 - 31], std::hypot(5, 3) - 0.25, 0.03);
}

TEST(SimulatedVehicle, SameSeedSameRunAndAnotherSeedAnother) {
  const VehicleModel model = with_scanner(cart(WheelErrors{}));
  const Command command{.speed_mps = 0.5, .steering_rad = 0.05};
  const SimulatedRun a = drive(hall(), model, {}, command, 5), b = drive(hall(), model, {}, command, 5),
                     other = drive(hall(), model, {}, command, 5, 2);
  expect_same_truth(a, b);
  expect_same_scans(a, b);
  expect_same_odometry(a, b);
  EXPECT_NE(a.observations.back().scan->ranges_m, other.observations.back().scan->ranges_m);
  EXPECT_NE(a.truths.back().T_world_vehicle.y, other.truths.back().T_world_vehicle.y);
}

TEST(SimulatedVehicle, TheSteeringsBiasIsInTheTruthButNotInTheReading) {
  VehicleModel model = cart();
  model.simulated.odometry.steering_bias_rad = 2 * kDegree;
  const SimulatedRun run = drive(hall(), model, {}, {.speed_mps = 0.5}, 10);
  EXPECT_NEAR(std::get<FrontSteeredMotion>(run.observations.back().odometry).steering_rad, 0, 1e-12);
  const double front_m = run.truths.back().path_m / std::cos(2 * kDegree);
  EXPECT_NEAR(run.truths.back().T_world_vehicle.theta, front_m * std::sin(2 * kDegree) / 0.75, 1e-6);
}

TEST(Faults, ASlipBurstIsCountedButNotDriven) {
  const SimulatedRun usual = drive({});
  const SimulatedRun slips =
      drive({.events = {{.fault = SlipBurst{.spin = 1}, .from_s = 5.05, .duration_s = 2}}});
  expect_same_truth(usual, slips);
  expect_same_scans(usual, slips);
  double usual_m = 0, slips_m = 0;
  for (std::size_t i = 0; i < usual.observations.size(); ++i) {
    usual_m += distance_m(usual.observations[i]);
    slips_m += distance_m(slips.observations[i]);
  }
  EXPECT_NEAR(slips_m - usual_m, 2 * 0.5 * 1.01, 0.02);
}

TEST(Faults, ASteeringBiasTurnsTheVehicleFromThenOn) {
  const SimulatedRun usual = drive({});
  const SimulatedRun biased = drive({.events = {{.fault = SteeringBias{3 * kDegree}, .from_s = 5}}});
  EXPECT_THAT(biased.truths[45].T_world_vehicle, PoseNear(usual.truths[45].T_world_vehicle, 0, 0));
  const double turned_rad =
      biased.truths.back().T_world_vehicle.theta - usual.truths.back().T_world_vehicle.theta;
  EXPECT_NEAR(turned_rad, 5 * 0.5 * std::sin(3 * kDegree) / 0.75, 0.01);
  EXPECT_NEAR(std::get<FrontSteeredMotion>(biased.observations.back().odometry).steering_rad, 0, 1e-12);
  expect_same_odometry(usual, biased);
}

TEST(Faults, ABoxBlocksThePathAndIsSeen) {
  const SimulatedRun usual = drive({});
  const SimulatedRun blocked =
      drive({.events = {{.fault = BlockingBox{.T_world_box = {4, 0, 0}}, .from_s = 2}}});
  EXPECT_NEAR(blocked.truths.back().T_world_vehicle.x, 4 - 0.25 - 1, 0.01);
  EXPECT_EQ(blocked.truths.back().collisions, 1U);
  EXPECT_LT(blocked.observations[25].scan->ranges_m[90], 4);
  EXPECT_GT(blocked.observations[15].scan->ranges_m[90], 15);
  EXPECT_EQ(usual.truths.back().collisions, 0U);
}

TEST(Faults, APersonCrossesAndIsNotRunOverWhileStanding) {
  const Scenario crossing{
      .events = {{.fault = CrossingPerson{{.path = {{0.5, 2}, {0.5, -2}}}}, .from_s = 1}}};
  const SimulatedRun run = drive(crossing, {});
  EXPECT_EQ(run.truths.back().collisions, 0U);
  EXPECT_NEAR(run.observations[30].scan->ranges_m[144], 0.61, 0.03);
}

TEST(Faults, AKidnappedVehicleIsElsewhereAndItsWheelsHaveNotTurned) {
  const SimulatedRun usual = drive({});
  const SimulatedRun lifted = drive({.events = {{.fault = Lifted{{5, 3, kPi}}, .from_s = 5}}});
  EXPECT_THAT(lifted.truths[48].T_world_vehicle, PoseNear(usual.truths[48].T_world_vehicle, 0, 0));
  EXPECT_THAT(lifted.truths[49].T_world_vehicle, PoseNear(Pose2{5, 3, kPi}, 0.01, 0.01));
  EXPECT_LT(distance_m(lifted.observations[49]), 0.06);
  EXPECT_LT(lifted.truths.back().T_world_vehicle.x, 4);
}

TEST(Faults, FaultsOfCamerasLeaveEverythingElseAsItIs) {
  const SimulatedRun usual = drive({});
  for (const Fault& fault : {Fault{CameraFault{}}, Fault{LaserOff{}}, Fault{LightChange{}}}) {
    const SimulatedRun run = drive({.events = {{.fault = fault}}});
    expect_same_truth(usual, run);
    expect_same_scans(usual, run);
    expect_same_odometry(usual, run);
  }
}

TEST(Start, IsWhereTheWorldSaysElseWhereItsTourBegins) {
  World world;
  EXPECT_FALSE(start_pose(world));
  world.tour = {{1, 2}, {1, 2}, {1, 5}};
  EXPECT_THAT(*start_pose(world), PoseNear(Pose2{1, 2, kPi / 2}, 0, 1e-12));
  world.start = Pose2{3, 4, 1};
  EXPECT_THAT(*start_pose(world), PoseNear(Pose2{3, 4, 1}, 0, 0));
}

}  // namespace
}  // namespace aisle
