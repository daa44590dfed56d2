#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/simulation/scenario_play.hpp"
#include "aisle/simulation/vehicle/camera_feed.hpp"
#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// All cameras of a simulated vehicle, each taking images at its own period.
class VehicleEyes {
 public:
  /// @param seeds  one is drawn for each camera
  VehicleEyes(const World& world, const VehicleModel& model, Random& seeds);

  /// Takes the images that are due; their stamp is `now_s`.
  /// @param moment  where the vehicle is and how it moves; light and laser are filled in here
  void look(double now_s, const CameraMoment& moment, std::span<const MovingBody> bodies,
            const ScenarioPlay& play);

  /// What has arrived since the last call.
  std::vector<CameraImage> deliver(double now_s);

 private:
  struct Eye {
    CameraDescription camera;
    CameraSensor sensor;
    CameraFeed feed;
    std::uint64_t taken = 0;

    bool is_due(double now_s) const;
    void take(double now_s, CameraMoment moment, const RenderedWorld& world, const CameraTrouble& trouble);
  };

  RenderedWorld world_;
  std::vector<Eye> eyes_;
  std::optional<LaserMarkers> laser_markers_;
};

}  // namespace aisle
