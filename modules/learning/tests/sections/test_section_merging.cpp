#include <gmock/gmock.h>

#include "aisle/learning/sections/section_learning.hpp"
#include "driven_sections.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

DrivenList drive(SectionList sections, std::optional<double> corridor_width_m = {}) {
  DrivenList driven;
  driven.sections = std::move(sections);
  driven.corridor_width_m = corridor_width_m;
  return driven;
}

TEST(SectionMerging, OneDriveStaysAsItIs) {
  const DrivenList one = drive({straight(5, 0.4), turn(-90), straight(3)}, 1.8);
  const MergedDrives merged = merge_drives(std::vector{one});
  EXPECT_EQ(merged.driven.sections, one.sections);
  EXPECT_EQ(merged.driven.corridor_width_m, 1.8);
  EXPECT_THAT(merged.taken, ElementsAre(0U));
}

TEST(SectionMerging, OfThreeDrivesTheMedianCounts) {
  const MergedDrives merged = merge_drives(std::vector{drive({straight(5.1, 0.40), turn(-90), straight(3)}),
                                                       drive({straight(5.0, 0.45), turn(-90), straight(3.1)}),
                                                       drive({straight(4.7, 0.41), turn(-85), straight(3)})});
  ASSERT_EQ(merged.driven.sections.size(), 3U);
  EXPECT_DOUBLE_EQ(merged.driven.sections[0].length_m, 5.0);
  EXPECT_DOUBLE_EQ(*merged.driven.sections[0].right_m, 0.41);
  EXPECT_NEAR(to_degrees(merged.driven.sections[1].turn_rad), -90, 1e-9);
  EXPECT_DOUBLE_EQ(merged.driven.sections[2].length_m, 3.0);
}

TEST(SectionMerging, WhatAnyDriveSawWasSeen) {
  DrivenList one = drive({straight(9)}), other = drive({straight(9)});
  one.unseen = {.from_m = 2, .length_m = 6};
  other.unseen = {.from_m = 4, .length_m = 1};
  EXPECT_EQ(merge_drives(std::vector{one, other}).driven.unseen.length_m, 1);
}

TEST(SectionMerging, OfTwoDrivesTheMeanCountsAndADistanceThatOnlyOneSawIsKept) {
  const MergedDrives merged = merge_drives(std::vector{drive({straight(5)}), drive({straight(5.2, 0.4)})});
  EXPECT_DOUBLE_EQ(merged.driven.sections[0].length_m, 5.1);
  EXPECT_EQ(merged.driven.sections[0].right_m, 0.4);
}

TEST(SectionMerging, ADriveElsewhereIsLeftOut) {
  const DrivenList path = drive({straight(5), turn(90), straight(3)});
  const DrivenList to_the_right = drive({straight(5), turn(-90), straight(3)});
  const DrivenList longer = drive({straight(9), turn(90), straight(3)});
  const DrivenList shorter_list = drive({straight(5)});
  const MergedDrives merged = merge_drives(std::vector{to_the_right, path, longer, path, shorter_list});
  EXPECT_EQ(merged.driven.sections, path.sections);
  EXPECT_THAT(merged.taken, ElementsAre(1U, 3U));
}

TEST(SectionMerging, InATieOfFormsTheEarlierDriveCounts) {
  const DrivenList path = drive({straight(5)}), other = drive({straight(9)});
  EXPECT_EQ(merge_drives(std::vector{path, other}).driven.sections, path.sections);
  EXPECT_EQ(merge_drives(std::vector{other, path}).driven.sections, other.sections);
}

}  // namespace
}  // namespace aisle
