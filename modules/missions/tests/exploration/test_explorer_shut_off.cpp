#include <gtest/gtest.h>

#include <algorithm>

#include "explorer_run.hpp"

namespace aisle {
namespace {

/// A hall of 10 m x 10 m, in which a search does not try all poses; off it a dead end, 1 m wide, and off that
/// a room. Its door is 0.95 m wide and opens 0.26 m before the end: the vehicle cannot swing in.
World hall_with_a_room_that_is_shut_off() {
  return walled_by({{0, 0},
                    {10, 0},
                    {10, 10},
                    {0, 10},
                    {0, 5.33},
                    {-5.79, 5.33},
                    {-5.79, 5.46},
                    {-4.5, 5.46},
                    {-4.5, 8},
                    {-7, 8},
                    {-7, 5.46},
                    {-6.74, 5.46},
                    {-6.74, 5.33},
                    {-7, 5.33},
                    {-7, 4.33},
                    {0, 4.33}},
                   {5, 4.7, kPi});
}

TEST(ExplorerShutOff, GivesUpARoomThatItCannotSwingInto) {
  constexpr double kLate_s = 600;
  ExplorerRun run(hall_with_a_room_that_is_shut_off(), 1);
  while (run.goes_on(kLate_s)) run.step();
  EXPECT_EQ(run.last.status, NavigatorStatus::kDone);
  EXPECT_EQ(run.last.why, "explored");
  EXPECT_EQ(run.vehicle.truth().collisions, 0);
  const auto events = run.explorer->record().paths;
  EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                          [](const PathEvent& event) { return event.kind == PathEvent::Kind::kGivenUp; }));
}

}  // namespace
}  // namespace aisle
