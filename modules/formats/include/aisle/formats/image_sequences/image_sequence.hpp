#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/front_steered.hpp"

namespace aisle {

/// What the driver's controls said, as recorded: numbers without units. A throttle is not a speed, and how
/// far the wheels turn at a steering of 1 is not known.
struct RecordedControls {
  double steering = 0;
  double throttle = 0;
};

/// What a recording tells of the camera that took its images, within what a vehicle file may say.
struct RecordedCamera {
  std::string topic = {};  ///< of a bag; else empty
  std::optional<CameraIntrinsics> lens;
  std::optional<CameraMount> mount;
};

/// An image as it was recorded, and what is known of its moment.
struct TimedImage {
  double stamp_s = 0;  ///< 0 to 2^31, at least a microsecond later than that of the image before
  std::string bytes;   ///< of a JPEG or PNG file that can be decoded, of the sequence's size
  std::optional<Pose2> T_odom_vehicle;  ///< by the wheels; in every image of a sequence with odometry
  std::optional<RecordedControls> controls;
};

/// The images of one camera in the order of recording, from whatever they were recorded in.
class ImageSequence {
 public:
  virtual ~ImageSequence() = default;

  virtual int width_px() const = 0;
  virtual int height_px() const = 0;
  virtual bool has_odometry() const = 0;
  virtual RecordedCamera camera() const { return {}; }
  /// The scans that the same vehicle recorded, on the same clock; they are moved out.
  virtual std::optional<LaserRecording> take_scans() { return std::nullopt; }
  /// Median time from one image to the next; 0: there is only one.
  virtual double period_s() const = 0;
  /// How many images the recording names; next() leaves out those that cannot be used.
  virtual std::size_t size() const = 0;

  /// @return nullopt after the last
  virtual Result<std::optional<TimedImage>> next() = 0;

  /// How many images and records were left out so far.
  virtual std::size_t left_out() const = 0;
  /// What was left out or guessed, each with its first place; complete after the last image.
  virtual Problems warnings() const = 0;
};

/// What the user says of a recording.
struct ImageSequenceOptions {
  std::optional<double> rate_hz;              ///< > 0: images have this rate, whatever stamps they have
  std::optional<FrontSteered> front_steered;  ///< tells what distances and steering angles mean
  std::string topic = {};                     ///< of a bag's images; empty: the only one that has any
  RecordingOptions reading = {};              ///< of a bag's scans and odometry
};

/// Opens a recording: a Donkeycar tub, a folder of images, a list of images, a ROS bag. What it is shows in
/// its content; docs/formats/image-sequences.md. A recording without a single usable image is a problem.
Result<std::unique_ptr<ImageSequence>> open_image_sequence(const std::string& recording,
                                                           const ImageSequenceOptions& options = {});

/// The images of a folder that is nothing but a folder of images, in natural order of their names; they may
/// have any size. Empty if it has none, or is a recording of another kind.
std::vector<std::filesystem::path> images_in_folder(const std::filesystem::path& folder);

}  // namespace aisle
