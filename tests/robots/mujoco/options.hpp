#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "image_size.hpp"
#include "pose.hpp"

namespace robots {

/// The command line; kUsage says what each is for.
struct Options {
  std::string world;
  std::string drive = "differential";
  std::string command = "twist";
  bool slip = false;
  std::optional<Pose2> T_world_start;
  unsigned seed = 1;
  double scan_hz = 10;
  int scan_beams = 360;
  double range_max_m = 12;
  std::optional<ImageSize> camera;
  unsigned domain = 0;
  std::string ros_namespace;
  bool simulated_clock = false;
  double speed = 1;
  double seconds = 0;
  std::string report;
  std::string picture;
};

extern const char* const kUsage;

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError, in one line. @return nothing if help is asked for
std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace robots
