#include <gmock/gmock.h>

#include "aisle/report/exploration_picture.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kWaitingRing = "stroke:rgb(95%,60%,10%)";
constexpr const char* kUndoneDisc = "fill:rgb(80%,10%,20%)";

std::string picture_after(std::vector<PathEvent::Kind> events) {
  FloorGrid floor;
  floor.set({0, 0}, Floor::kFree);
  floor.set({100, 60}, Floor::kOccupied);
  ExplorationRecord record;
  for (const PathEvent::Kind kind : events)
    record.paths.push_back({.kind = kind, .path = 1, .p_map = {1, 1}});
  const WallMap walls;
  return svg({.floor = floor, .walls = walls, .record = record, .T_map_vehicle = {}});
}

TEST(ExplorationPicture, RingsThePathsThatAreNotTakenYetAndNoOthers) {
  using Kind = PathEvent::Kind;
  EXPECT_THAT(picture_after({Kind::kPushed}), HasSubstr(kWaitingRing));
  EXPECT_THAT(picture_after({Kind::kPushed, Kind::kTaken}), Not(HasSubstr(kWaitingRing)));
  EXPECT_THAT(picture_after({Kind::kPushed, Kind::kExplored}), Not(HasSubstr(kWaitingRing)));
  EXPECT_THAT(picture_after({Kind::kPushed, Kind::kTaken}), Not(HasSubstr(kUndoneDisc)));
  EXPECT_THAT(picture_after({Kind::kPushed, Kind::kAbandoned}), HasSubstr(kUndoneDisc));
}

}  // namespace
}  // namespace aisle
