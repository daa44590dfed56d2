#pragma once

#include <memory>
#include <optional>
#include <string>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct ImageMonitorParams {
  double age_max_s = 0.5;
  double dark_level = 10;
  double bright_level = 248;

  void describe(FieldList& fields);
};

/// Checks that a camera still works: its images arrive in time, change, and are neither black nor washed out.
class ImageMonitor {
 public:
  ImageMonitor(const ImageMonitorParams& params, const CameraDescription& camera);

  /// @return the camera's image if this observation has one that can be trusted; nullptr otherwise. Points
  ///         into the observation
  const CameraImage* look(const Observation& observation);

  /// What is wrong now, as text for the user: "camera front is frozen"; nullopt if nothing is.
  std::optional<std::string> trouble(double now_s) const;

 private:
  const char* fault_of(const CameraImage& image, double now_s);

  ImageMonitorParams params_;
  CameraDescription camera_;
  std::shared_ptr<const Image> last_;
  std::optional<double> good_stamp_s_;  ///< of the last good image
  const char* what_ = "has sent no image";
};

}  // namespace aisle
