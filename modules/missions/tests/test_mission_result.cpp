#include "aisle/missions/mission_result.hpp"

#include <gmock/gmock.h>

#include "explorer_run.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Drives straight ahead for two seconds.
class StraightAhead final : public Navigator {
 public:
  Decision step(const Observation& observation) override {
    const bool is_done = observation.stamp_s >= 2;
    return {.command = {.speed_mps = 0.3},
            .status = is_done ? NavigatorStatus::kDone : NavigatorStatus::kGoing,
            .state = is_done ? "arrived" : "driving",
            .why = ""};
  }
};

/// @param has_truth  false: as a vehicle that is not simulated
MissionResult drive_ahead(SimulatedVehicle& vehicle, bool has_truth) {
  const TruthSource* truth = has_truth ? &vehicle : nullptr;
  std::optional<SessionRecord> no_session;
  MissionRecorder record(no_session, vehicle, truth);
  StraightAhead ahead;
  SilentProgress silent;
  MissionResult result;
  EXPECT_TRUE(drive_mission(vehicle, truth, ahead, record, silent, result).empty());
  return result;
}

SimulatedVehicle cart_in_hall() {
  static const World hall = walled_by({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {2, 4, 0});
  return {hall, cart_with_scanner(), {}, {.T_world_start = *hall.start}};
}

TEST(MissionResult, KeepsTheTruthOfASimulatedVehicle) {
  SimulatedVehicle vehicle = cart_in_hall();
  const MissionResult result = drive_ahead(vehicle, true);
  EXPECT_TRUE(result.is_simulated());
  EXPECT_EQ(result.collisions(), 0U);
  EXPECT_EQ(result.distance_m(), vehicle.truth().path_m);
  EXPECT_THAT(mission_text(result), StartsWith("simulated: arrived; "));
  EXPECT_THAT(mission_text(result), HasSubstr("0 collisions"));
}

TEST(MissionResult, HasNoCollisionsAndTheWheelsDistanceWithoutTruth) {
  SimulatedVehicle vehicle = cart_in_hall();
  const MissionResult result = drive_ahead(vehicle, false);
  EXPECT_FALSE(result.is_simulated());
  EXPECT_EQ(result.collisions(), std::nullopt);
  EXPECT_GT(result.distance_m(), 0.1);
  EXPECT_NEAR(result.distance_m(), vehicle.truth().path_m, 0.05);
  EXPECT_THAT(mission_text(result), Not(HasSubstr("simulated")));
  EXPECT_THAT(mission_text(result), Not(HasSubstr("collision")));
}

TEST(MissionFigures, ThatAreUnknownAreAbsent) {
  const auto figures = known_figures({{"arrived", true},
                                      {"collisions", if_known(std::optional<std::size_t>())},
                                      {"lost_count", if_known(std::optional<std::size_t>(2))}});
  EXPECT_EQ(figures.dump(), R"({"arrived":true,"lost_count":2})");
}

}  // namespace
}  // namespace aisle
