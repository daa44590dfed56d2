#pragma once
/// Makes the landmark navigator for missions and for their replays, both from the origin that the session
/// records: so both know the same building, rounded as it is written.

#include <memory>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"

namespace aisle {

/// What is to be driven.
struct LandmarkMission {
  std::string building;     ///< the text of a building file
  std::string route;        ///< of that building
  bool in_reverse = false;  ///< its return path
};

/// The path in the opposite direction. It ends early enough to stay on floor that was driven over when the
/// route was taught; empty if the path is too short for that.
Path path_back(const Path& path, const Footprint& footprint);

/// Owns the building that its navigator drives by.
class LandmarkDriver final : public Navigator {
 public:
  static constexpr const char* kName = "landmarks";  ///< name of the navigator in a session

  /// What a session records of it: name, changed parameters, mission. The caller sets the seed.
  static SessionOrigin origin(const LandmarkNavigatorParams& params, const LandmarkMission& mission);

  /// Problems: parameters and building that cannot be read, a building without landmarks, an unknown route, a
  /// vehicle whose camera is not the one that the landmarks were seen with.
  static Result<std::unique_ptr<LandmarkDriver>> make(const SessionOrigin& origin,
                                                      const VehicleDescription& vehicle);

  LandmarkDriver(const LandmarkNavigatorParams& params, const VehicleDescription& vehicle, Building building,
                 Path path);
  LandmarkDriver(const LandmarkDriver&) = delete;
  LandmarkDriver& operator=(const LandmarkDriver&) = delete;

  Decision step(const Observation& observation) override { return navigator_.step(observation); }

  const Building& building() const { return building_; }
  const Path& path() const { return path_; }
  const LandmarkNavigator& navigator() const { return navigator_; }

 private:
  Building building_;
  Path path_;
  LandmarkNavigator navigator_;
};

}  // namespace aisle
