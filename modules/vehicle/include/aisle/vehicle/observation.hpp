#pragma once
/// What a vehicle reports in one cycle.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/differential.hpp"
#include "aisle/vehicle/front_steered.hpp"

namespace aisle {

/// One camera's image. A camera that has delivered nothing new in a cycle is absent from it.
struct CameraImage {
  std::string camera;  ///< CameraDescription::name
  double stamp_s = 0;  ///< middle of the exposure
  std::shared_ptr<const Image> pixels;
};

/// One turn of a 2-D range scanner; its angles are VehicleDescription::scanner.
struct RangeScan {
  double stamp_s = 0;
  std::vector<float> ranges_m;  ///< range_max_m or more: nothing seen; 0: nothing usable
};

/// What the wheels counted since the last cycle.
using OdometryReading = std::variant<FrontSteeredMotion, WheelSteps>;

/// Something that the person at the vehicle says about where it is.
struct Mark {
  enum class Kind {
    kTurningBegins,  ///< label: the turning's number, 1 to 13 (docs/reference/turnings.md)
    kTurningEnds,    ///< label: as above
    kPlace,          ///< label: the place's name
    kStop,           ///< the route ends here
  };
  Kind kind = Kind::kPlace;
  std::string label;

  friend bool operator==(const Mark&, const Mark&) = default;
};

/// A goal that is added to those of a mission behind the last one, or taken out before it is reached.
struct GoalChange {
  std::string added = {};   ///< name, "x,y" in the map [m] or "x,y,heading_deg"; empty: one is taken out
  std::size_t removed = 0;  ///< its number, from 1; 0: none

  friend bool operator==(const GoalChange&, const GoalChange&) = default;
};

/// What the person at the controls did since the last cycle.
struct OperatorInput {
  std::optional<Command> requested;  ///< how to drive from now on; absent: nothing was pressed
  std::vector<Mark> marks;
  std::vector<GoalChange> goal_changes = {};  ///< in this order
  bool quit = false;
  bool gives_up = false;  ///< quits because the vehicle cannot get where the route leads
};

struct Observation {
  double stamp_s = 0;  ///< end of the cycle; strictly increasing
  std::vector<CameraImage> images;
  OdometryReading odometry;
  std::optional<RangeScan> scan;
  OperatorInput operator_input;
  bool bumper_pressed = false;  ///< the vehicle touches something and has stopped by itself
};

/// What a camera saw at the end of the cycle; null if nothing came, or only an image from an earlier cycle.
const CameraImage* present_image(const Observation& observation, const std::string& camera, double cycle_s);

}  // namespace aisle
