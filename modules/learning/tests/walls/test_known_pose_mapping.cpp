#include "aisle/learning/walls/known_pose_mapping.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

struct KnownDrive {
  RecordedDrive drive;
  LaserLog log = drive.log();
  std::vector<std::optional<Pose2>> T_map_vehicle;

  KnownDrive() {
    for (const LaserScan& scan : log.scans) T_map_vehicle.emplace_back(drive.T_map_vehicle(scan.time_s));
  }
  KnownPoseMap map() const { return map_at_poses(log, T_map_vehicle, true, {}); }
};

/// The farthest end of a drawn wall from all true walls.
double worst_off_m(const WallMap& map, const std::vector<Segment2>& truth) {
  double worst_m = 0;
  for (const Wall& wall : map.walls) {
    for (const Vec2& end : {wall.segment.start, wall.segment.end}) {
      double off_m = 1e9;
      for (const Segment2& face : truth) off_m = std::min(off_m, face.distance(end));
      worst_m = std::max(worst_m, off_m);
    }
  }
  return worst_m;
}

TEST(KnownPoseMapping, WallsLieWhereTheyAreInTheFrameOfThePoses) {
  const KnownDrive known;
  const KnownPoseMap map = known.map();
  EXPECT_GT(map.walls.length_m(), 10);
  EXPECT_LT(worst_off_m(map.walls, known.drive.walls), 0.05);
  EXPECT_EQ(map.floor.at(known.T_map_vehicle.front()->position()), Floor::kFree);
}

TEST(KnownPoseMapping, ScansWithoutAPoseAreNotUsed) {
  KnownDrive known;
  for (std::size_t i = 0; i < known.T_map_vehicle.size(); i += 3) known.T_map_vehicle[i].reset();
  for (std::size_t i = 0; i < known.log.scans.size(); i += 3)
    std::fill(known.log.scans[i].ranges_m.begin(), known.log.scans[i].ranges_m.end(), 1.0F);
  EXPECT_LT(worst_off_m(known.map().walls, known.drive.walls), 0.05);
}

TEST(KnownPoseMapping, WithoutAnyPoseThereIsNoMap) {
  KnownDrive known;
  std::fill(known.T_map_vehicle.begin(), known.T_map_vehicle.end(), std::nullopt);
  EXPECT_TRUE(known.map().walls.walls.empty());
  EXPECT_EQ(known.map().floor.count(Floor::kFree), 0u);
}

}  // namespace
}  // namespace aisle
