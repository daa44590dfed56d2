#include <gmock/gmock.h>

#include <vector>

#include "aisle/guidance/mission.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

/// Delivers observations for a number of cycles of 0.1 s, and records the commanded speeds.
class CountingVehicle final : public Vehicle {
 public:
  explicit CountingVehicle(int cycles) : cycles_left_(cycles) {}

  const VehicleDescription& description() const override { return description_; }
  std::optional<Observation> sense() override {
    if (cycles_left_-- == 0) return std::nullopt;
    Observation observation;
    observation.stamp_s = stamp_s_ += 0.1;
    return observation;
  }
  std::string end_reason() const override { return cycles_left_ < 0 ? "the wires are cut" : ""; }
  void act(const Command& command) override { speeds_mps.push_back(command.speed_mps); }

  std::vector<double> speeds_mps;

 private:
  VehicleDescription description_;
  int cycles_left_;
  double stamp_s_ = 0;
};

/// Drives until a stamp, then is done.
class TimedNavigator final : public Navigator {
 public:
  explicit TimedNavigator(double until_s) : until_s_(until_s) {}
  Decision step(const Observation& observation) override {
    if (observation.stamp_s > until_s_) return {.status = NavigatorStatus::kDone, .state = "arrived"};
    return {.command = {.speed_mps = 1}, .state = "going"};
  }

 private:
  double until_s_;
};

/// Fails when it is full.
class SmallRecord final : public MissionRecord {
 public:
  explicit SmallRecord(int capacity) : left_(capacity) {}
  Result<Observation> keep(Observation observation) override {
    if (left_-- == 0) return Problem{{"record"}, "is full"};
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

 private:
  int left_;
};

TEST(Mission, EndsWithTheNavigatorAndAStop) {
  CountingVehicle vehicle(100);
  TimedNavigator navigator(0.25);
  SmallRecord record(1000);
  SilentProgress progress;
  const auto end = run_mission(vehicle, navigator, record, progress);
  ASSERT_TRUE(end.ok());
  EXPECT_TRUE(end->arrived);
  EXPECT_EQ(end->state, "arrived");
  EXPECT_EQ(end->cycles, 3U);
  EXPECT_NEAR(end->duration_s, 0.2, 1e-12);
  EXPECT_THAT(vehicle.speeds_mps, ElementsAre(1, 1, 0, 0));
}

TEST(Mission, StopsTheVehicleWhenObservationsEnd) {
  CountingVehicle vehicle(2);
  TimedNavigator navigator(10);
  SmallRecord record(1000);
  SilentProgress progress;
  const auto end = run_mission(vehicle, navigator, record, progress);
  ASSERT_TRUE(end.ok());
  EXPECT_FALSE(end->arrived);
  EXPECT_EQ(end->state, "going");
  EXPECT_EQ(end->why, "the wires are cut");
  EXPECT_THAT(vehicle.speeds_mps, ElementsAre(1, 1, 0));
}

TEST(Mission, StopsTheVehicleWhenTheRecordFails) {
  CountingVehicle vehicle(100);
  TimedNavigator navigator(10);
  SmallRecord record(2);
  SilentProgress progress;
  const auto end = run_mission(vehicle, navigator, record, progress);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(to_string(end.problems()), "record: is full");
  EXPECT_THAT(vehicle.speeds_mps, ElementsAre(1, 1, 0));
}

TEST(Mission, StopsTheVehicleWhenInterrupted) {
  class Impatient final : public Progress {
    void report(std::string_view, std::size_t, std::size_t) override { throw Interrupted(); }
  } impatient;
  CountingVehicle vehicle(100);
  TimedNavigator navigator(10);
  SmallRecord record(1000);
  EXPECT_THROW((void)run_mission(vehicle, navigator, record, impatient), Interrupted);
  EXPECT_THAT(vehicle.speeds_mps, ElementsAre(1, 0));
}

TEST(Mission, EndsWhereTheUserEndsIt) {
  class Content final : public Progress {
   public:
    void report(std::string_view, std::size_t done, std::size_t) override { done_ = done; }
    bool shall_end() const override { return done_ == 2; }

   private:
    std::size_t done_ = 0;
  } content;
  CountingVehicle vehicle(100);
  TimedNavigator navigator(10);
  SmallRecord record(1000);
  const auto end = run_mission(vehicle, navigator, record, content);
  ASSERT_TRUE(end.ok());
  EXPECT_FALSE(end->arrived);
  EXPECT_EQ(end->why, kEndedByUser);
  EXPECT_EQ(end->cycles, 2U);
  EXPECT_THAT(vehicle.speeds_mps, ElementsAre(1, 1, 0));
}

}  // namespace
}  // namespace aisle
