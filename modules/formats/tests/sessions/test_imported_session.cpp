#include "aisle/formats/sessions/imported_session.hpp"

#include <gmock/gmock.h>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "image_sequences/recordings.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Whether the images have odometry, and what is known of the sensors.
struct Imported {
  bool has_odometry = false;
  KnownSensors known = {};
};

constexpr KnownSensors kAllKnown = {.lens = true, .mount = true, .scanner_mount = true};

/// Images along a slalom, 0.2 s apart.
std::vector<TimedImage> slalom(bool has_odometry) {
  std::vector<TimedImage> images;
  Pose2 T_odom_vehicle{7, -3, 1};
  for (int i = 0; i < 20; ++i) {
    TimedImage& image = images.emplace_back();
    image.stamp_s = 1e9 + 0.2 * i;
    image.bytes = sample_jpeg(i, 64, 48);
    if (has_odometry) image.T_odom_vehicle = T_odom_vehicle;
    T_odom_vehicle = T_odom_vehicle * end_pose({0.1, 0.3 * std::sin(i)});
  }
  return images;
}

class ImportedSessionTest : public testing::Test {
 protected:
  ImportedSession create(const Imported& imported, const VehicleDescription& vehicle = sample_vehicle()) {
    auto session =
        ImportedSession::create(directory, false, vehicle, "front", imported.known, imported.has_odometry);
    EXPECT_TRUE(session.ok()) << to_string(session.problems());
    return std::move(session).value();
  }

  void import_all(const std::vector<TimedImage>& images, const Imported& imported,
                  const VehicleDescription& vehicle = sample_vehicle()) {
    ImportedSession session = create(imported, vehicle);
    for (const TimedImage& image : images) ASSERT_THAT(session.take(image), IsEmpty());
    ASSERT_THAT(session.finish(), IsEmpty());
  }

  std::vector<SessionCycle> cycles() {
    std::vector<SessionCycle> all;
    auto session = SessionCycles::open(directory);
    EXPECT_TRUE(session.ok()) << to_string(session.problems());
    while (true) {
      auto cycle = session->next();
      EXPECT_TRUE(cycle.ok()) << to_string(cycle.problems());
      if (!cycle.ok() || !cycle->has_value()) return all;
      all.push_back(std::move(**cycle));
    }
  }

  /// The messages of a topic.
  std::vector<std::string> messages_on(const std::string& topic) {
    std::vector<std::string> found;
    auto reader = SessionReader::open(directory);
    while (true) {
      const auto message = reader->next();
      if (!message.ok() || !message->has_value()) return found;
      if ((*message)->topic.name == topic) found.emplace_back((*message)->cdr);
    }
  }

  SessionPlace place;
  fs::path directory = place / "drive";
};

TEST_F(ImportedSessionTest, KeepsEveryByteOfItsImages) {
  const auto images = slalom(false);
  import_all(images, {});
  const auto messages = messages_on("/camera/front/image_raw/compressed");
  ASSERT_THAT(messages, SizeIs(images.size()));
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto message = parse_cdr<ros::CompressedImage>(messages[i]);
    EXPECT_EQ(message->format, "jpeg");
    EXPECT_EQ(std::string(message->data.begin(), message->data.end()), images[i].bytes);
  }
  EXPECT_THAT(cycles(), SizeIs(images.size()));
  EXPECT_FALSE(cycles().front().decision);
}

TEST_F(ImportedSessionTest, InventsNothing) {
  import_all(slalom(false), {});
  for (const char* topic : {"/wheels", "/odom", "/tf", "/tf_static", "/camera/front/camera_info", "/bumper",
                            "/controls", "/truth/pose"})
    EXPECT_THAT(messages_on(topic), IsEmpty()) << topic;
  const auto session = SessionCycles::open(directory);
  EXPECT_FALSE(session->origin().has_odometry);
  EXPECT_FALSE(session->origin().has_calibration);
  EXPECT_FALSE(session->origin().simulated);
}

TEST_F(ImportedSessionTest, ALensWithoutItsPlaceIsNoCalibration) {
  VehicleDescription vehicle = sample_vehicle();
  vehicle.cameras[0].intrinsics = {.k1 = 0.1, .model = LensModel::kEquidistant, .k4 = -0.01};
  import_all(slalom(true), {true, {.lens = true}}, vehicle);
  const auto session = SessionCycles::open(directory);
  EXPECT_FALSE(session->origin().has_calibration);
  EXPECT_EQ(session->vehicle().cameras[0].intrinsics, vehicle.cameras[0].intrinsics);
  EXPECT_THAT(messages_on("/tf_static"), IsEmpty());
  const auto messages = messages_on("/camera/front/camera_info");
  ASSERT_THAT(messages, SizeIs(20));
  const auto info = parse_cdr<ros::CameraInfo>(messages[0]);
  EXPECT_EQ(info->distortion_model, "equidistant");
  EXPECT_EQ(info->d, (std::vector<double>{0.1, 0, 0, -0.01}));
}

TEST_F(ImportedSessionTest, ControlsStayWhatTheyAre) {
  auto images = slalom(false);
  images[0].controls = RecordedControls{-1, 0.7};
  import_all(images, {});
  const auto messages = messages_on("/controls");
  ASSERT_THAT(messages, SizeIs(1));
  EXPECT_EQ(parse_cdr<ros::JointState>(messages[0])->position, (std::vector<double>{-1, 0.7}));
}

TEST_F(ImportedSessionTest, WheelsLeadAlongTheRecordedPoses) {
  VehicleDescription differential = sample_vehicle();
  differential.is_differential = true;
  for (const auto& [vehicle, exact_m] : {std::pair(sample_vehicle(), 1e-9), std::pair(differential, 0.003)}) {
    fs::remove_all(directory);
    const auto images = slalom(true);
    import_all(images, {true, kAllKnown}, vehicle);
    Pose2 T_odom_vehicle = *images[0].T_odom_vehicle;
    const auto all = cycles();
    ASSERT_THAT(all, SizeIs(images.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
      T_odom_vehicle = T_odom_vehicle * odometry_step(vehicle, all[i].observation.odometry);
      EXPECT_THAT(T_odom_vehicle, PoseNear(*images[i].T_odom_vehicle, exact_m, 20 * exact_m)) << i;
    }
    EXPECT_THAT(messages_on("/camera/front/camera_info"), SizeIs(images.size()));
  }
}

TEST_F(ImportedSessionTest, ScansAndImagesAreCyclesOfTheirOwn) {
  VehicleDescription vehicle = sample_vehicle();
  ImportedSession session = create({true, {.scanner_mount = true}}, vehicle);
  TimedImage image{.stamp_s = 100, .bytes = sample_jpeg(1, 64, 48), .T_odom_vehicle = Pose2{}};
  TimedScan scan{.stamp_s = 100.5, .scan = {100.25, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, .reading_period_s = 0.0625};
  scan.T_odom_vehicle = Pose2{0.25, 0, 0};
  ASSERT_THAT(session.take(image), IsEmpty());
  ASSERT_THAT(session.take(scan), IsEmpty());
  ASSERT_THAT(session.finish(), IsEmpty());
  const auto all = cycles();
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_FALSE(all[0].observation.scan);
  ASSERT_TRUE(all[1].observation.scan);
  EXPECT_EQ(all[1].observation.stamp_s, 100.5);
  EXPECT_EQ(all[1].observation.scan->stamp_s, 100.25);
  EXPECT_EQ(all[1].observation.scan->ranges_m, scan.scan.ranges_m);
  EXPECT_NEAR(odometry_step(vehicle, all[1].observation.odometry).x, 0.25, 1e-9);
  EXPECT_EQ(parse_cdr<ros::LaserScan>(messages_on("/scan")[0])->time_increment, 0.0625F);
  const auto frames = messages_on("/tf_static");
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_THAT(parse_cdr<ros::TFMessage>(frames[0])->transforms, SizeIs(1));  // of the scanner alone
}

TEST_F(ImportedSessionTest, TellsHowFarWheelsCannotFollow) {
  ImportedSession session = create({true, {}});
  auto images = slalom(true);
  images.resize(2);
  images[1].T_odom_vehicle = *images[0].T_odom_vehicle * Pose2{0, 0.4, 0};
  for (const TimedImage& image : images) ASSERT_THAT(session.take(image), IsEmpty());
  EXPECT_NEAR(session.sideways_m(), 0.4, 1e-9);
}

TEST_F(ImportedSessionTest, IsNotThereBeforeItIsWhole) {
  {
    ImportedSession session = create({});
    for (const TimedImage& image : slalom(false)) ASSERT_THAT(session.take(image), IsEmpty());
    EXPECT_FALSE(SessionReader::open(directory).ok());
  }
  EXPECT_FALSE(fs::exists(directory));
  EXPECT_TRUE(fs::is_empty(directory.parent_path()));
}

TEST_F(ImportedSessionTest, TakesOverWhatAKilledImportLeft) {
  write_file(place / ".drive.importing/drive/drive_0.db3", "half");
  write_file(place / ".drive.importing/drive/metadata.yaml", "");
  fs::create_directory(directory);
  import_all(slalom(false), {});
  EXPECT_THAT(cycles(), SizeIs(20));
  EXPECT_FALSE(fs::exists(place / ".drive.importing"));
}

TEST_F(ImportedSessionTest, ReplacesASessionOnlyIfForced) {
  import_all(slalom(false), {});
  const auto refused = ImportedSession::create(directory, false, sample_vehicle(), "front", {}, false);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(to_string(refused.problems()), HasSubstr("--force"));
  EXPECT_THAT(cycles(), SizeIs(20));
}

}  // namespace
}  // namespace aisle
