#include <gmock/gmock.h>

#include <algorithm>

#include "bags/bag_samples.hpp"
#include "image_sequences/recordings.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr const char* kRawTopic = "/front/image_raw";
constexpr const char* kPackedTopic = "/front/image_raw/compressed";
/// Of a frame whose z axis looks along the vehicle's x axis, its x axis to the right.
constexpr ros::Quaternion kOptical = {-0.5, 0.5, -0.5, 0.5};

ros::Header camera_header(double stamp_s) {
  return {ros::time_of(ros::stamp_ns(stamp_s)), "front_optical"};
}

WrittenMessage packed_image(int index, double stamp_s, Written as = Written::kCdr) {
  const std::string bytes = sample_jpeg(index);
  return written(kPackedTopic, stamp_s + 0.02,
                 ros::CompressedImage{camera_header(stamp_s), "whatever", {bytes.begin(), bytes.end()}}, as);
}

WrittenMessage raw_image(double stamp_s, std::uint8_t grey = 90, Written as = Written::kCdr) {
  return written(
      kRawTopic, stamp_s + 0.02,
      ros::Image{camera_header(stamp_s), 24, 32, "mono8", 0, 32, std::vector<std::uint8_t>(24 * 32, grey)},
      as);
}

ros::CameraInfo calibration(const std::string& model = "plumb_bob",
                            std::vector<double> d = {-0.1, 0.02, 0.001, -0.002, 0.003}) {
  ros::CameraInfo info;
  info.header = camera_header(100);
  info.width = 32;
  info.height = 24;
  info.distortion_model = model;
  info.d = std::move(d);
  info.k = {30, 0, 15.5, 0, 31, 11.5, 0, 0, 1};
  info.p = {20, 0, 16.5, 0, 0, 21, 12.5, 0, 0, 0, 1, 0};
  return info;
}

/// Odometry and mounts of a vehicle that drives at 0.5 m/s, without its scans.
std::vector<WrittenMessage> drive(Written as = Written::kCdr) {
  auto messages = Recorded{.has_mount = false}.messages(as);
  std::erase_if(messages, [](const WrittenMessage& message) { return message.topic == "/scan"; });
  messages.push_back(
      written("/tf_static", 100,
              ros::TFMessage{{transform("base_link", "front_optical", {0.4, 0.1, 0.9}, kOptical)}}, as));
  return messages;
}

/// Ten images, a tenth of a second apart.
std::vector<WrittenMessage> images(Written as = Written::kCdr) {
  std::vector<WrittenMessage> all;
  for (int i = 0; i < 10; ++i) all.push_back(packed_image(i, 100 + 0.1 * i, as));
  return all;
}

std::vector<WrittenMessage> with(std::vector<WrittenMessage> messages,
                                 const std::vector<WrittenMessage>& more) {
  messages.insert(messages.end(), more.begin(), more.end());
  return messages;
}

struct ReadImages {
  std::string problems, warnings;
  RecordedCamera camera;
  std::size_t left_out = 0;
  std::vector<TimedImage> images;
};

ReadImages read_images(const std::filesystem::path& bag, const ImageSequenceOptions& options = {}) {
  const auto sequence = open_image_sequence(bag.string(), options);
  if (!sequence) return {.problems = to_string(sequence.problems())};
  ReadImages read{.camera = (*sequence)->camera()};
  read.images = read_all(**sequence);
  read.left_out = (*sequence)->left_out();
  read.warnings = to_string((*sequence)->warnings());
  return read;
}

ReadImages read_images(const std::vector<WrittenMessage>& messages,
                       const ImageSequenceOptions& options = {}) {
  const SessionPlace place;
  write_file(place / "bag.mcap", mcap_bytes(messages));
  return read_images(place / "bag.mcap", options);
}

TEST(BagImages, AreTheSameFromEveryStore) {
  const SessionPlace place;
  const auto messages = with(images(), drive());
  write_file(place / "a.mcap", mcap_bytes(messages, {"zstd"}));
  write_db3(place / "b.db3", messages);
  write_file(place / "c.bag", ros1_bag_bytes(with(images(Written::kRos1), drive(Written::kRos1)), {"lz4"}));
  for (const char* name : {"a.mcap", "b.db3", "c.bag"}) {
    const ReadImages read = read_images(place / name);
    ASSERT_THAT(read.images, SizeIs(10)) << name << read.problems;
    for (int i = 0; i < 10; ++i) {
      const TimedImage& image = read.images[static_cast<std::size_t>(i)];
      EXPECT_NEAR(image.stamp_s, 100 + 0.1 * i, 1e-6) << name;
      EXPECT_TRUE(image.bytes == sample_jpeg(i)) << name;
      ASSERT_TRUE(image.T_odom_vehicle) << name;
      EXPECT_THAT(*image.T_odom_vehicle, PoseNear(Pose2{0.05 * i, 0, 0}, 1e-6, 1e-9)) << name;
    }
    ASSERT_TRUE(read.camera.mount) << name;
    EXPECT_NEAR(read.camera.mount->p_vehicle_camera.z(), 0.9, 1e-9) << name;
    EXPECT_FALSE(read.camera.lens) << name;
  }
}

TEST(BagImages, PixelsBecomePng) {
  const ReadImages read = read_images({raw_image(100, 10), raw_image(100.1, 20)});
  ASSERT_THAT(read.images, SizeIs(2)) << read.problems;
  for (const TimedImage& image : read.images) EXPECT_TRUE(image.bytes.starts_with("\x89PNG"));
  EXPECT_EQ(parse_image(read.images[1].bytes, "png")->bytes, std::vector<std::uint8_t>(24 * 32, 20));
  EXPECT_THAT(read.warnings, HasSubstr("has no odometry"));
}

TEST(BagImages, OfSeveralTopicsTheUserNamesOne) {
  const auto messages = with(images(), {raw_image(100.5)});
  EXPECT_THAT(read_images(messages).problems,
              HasSubstr("has images on 2 topics, /front/image_raw/compressed (10), /front/image_raw (1): "
                        "--camera TOPIC names the one to be read"));
  EXPECT_THAT(read_images(messages, {.topic = "front/image_raw"}).images, SizeIs(1));
  EXPECT_THAT(read_images(with(messages, drive()), {.topic = "/odom"}).problems,
              HasSubstr("has no images but nav_msgs/msg/Odometry"));
  EXPECT_THAT(read_images(messages, {.topic = "/rear"}).problems, HasSubstr("is no such topic of the bag"));
  EXPECT_THAT(read_images(drive()).problems, AllOf(HasSubstr("has no images"), HasSubstr("/odom")));
  EXPECT_THAT(read_images(images(), {.rate_hz = 5}).problems, HasSubstr("--image-rate"));
}

TEST(BagImages, TheLensIsThatOfTheCalibrationBesideThem) {
  const auto lens_of = [](const ros::CameraInfo& info, const std::string& topic = "/front/camera_info") {
    return read_images(with(images(), {written(topic, 100, info), raw_image(100)}), {.topic = kPackedTopic})
        .camera.lens;
  };
  const auto plumb_bob = lens_of(calibration());
  ASSERT_TRUE(plumb_bob);
  EXPECT_EQ(*plumb_bob, (CameraIntrinsics{30, 31, 15.5, 11.5, -0.1, 0.02, 0.001, -0.002, 0.003}));
  const auto fisheye = lens_of(calibration("equidistant", {0.1, 0.2, 0.3, 0.4}));
  ASSERT_TRUE(fisheye);
  EXPECT_EQ(fisheye->model, LensModel::kEquidistant);
  EXPECT_EQ(fisheye->k4, 0.4);
  const auto rational = lens_of(calibration("rational_polynomial", {90, 2, 0, 0, 3, 89, 5, 6}));
  ASSERT_TRUE(rational);
  EXPECT_EQ(rational->model, LensModel::kRationalPolynomial);
  EXPECT_FALSE(lens_of(calibration(), "/rear/camera_info"));
  EXPECT_TRUE(lens_of(calibration(), "/camera_info"));
}

TEST(BagImages, ACalibrationThatDoesNotFitIsLeftAside) {
  const auto warnings_with = [](const ros::CameraInfo& info) {
    const ReadImages read = read_images(with(images(), {written("/front/camera_info", 100, info)}));
    EXPECT_FALSE(read.camera.lens) << read.warnings;
    return read.warnings;
  };
  ros::CameraInfo zeros = calibration();
  zeros.k = {};
  EXPECT_THAT(warnings_with(zeros), Not(HasSubstr("the calibration")));
  ros::CameraInfo larger = calibration();
  larger.width = 640;
  EXPECT_THAT(warnings_with(larger), HasSubstr("it is for other images, of 640 x 24 pixels"));
  ros::CameraInfo binned = calibration();
  binned.binning_x = 2;
  EXPECT_THAT(warnings_with(binned), HasSubstr("for other images"));
  EXPECT_THAT(warnings_with(calibration("ds", {})), HasSubstr("its lens model 'ds' is not read"));
  EXPECT_THAT(warnings_with(calibration("equidistant", {1})), HasSubstr("has 1 coefficients"));
  EXPECT_THAT(warnings_with(calibration("plumb_bob", {1e9})), HasSubstr("k1 1e+09 is outside"));
  ros::CameraInfo no_number = calibration();
  no_number.k[0] = std::nan("");
  EXPECT_THAT(warnings_with(no_number), HasSubstr("fx_px nan is outside"));
}

TEST(BagImages, RectifiedImagesHaveTheLensOfTheirProjection) {
  auto messages = images();
  for (WrittenMessage& message : messages) message.topic = "/front/image_rect/compressed";
  const ReadImages read =
      read_images(with(messages, {written("/front/camera_info", 100, calibration("ds", {1}))}));
  ASSERT_TRUE(read.camera.lens) << read.warnings;
  EXPECT_EQ(*read.camera.lens, (CameraIntrinsics{20, 21, 16.5, 12.5}));
}

TEST(BagImages, TheMountIsThatOfTheTransforms) {
  const auto camera_with = [](const std::vector<ros::TransformStamped>& transforms) {
    return read_images(with(images(), {written("/tf_static", 100, ros::TFMessage{transforms})}));
  };
  const double tilt_rad = 15 * kDegree;
  const ros::Quaternion tilted = {0, std::sin(tilt_rad / 2), 0, std::cos(tilt_rad / 2)};
  const auto mount = camera_with({transform("base_footprint", "base_link", {0, 0, 0.1}),
                                  transform("base_link", "mast", {0.4, -0.1, 0.9}, tilted),
                                  transform("mast", "front_optical", {}, kOptical)})
                         .camera.mount;
  ASSERT_TRUE(mount);
  EXPECT_TRUE(mount->p_vehicle_camera.isApprox(Vec3(0.4, -0.1, 1.0), 1e-9));
  EXPECT_NEAR(mount->tilt_rad, tilt_rad, 1e-9);
  EXPECT_NEAR(mount->pan_rad, 0, 1e-9);
  EXPECT_NEAR(mount->roll_rad, 0, 1e-9);

  const ReadImages unturned = camera_with({transform("base_link", "front_optical", {0.4, 0, 0.9}, tilted)});
  EXPECT_THAT(unturned.warnings, HasSubstr("the z axis of 'front_optical' looks up"));
  ASSERT_TRUE(unturned.camera.mount);
  EXPECT_NEAR(unturned.camera.mount->tilt_rad, tilt_rad, 1e-9);

  const ReadImages below = camera_with({transform("base_link", "front_optical", {0, 0, -1}, kOptical)});
  EXPECT_FALSE(below.camera.mount);
  EXPECT_THAT(below.warnings, HasSubstr("z_m -1 is outside 0.01 .. 10"));
  EXPECT_THAT(camera_with({}).warnings,
              HasSubstr("no fixed transforms lead from 'base_link' to 'front_optical'"));
}

TEST(BagImages, WhatCannotBeUsedIsLeftOutAndSaid) {
  auto messages = images();
  messages[2].bytes.resize(10);                             // no header
  messages[4].bytes.resize(messages[4].bytes.size() - 30);  // the message is cut off
  const ros::CompressedImage text{camera_header(100.93), "jpeg", {'n', 'o', ' ', 'j', 'p', 'e', 'g'}};
  messages.push_back(written(kPackedTopic, 100.97, text));
  const std::string other_size = sample_jpeg(1, 64, 48);
  messages.push_back(
      written(kPackedTopic, 101,
              ros::CompressedImage{camera_header(100.98), "", {other_size.begin(), other_size.end()}}));
  messages.push_back(packed_image(1, 100.98));  // the stamp of the one before
  const ReadImages read = read_images(messages);
  EXPECT_THAT(read.images, SizeIs(8)) << read.problems;
  EXPECT_EQ(read.left_out, 4U);
  EXPECT_THAT(read.warnings,
              AllOf(HasSubstr("1 of 13 messages are left out, for they cannot be read"),
                    HasSubstr("bag.mcap:5: /front/image_raw/compressed: is cut off; 2 damaged images"),
                    HasSubstr("has 64 x 48 pixels, the first image 32 x 24; 2 images are left out")));
}

TEST(BagImages, AnEncodingThatIsNotReadIsNamed) {
  ros::Image depth{camera_header(100), 24, 32, "16UC1", 0, 64, std::vector<std::uint8_t>(64 * 24)};
  EXPECT_THAT(read_images({written(kRawTopic, 100, depth)}).problems,
              AllOf(HasSubstr("has images in '16UC1'; mono8"), HasSubstr("none of the images")));
}

TEST(BagImages, TheBagsScansAreOnTheSameClock) {
  auto messages = Recorded{}.messages();
  for (int i = 0; i < 10; ++i) {
    messages.push_back(packed_image(i, 400 + 0.1 * i));  // by another clock
    messages.back().log_stamp = ros::stamp_ns(100.02 + 0.1 * i);
  }
  std::stable_sort(messages.begin(), messages.end(),
                   [](const auto& a, const auto& b) { return a.log_stamp < b.log_stamp; });
  const SessionPlace place;
  write_file(place / "bag.mcap", mcap_bytes(messages));
  const auto sequence = open_image_sequence((place / "bag.mcap").string());
  ASSERT_TRUE(sequence.ok()) << to_string(sequence.problems());
  const auto scans = (*sequence)->take_scans();
  ASSERT_TRUE(scans);
  EXPECT_FALSE((*sequence)->take_scans());
  ASSERT_THAT(scans->log.scans, SizeIs(10));
  EXPECT_TRUE(scans->has_mounting);
  const auto images = read_all(**sequence);
  ASSERT_THAT(images, SizeIs(10));
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(images[i].stamp_s, scans->log.scans[i].time_s, 1e-6);
    EXPECT_NEAR(images[i].T_odom_vehicle->x, 0.05 * static_cast<double>(i), 1e-6);
  }
  EXPECT_THAT(to_string((*sequence)->warnings()), HasSubstr("two clocks"));
}

TEST(BagImages, BesideTheOdometryTheVehicleStands) {
  auto messages = with(drive(), images());
  messages.push_back(packed_image(11, 105));
  const ReadImages read = read_images(messages);
  ASSERT_THAT(read.images, SizeIs(11));
  EXPECT_THAT(read.warnings, HasSubstr("1 of 11 images were taken before the odometry begins"));
  EXPECT_FALSE(read_images(messages, {.reading = {.odometry = "none"}}).images[3].T_odom_vehicle);
}

}  // namespace
}  // namespace aisle
