#include "sessions/ros_image.hpp"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "session_samples.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kWidth_px = 8, kHeight_px = 6;

/// A message of one colour. @param pixel  its bytes, repeated  @param padding_bytes  after each row
ros::Image one_colour(const std::string& encoding, const std::vector<std::uint8_t>& pixel,
                      std::uint32_t padding_bytes = 0) {
  ros::Image message;
  message.width = kWidth_px;
  message.height = kHeight_px;
  message.encoding = encoding;
  message.step = kWidth_px * static_cast<std::uint32_t>(pixel.size()) + padding_bytes;
  for (std::uint32_t v = 0; v < kHeight_px; ++v) {
    for (std::uint32_t u = 0; u < kWidth_px; ++u)
      message.data.insert(message.data.end(), pixel.begin(), pixel.end());
    message.data.insert(message.data.end(), padding_bytes, 77);
  }
  return message;
}

/// The bytes of the first pixel, which all others are like; empty if they are not.
std::vector<int> colour_of(const ros::Image& message) {
  const auto image = image_of(message, {"bag"});
  if (!image) return {};
  const auto channels = static_cast<std::size_t>(image->channels);
  for (std::size_t i = 0; i < image->bytes.size(); ++i) {
    if (image->bytes[i] != image->bytes[i % channels]) return {};
  }
  return {image->bytes.begin(), image->bytes.begin() + image->channels};
}

std::string refusal(const ros::Image& message) {
  const auto image = image_of(message, {"bag", 7, "/camera"});
  return image ? "" : to_string(image.problems());
}

TEST(RosImage, EveryEncodingGivesGreyOrRedGreenBlue) {
  const std::vector<int> grey = {90}, orange = {200, 100, 30};
  EXPECT_EQ(colour_of(one_colour("mono8", {90})), grey);
  EXPECT_EQ(colour_of(one_colour("8UC1", {90})), grey);
  EXPECT_EQ(colour_of(one_colour("rgb8", {200, 100, 30})), orange);
  EXPECT_EQ(colour_of(one_colour("bgr8", {30, 100, 200})), orange);
  EXPECT_EQ(colour_of(one_colour("8UC3", {30, 100, 200})), orange);
  EXPECT_EQ(colour_of(one_colour("rgba8", {200, 100, 30, 9})), orange);
  EXPECT_EQ(colour_of(one_colour("bgra8", {30, 100, 200, 9})), orange);
}

TEST(RosImage, TwoPixelsOfYuvShareTheirColour) {
  // Y, U, V of pure red by BT.601 in studio swing.
  const int y = 81, u = 90, v = 240;
  const auto yuv = [&](const std::string& encoding, std::vector<int> block) {
    ros::Image message = one_colour(encoding, {0, 0});
    for (std::size_t i = 0; i < message.data.size(); ++i)
      message.data[i] = static_cast<std::uint8_t>(block[i % 4]);
    return colour_of(message);
  };
  for (const auto& [encoding, block] : std::map<std::string, std::vector<int>>{{"yuyv", {y, u, y, v}},
                                                                               {"yuv422_yuy2", {y, u, y, v}},
                                                                               {"uyvy", {u, y, v, y}},
                                                                               {"yuv422", {u, y, v, y}}}) {
    const auto red = yuv(encoding, block);
    ASSERT_EQ(red.size(), 3U) << encoding;
    EXPECT_NEAR(red[0], 254, 2) << encoding;
    EXPECT_NEAR(red[1], 0, 2) << encoding;
    EXPECT_NEAR(red[2], 0, 2) << encoding;
  }
}

TEST(RosImage, BayerPatternsBeginAsTheirNamesSay) {
  const std::map<char, std::uint8_t> colour = {{'r', 200}, {'g', 100}, {'b', 30}};
  for (const std::string pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    ros::Image message = one_colour("bayer_" + pattern + "8", {0});
    for (std::size_t i = 0; i < message.data.size(); ++i) {
      const std::size_t u = i % kWidth_px, v = i / kWidth_px;
      message.data[i] = colour.at(pattern[2 * (v % 2) + u % 2]);
    }
    EXPECT_EQ(colour_of(message), (std::vector<int>{200, 100, 30})) << pattern;
  }
}

TEST(RosImage, RowsAreAsFarApartAsStepSays) {
  EXPECT_EQ(colour_of(one_colour("mono8", {90}, 5)), std::vector<int>{90});
  EXPECT_EQ(colour_of(one_colour("bgr8", {30, 100, 200}, 8)), (std::vector<int>{200, 100, 30}));
}

TEST(RosImage, OtherEncodingsAreNamed) {
  for (const char* encoding : {"16UC1", "32FC1", "mono16", "rgb16", "bayer_rggb16", "nv12", ""})
    EXPECT_THAT(refusal(one_colour(encoding, {1, 2})),
                HasSubstr("bag:7: /camera: has images in '" + std::string(encoding) + "'; mono8, "));
}

TEST(RosImage, SizesThatDoNotFitTheBytesAreRefused) {
  const auto changed = [](auto change) {
    ros::Image message = one_colour("rgb8", {1, 2, 3});
    change(message);
    return refusal(message);
  };
  EXPECT_EQ(changed([](auto&) {}), "");
  for (const std::string& wrong :
       {changed([](ros::Image& m) { m.data.pop_back(); }), changed([](ros::Image& m) { m.step = 23; }),
        changed([](ros::Image& m) { m.step = 0; }), changed([](ros::Image& m) { m.width = 0; }),
        changed([](ros::Image& m) { m.height = 1'000'000'000; }),
        changed([](ros::Image& m) { m.width = 1'500'000'000, m.step = 204'032'704; }),
        changed([](ros::Image& m) { m.width = 16'384, m.height = 16'384, m.step = 4'000'000'000; })})
    EXPECT_THAT(wrong, HasSubstr("has an image of "));
  ros::Image odd = one_colour("yuyv", {1, 2});
  odd.width = 7;
  EXPECT_THAT(refusal(odd), HasSubstr("has an image of 7 x 6"));
}

}  // namespace
}  // namespace aisle
