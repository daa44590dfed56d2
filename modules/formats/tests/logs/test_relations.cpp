#include <gmock/gmock.h>

#include "aisle/formats/logs/relations.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Scans with jumping stamps 50, 51, 20, 21.
LaserLog jumbled_log() {
  LaserLog log;
  for (const double stamp_s : {50.0, 51.0, 20.0, 21.0}) {
    LaserScan scan;
    scan.stamp_s = stamp_s;
    log.scans.push_back(scan);
  }
  return log;
}

std::string relation_problems(const std::string& text) {
  const auto relations = parse_relations(text, "truth", jumbled_log());
  return relations.ok() ? "" : to_string(relations.problems());
}

TEST(Relations, ByStampFindTheirScansWhateverTheOrderOfRecording) {
  const auto relations = parse_relations("# truth\n51.0004 20 1 2 9 0.1 0.2 0.5\n", "truth", jumbled_log());
  ASSERT_TRUE(relations.ok());
  ASSERT_THAT(*relations, SizeIs(1));
  EXPECT_EQ((*relations)[0].scan_1, 1U);
  EXPECT_EQ((*relations)[0].scan_2, 2U);
  EXPECT_THAT((*relations)[0].T_1_2, PoseNear(Pose2{1, 2, 0.5}, 0, 0));
}

TEST(Relations, ByNumberCountFromZero) {
  const auto relations = parse_relations("0 3 1 2 0.5\r\n\n", "truth", jumbled_log());
  ASSERT_TRUE(relations.ok());
  EXPECT_EQ((*relations)[0].scan_1, 0U);
  EXPECT_EQ((*relations)[0].scan_2, 3U);
  EXPECT_THAT((*relations)[0].T_1_2, PoseNear(Pose2{1, 2, 0.5}, 0, 0));
}

TEST(Relations, ScansThatTheLogDoesNotHaveAreProblemsOfTheirLines) {
  EXPECT_EQ(relation_problems("50 51 0 0 0 0 0 0\n50 51.002 0 0 0 0 0 0\n"),
            "truth:2: the log has no scan with the stamp 51.002000");
  EXPECT_EQ(relation_problems("0 4 1 2 0\n"),
            "truth:1: the log has no scan 4; its scans are numbered 0 to 3");
  EXPECT_THAT(relation_problems("-1 0 1 2 0\n"), HasSubstr("no scan -1"));
  EXPECT_THAT(relation_problems("0.5 1 1 2 0\n"), HasSubstr("no scan 0.5"));
}

TEST(Relations, MalformedLinesAreProblems) {
  EXPECT_THAT(relation_problems(""), HasSubstr("truth: has no relations"));
  EXPECT_THAT(relation_problems("0 1 2\n"), HasSubstr("truth:1: has 3 fields"));
  EXPECT_THAT(relation_problems("0 1 nan 0 0\n"), HasSubstr("'nan' is not a usable number"));
  EXPECT_THAT(relation_problems("0 1 x 0 0\n"), HasSubstr("'x' is not a number"));
}

}  // namespace
}  // namespace aisle
