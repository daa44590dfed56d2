#include "sessions/image_messages.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <utility>

#include "aisle/formats/images/image_file.hpp"
#include "calibration_lens.hpp"
#include "sessions/ros_image.hpp"

namespace aisle {
namespace {

constexpr std::string_view kBefore = "/camera/";
constexpr std::string_view kRaw = "/image_raw";
constexpr std::string_view kCompressed = "/image_raw/compressed";

std::string topic_of(const std::string& camera, std::string_view ending) {
  return fmt::format("{}{}{}", kBefore, camera, ending);
}

ros::Header header_of(const std::string& camera, double stamp_s) {
  return {ros::time_of(ros::stamp_ns(stamp_s)), camera_frame(camera)};
}

ros::Image raw(const Image& image) {
  return {.header = {},
          .height = static_cast<std::uint32_t>(image.height_px),
          .width = static_cast<std::uint32_t>(image.width_px),
          .encoding = image.channels == 1 ? "mono8" : "rgb8",
          .is_bigendian = 0,
          .step = static_cast<std::uint32_t>(image.row_bytes()),
          .data = image.bytes};
}

ros::CompressedImage compressed(const Image& image, const ImageCoding& coding) {
  const bool is_jpeg = coding.kind == ImageCoding::Kind::kJpeg;
  const std::string bytes = is_jpeg ? jpeg_bytes(image, coding.jpeg_quality) : png_bytes(image);
  return {.header = {}, .format = is_jpeg ? "jpeg" : "png", .data = {bytes.begin(), bytes.end()}};
}

CameraImage camera_image(const std::string& camera, const ros::Header& header, Image image) {
  return {.camera = camera,
          .stamp_s = ros::stamp_s(ros::stamp_ns(header.stamp)),
          .pixels = std::make_shared<const Image>(std::move(image))};
}

}  // namespace

std::string camera_frame(const std::string& camera) {
  return camera + "_optical";
}

RecordedMessage image_message(const CameraImage& camera_image, const ImageCoding& coding) {
  if (!camera_image.pixels || camera_image.pixels->bytes.empty())
    throw std::invalid_argument("the image of camera '" + camera_image.camera + "' is empty");
  const ros::Header header = header_of(camera_image.camera, camera_image.stamp_s);
  if (coding.kind == ImageCoding::Kind::kRaw) {
    ros::Image message = raw(*camera_image.pixels);
    message.header = header;
    return recorded(topic_of(camera_image.camera, kRaw), message);
  }
  ros::CompressedImage message = compressed(*camera_image.pixels, coding);
  message.header = header;
  return recorded(topic_of(camera_image.camera, kCompressed), message);
}

RecordedMessage image_file_message(const std::string& camera, double stamp_s, std::string_view bytes) {
  ros::CompressedImage message{.header = header_of(camera, stamp_s),
                               .format = bytes.starts_with("\xff\xd8") ? "jpeg" : "png",
                               .data = {bytes.begin(), bytes.end()}};
  return recorded(topic_of(camera, kCompressed), message);
}

RecordedMessage camera_info_message(const CameraDescription& camera, double stamp_s) {
  const CameraIntrinsics& lens = camera.intrinsics;
  const ros::CameraInfo info{.header = header_of(camera.name, stamp_s),
                             .height = static_cast<std::uint32_t>(camera.height_px),
                             .width = static_cast<std::uint32_t>(camera.width_px),
                             .distortion_model = name_of(lens.model),
                             .d = distortion_coefficients(lens),
                             .k = {lens.fx_px, 0, lens.cx_px, 0, lens.fy_px, lens.cy_px, 0, 0, 1},
                             .r = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                             .p = {lens.fx_px, 0, lens.cx_px, 0, 0, lens.fy_px, lens.cy_px, 0, 0, 0, 1, 0},
                             .binning_x = 0,
                             .binning_y = 0,
                             .roi = {}};
  return recorded(topic_of(camera.name, "/camera_info"), info);
}

std::optional<std::string> camera_of(const std::string& topic) {
  if (!topic.starts_with(kBefore)) return std::nullopt;
  for (const std::string_view ending : {kCompressed, kRaw}) {
    if (!topic.ends_with(ending)) continue;
    if (topic.size() <= kBefore.size() + ending.size()) return std::nullopt;
    return topic.substr(kBefore.size(), topic.size() - kBefore.size() - ending.size());
  }
  return std::nullopt;
}

Result<CameraImage> camera_image_of(const RecordedMessage& message, const std::string& camera,
                                    const std::string& file) {
  const Place place{file, 0, message.topic.name};
  if (message.topic.type == ros::Image::kType) {
    const auto raw = decoded<ros::Image>(message, file);
    if (!raw) return raw.problems();
    Result<Image> image = image_of(*raw, place);
    if (!image) return image.problems();
    return camera_image(camera, raw->header, std::move(*image));
  }
  const auto compressed = decoded<ros::CompressedImage>(message, file);
  if (!compressed) return compressed.problems();
  const std::string_view bytes(reinterpret_cast<const char*>(compressed->data.data()),
                               compressed->data.size());
  Result<Image> image = parse_image(bytes, to_string(Problem{place, "an image"}));
  if (!image) return image.problems();
  return camera_image(camera, compressed->header, std::move(*image));
}

}  // namespace aisle
