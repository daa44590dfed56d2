#include <gmock/gmock.h>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/recorded_vehicle.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kCycles = 30;
constexpr ImageCoding kRaw{ImageCoding::Kind::kRaw};
constexpr ImageCoding kPng{ImageCoding::Kind::kPng};

/// Bit for bit.
void expect_same(const OdometryReading& a, const OdometryReading& b) {
  ASSERT_EQ(a.index(), b.index());
  if (const auto* motion = std::get_if<FrontSteeredMotion>(&a)) {
    EXPECT_EQ(motion->distance_m, std::get<FrontSteeredMotion>(b).distance_m);
    EXPECT_EQ(motion->steering_rad, std::get<FrontSteeredMotion>(b).steering_rad);
  } else {
    EXPECT_EQ(std::get<WheelSteps>(a).left, std::get<WheelSteps>(b).left);
    EXPECT_EQ(std::get<WheelSteps>(a).right, std::get<WheelSteps>(b).right);
  }
}

void expect_same(const Observation& a, const Observation& b) {
  EXPECT_EQ(a.stamp_s, b.stamp_s);
  expect_same(a.odometry, b.odometry);
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    EXPECT_EQ(a.images[i].camera, b.images[i].camera);
    EXPECT_EQ(a.images[i].stamp_s, b.images[i].stamp_s);
    EXPECT_TRUE(*a.images[i].pixels == *b.images[i].pixels) << "image " << i << " at " << a.stamp_s;
  }
  ASSERT_EQ(a.scan.has_value(), b.scan.has_value());
  if (a.scan) {
    EXPECT_EQ(a.scan->stamp_s, b.scan->stamp_s);
    EXPECT_EQ(a.scan->ranges_m, b.scan->ranges_m);
  }
  EXPECT_EQ(a.operator_input.requested, b.operator_input.requested);
  EXPECT_EQ(a.operator_input.marks, b.operator_input.marks);
  EXPECT_EQ(a.operator_input.goal_changes, b.operator_input.goal_changes);
  EXPECT_EQ(a.operator_input.quit, b.operator_input.quit);
  EXPECT_EQ(a.operator_input.gives_up, b.operator_input.gives_up);
  EXPECT_EQ(a.bumper_pressed, b.bumper_pressed);
}

class SessionRecordTest : public testing::TestWithParam<ImageCoding> {
 protected:
  SessionPlace place;
};

TEST_P(SessionRecordTest, WhatItGivesBackIsWhatAReplaySees) {
  const std::vector<Observation> kept = record_sample(place / "drive", kCycles, GetParam());
  auto cycles = SessionCycles::open(place / "drive");
  ASSERT_TRUE(cycles.ok()) << to_string(cycles.problems());
  for (int i = 0; i < kCycles; ++i) {
    const auto cycle = cycles->next();
    ASSERT_TRUE(cycle.ok()) << to_string(cycle.problems());
    ASSERT_TRUE(cycle->has_value()) << i;
    expect_same((*cycle)->observation, kept[static_cast<std::size_t>(i)]);
    EXPECT_EQ((*cycle)->decision, sample_decision(i));
  }
  const auto end = cycles->next();
  ASSERT_TRUE(end.ok());
  EXPECT_FALSE(end->has_value());
}

INSTANTIATE_TEST_SUITE_P(ImageCodings, SessionRecordTest,
                         testing::Values(kRaw, ImageCoding{}, ImageCoding{ImageCoding::Kind::kJpeg, 50},
                                         kPng),
                         [](const auto& coding) { return "Coding" + std::to_string(coding.index); });

TEST(SessionRecord, LosslessCodingsGiveBackWhatWasSensed) {
  const SessionPlace place;
  for (const ImageCoding& coding : {kRaw, kPng}) {
    const auto kept = record_sample(place / std::to_string(static_cast<int>(coding.kind)), 10, coding);
    for (int i = 0; i < 10; ++i) {
      Observation sensed = sample_observation(i);
      const Observation& given_back = kept[static_cast<std::size_t>(i)];
      EXPECT_NEAR(sensed.stamp_s, given_back.stamp_s, 0.5e-9);
      sensed.stamp_s = given_back.stamp_s;
      for (std::size_t p = 0; p < sensed.images.size(); ++p) {
        EXPECT_NEAR(sensed.images[p].stamp_s, given_back.images[p].stamp_s, 0.5e-9);
        sensed.images[p].stamp_s = given_back.images[p].stamp_s;
      }
      if (sensed.scan) sensed.scan->stamp_s = given_back.scan->stamp_s;
      expect_same(sensed, given_back);
    }
  }
}

TEST(SessionRecord, TheSameMessagesGiveTheSameBytes) {
  const SessionPlace place;
  fs::create_directories(place / "a");
  fs::create_directories(place / "b");
  record_sample(place / "a/drive", kCycles);
  record_sample(place / "b/drive", kCycles);
  for (const char* name : {"metadata.yaml", "drive_0.db3"}) {
    EXPECT_TRUE(*read_whole_file(place / "a/drive" / name) == *read_whole_file(place / "b/drive" / name))
        << name;
  }
}

TEST(SessionRecord, AClosedSessionIsTwoFiles) {
  const SessionPlace place;
  record_sample(place / "drive", 3);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(place / "drive")) names.push_back(entry.path().filename());
  EXPECT_THAT(names, testing::UnorderedElementsAre("metadata.yaml", "drive_0.db3"));
}

TEST(SessionRecord, GoalsAreKeptForViewers) {
  const SessionPlace place;
  const std::string goals = R"({"goals":[{"place":"desk"}],"reached":0})";
  auto record = SessionRecord::create(place / "drive", false, sample_vehicle(), sample_origin());
  EXPECT_THROW((void)record->keep_goals(goals), std::logic_error);
  (void)record->keep(sample_observation(0));
  EXPECT_THAT(record->keep_goals(goals), IsEmpty());
  (void)record->keep(sample_decision(0));
  (void)record->close();
  const auto reader = SessionReader::open(place / "drive");
  const auto kept = reader->first_of("/goals");
  EXPECT_EQ(kept->value(), cdr_bytes(ros::String{goals}));
  auto cycles = SessionCycles::open(place / "drive");
  const auto cycle = cycles->next();
  EXPECT_EQ((*cycle)->decision, sample_decision(0)) << "they are no part of the decision";
}

TEST(SessionRecord, KnowsItsOrigin) {
  const SessionPlace place;
  record_sample(place / "drive", 3);
  const auto cycles = SessionCycles::open(place / "drive");
  ASSERT_TRUE(cycles.ok()) << to_string(cycles.problems());
  EXPECT_EQ(cycles->origin(), sample_origin());
  EXPECT_EQ(cycles->vehicle().name, "sample");
  ASSERT_EQ(cycles->vehicle().cameras.size(), 2U);
  EXPECT_EQ(cycles->vehicle().cameras[1].mount.pan_rad, sample_vehicle().cameras[1].mount.pan_rad);
  EXPECT_EQ(cycles->vehicle().scanner->T_vehicle_laser.x, 0.5);
}

}  // namespace
}  // namespace aisle
