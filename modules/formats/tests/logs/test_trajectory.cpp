#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

TEST(Tum, WritesOnePoseALine) {
  const std::vector<double> stamps_s = {1.5};
  const std::vector<Pose2> T_map_vehicle = {{1, -2, kPi / 2}};
  EXPECT_EQ(tum_text(stamps_s, T_map_vehicle),
            "# stamp x y z qx qy qz qw\n"
            "1.500000 1.000000 -2.000000 0 0 0 0.707106781 0.707106781\n");
  EXPECT_THROW(tum_text(stamps_s, {}), std::invalid_argument);
}

RC_GTEST_PROP(Tum, ReadingItGivesTheSameTrajectory, (std::uint64_t seed)) {
  Random random(seed);
  Trajectory written;
  for (std::size_t i = 0; i < random.index(9); ++i) {
    written.stamps_s.push_back(random.uniform(0, 2e9));
    written.T_map_vehicle.push_back(
        {random.uniform(-99, 99), random.uniform(-99, 99), random.uniform(-kPi, kPi)});
  }
  const auto read = parse_tum(tum_text(written.stamps_s, written.T_map_vehicle), "written");
  RC_ASSERT(read.ok());
  RC_ASSERT(read->stamps_s.size() == written.stamps_s.size());
  for (std::size_t i = 0; i < written.stamps_s.size(); ++i) {
    RC_ASSERT(std::abs(read->stamps_s[i] - written.stamps_s[i]) < 1e-6);
    RC_ASSERT(testing::Matches(PoseNear(written.T_map_vehicle[i], 1e-6, 1e-8))(read->T_map_vehicle[i]));
  }
}

TEST(Tum, MalformedLinesAreProblems) {
  const auto problem = [](const std::string& line) {
    return to_string(parse_tum(line, "path.tum").problems());
  };
  EXPECT_THAT(problem("# one\n1 2 3\n"), HasSubstr("path.tum:2: the line ends after 3 fields"));
  EXPECT_THAT(problem("1 2 3 0 0 0 0 0.5\n"), HasSubstr("the quaternion's length is 0.5"));
  EXPECT_THAT(problem("1 2 3 0 0 0 0 1 9\n"), HasSubstr("more fields"));
}

}  // namespace
}  // namespace aisle
