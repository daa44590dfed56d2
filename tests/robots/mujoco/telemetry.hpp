#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.hpp"
#include "physics.hpp"
#include "range_scanner.hpp"
#include "ros/messages.hpp"
#include "ros/participant.hpp"
#include "vehicle.hpp"
#include "wheel_odometry.hpp"

namespace robots {

/// What a robot tells: each function publishes one kind of reading, taken at the time of the stamp.
class Telemetry {
 public:
  Telemetry(const Participant& participant, const Options& options, const Vehicle& vehicle);

  /// Where the sensors sit: latched.
  void publish_mounts(const Time& stamp) const;
  void publish_clock(const Time& stamp) const;
  void publish_odometry(const Time& stamp, const WheelOdometry& odometry) const;
  void publish_joints(const Time& stamp, const Physics& physics) const;
  void publish_bumper(bool pressed) const;
  void publish_scan(const Time& stamp, const RangeScanner& scanner, std::vector<float> ranges,
                    double period_s) const;
  /// @param pixels as OffscreenView draws them; published in grey
  void publish_image(const Time& stamp, const std::vector<std::uint8_t>& pixels) const;

 private:
  struct CameraTopics {
    ImageSize size;
    Publisher<Image> image;
    Publisher<CameraInfo> info;
  };

  CameraInfo camera_info(const Time& stamp) const;

  Vehicle vehicle_;
  Publisher<TFMessage> tf_, tf_static_;
  Publisher<Odometry> odometry_;
  Publisher<JointState> joints_;
  Publisher<Bool> bumper_;
  Publisher<LaserScan> scan_;
  std::optional<Publisher<Clock>> clock_;
  std::optional<CameraTopics> camera_;
};

}  // namespace robots
