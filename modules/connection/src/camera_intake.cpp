/// The part of a robot's intake that is about its cameras.

#include <filesystem>
#include <utility>

#include "aisle/formats/bags/bag_image.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "robot_intake.hpp"

namespace aisle {
namespace {

constexpr std::size_t kImagesWaiting = 8;  // a scan that ends a cycle may come after newer images

}  // namespace

std::string RobotIntake::camera_name(std::size_t which) const {
  return live_cameras_[which] ? live_cameras_[which]->name() : images_[which].topic;
}

std::string RobotIntake::camera_problem(std::size_t which) const {
  return live_cameras_[which] ? live_cameras_[which]->problem() : std::string();
}

Problems RobotIntake::open_camera(Wire& wire, std::size_t which, const VehicleDescription& vehicle) {
  const ConnectedCamera& camera = connection_.cameras[which];
  if (camera.topic.empty()) return open_live_camera(which, vehicle.camera(camera.name));
  NeededTopic& needed = images_[which];
  needed = {connection_.topic(camera.topic),
            camera.has_compressed_images() ? ros::CompressedImage::kType : ros::Image::kType};
  ArrivingImages& state = state_.cameras[which];
  Problems problems = subscribe(wire, needed, WireQuality::kSensor,
                                [this, which, type = needed.type](std::string_view message) {
                                  arrive(type, [&] { return take_image(message, which); });
                                });
  NeededTopic calibration{connection_.topic(camera.calibration_topic()), ros::CameraInfo::kType};
  for (Problem& problem :
       subscribe(wire, calibration, WireQuality::kSensor, [this, &state](std::string_view bytes) {
         arrive(ros::CameraInfo::kType, [&] {
           auto message = parse_cdr<ros::CameraInfo>(bytes);
           if (!message) return false;
           state.calibration = std::move(message);
           return true;
         });
       }))
    problems.push_back(std::move(problem));
  return problems;
}

Problems RobotIntake::open_live_camera(std::size_t which, const CameraDescription* described) {
  const ConnectedCamera& camera = connection_.cameras[which];
  const std::string key = "cameras[" + std::to_string(which) + "]";
  if (described == nullptr)
    return {{{connection_.file, 0, key},
             "the vehicle file has no camera '" + camera.name + "', so nobody says its lens and its mount"}};
  CameraSource source = camera.source;
  source.silent_max_s = camera.silent_max_s;
  source.width_px = described->width_px;
  source.height_px = described->height_px;
  if (!source.folder.empty())
    source.folder = (std::filesystem::path(connection_.file).parent_path() / source.folder).string();
  auto opened = LiveCamera::open(source);
  if (!opened) return opened.problems();
  live_cameras_[which] = std::move(*opened);
  return {};
}

/// The header alone is read: most images are replaced by newer ones before anybody wants their pixels.
bool RobotIntake::take_image(std::string_view message, std::size_t which) {
  const auto header = parse_header(message, BagEncoding::kCdr);
  if (!header) return false;
  const ros::Stamp_ns stamp = stamp_of(*header);
  if (stamp < 0) return false;
  const double stamp_s = ros::stamp_s(stamp);
  ArrivingImages& camera = state_.cameras[which];
  if (is_next(camera.stream, frame_name(header->frame_id), stamp_s, camera_name(which)))
    keep_image(camera, {stamp_s, std::string(message), nullptr});
  return true;
}

/// Their moments are by this machine's clocks; the robot's stamps are by the same, or by /clock.
void RobotIntake::take_live_images() {
  for (std::size_t i = 0; i < live_cameras_.size(); ++i) {
    if (!live_cameras_[i]) continue;
    auto image = live_cameras_[i]->newest(std::chrono::milliseconds(0));
    if (!image) continue;
    double stamp_s = static_cast<double>(image->realtime_ns) / 1e9;
    if (connection_.clock == ConnectedClock::kArrival) stamp_s = image->stamp_s;
    if (connection_.clock == ConnectedClock::kRos)
      stamp_s = state_.ros_clock_s.value_or(0) - (clock_.now_s() - image->stamp_s);
    if (is_next(state_.cameras[i].stream, {}, stamp_s, camera_name(i)))
      keep_image(state_.cameras[i], {stamp_s, {}, std::move(image->pixels)});
  }
}

void RobotIntake::keep_image(ArrivingImages& camera, ArrivedImage image) {
  camera.images.push_back(std::move(image));
  if (camera.images.size() <= kImagesWaiting) return;
  camera.images.pop_front();
  ++state_.counts.images_skipped;
}

Result<std::shared_ptr<const Image>> RobotIntake::pixels_of(const ArrivedImage& image,
                                                            std::size_t which) const {
  if (image.pixels) return image.pixels;
  auto read = bag_image(image.message, images_[which].type, BagEncoding::kCdr, {images_[which].topic});
  if (!read) return read.problems();
  return std::shared_ptr<const Image>(std::make_shared<Image>(std::move(read->pixels)));
}

}  // namespace aisle
