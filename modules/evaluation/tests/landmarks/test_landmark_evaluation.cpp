#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/evaluation/landmarks/landmark_evaluation.hpp"

namespace aisle {
namespace {

constexpr double kStep_m = 0.05;

/// Into a dead end, out of it backwards, and round a corner backwards.
Path in_and_out() {
  const Pose2 end_of_dead_end{6, 0, 0}, junction{2, 0, 0};
  return Path({{{}, {6, 0}}, {end_of_dead_end, {-4, 0}}, {junction, {-3, 60 * kDegree}}});
}

/// Taught along the path; on the way back the map has drifted by 3 cm per metre.
MapTruth drifting_truth(const Path& path) {
  constexpr double kDrift = 0.03;
  std::vector<Pose2> T_map_taught, T_world_taught;
  for (double along_m = 0; along_m < path.length_m(); along_m += kStep_m) {
    T_map_taught.push_back(path.at(along_m).T_map_path);
    const double back_m = std::max(0.0, along_m - path.start_m(1));
    T_world_taught.push_back(Pose2{0, -kDrift * back_m, 0} * T_map_taught.back());
  }
  return {T_map_taught, T_world_taught};
}

MissionErrors driven_as_taught(const Path& path, const MapTruth& truth, bool in_reverse) {
  MissionJudge judge(truth, path, in_reverse);
  const std::size_t count = truth.T_map_taught().size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t taught = in_reverse ? count - 1 - i : i;
    const Pose2 turned = in_reverse ? Pose2{0, 0, kPi} : Pose2{};
    const UncertainPose2 thought{truth.T_map_taught()[taught] * turned, Mat3::Zero()};
    judge.add(0.1 * static_cast<double>(i), {.T_map_vehicle = thought, .is_sure = true},
              truth.T_world_taught()[taught] * turned);
  }
  return judge.errors();
}

TEST(MissionJudge, FollowsAPathThatComesBackOnItself) {
  const Path path = in_and_out();
  const MissionErrors errors = driven_as_taught(path, drifting_truth(path), false);
  EXPECT_LT(errors.tracking_m.worst(), 0.01);
  EXPECT_LT(errors.across_m.worst(), 0.01);
  EXPECT_LT(errors.along_m.worst(), 0.01);
}

TEST(MissionJudge, FollowsItsPathBackToo) {
  const Path path = in_and_out();
  const MissionErrors errors = driven_as_taught(path.reversed(), drifting_truth(path), true);
  EXPECT_LT(errors.tracking_m.worst(), 0.01);
  EXPECT_LT(errors.across_m.worst(), 0.01);
  EXPECT_LT(errors.along_m.worst(), 0.01);
}

/// Straights and bends of a race track that is driven twice.
Path two_rounds() {
  std::vector<PathPiece> pieces;
  Pose2 T_map_start;
  for (int i = 0; i < 4; ++i) {
    for (const Arc& arc : {Arc{6, 0}, Arc{1.5 * kPi, kPi}}) {
      pieces.push_back({T_map_start, arc});
      T_map_start = pieces.back().end();
    }
  }
  return Path(pieces);
}

// The map of the second round lies elsewhere in the world than that of the first, by a drift of a metre.
TEST(MissionJudge, KeepsARelocalisedVehicleOnItsRound) {
  const Path path = two_rounds();
  const MapTruth truth = drifting_truth(path);
  MissionJudge judge(truth, path, false);
  const std::size_t count = truth.T_map_taught().size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_lost = i * 4 / count == 2 && i % 10 < 5;
    judge.add(
        0.1 * static_cast<double>(i),
        {.T_map_vehicle = {truth.T_map_taught()[i], Mat3::Zero()}, .is_sure = !is_lost, .is_lost = is_lost},
        truth.T_world_taught()[i]);
  }
  EXPECT_LT(judge.errors().across_m.worst(), 0.01);
  EXPECT_LT(judge.errors().along_m.worst(), 0.01);
}

TEST(MissionJudge, NoticesAVehicleWithAWrongEstimate) {
  const Path path = in_and_out();
  const MapTruth truth = drifting_truth(path);
  MissionJudge judge(truth, path, false);
  for (int i = 0; i < 40; ++i) {
    const Pose2 T_map_thought = path.at(i * kStep_m).T_map_path;
    judge.add(0.1 * i, {.T_map_vehicle = {T_map_thought, Mat3::Zero()}, .is_sure = true},
              Pose2{0.6, 0, 0} * T_map_thought);
  }
  EXPECT_TRUE(judge.errors().wrong_confident);
  EXPECT_NEAR(judge.errors().along_m.rms(), 0.6, 1e-6);
}

}  // namespace
}  // namespace aisle
