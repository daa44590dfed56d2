#pragma once

#include <memory>
#include <optional>
#include <string>

#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/localisation/localiser.hpp"

namespace aisle {

struct PlaceFinderParams {
  LocaliserParams localiser;
  double time_max_s = 120;  ///< then it gives up
  double path_max_m = 15;   ///< likewise

  void describe(FieldList& fields);
};

/// Finds the vehicle in a building that it knows. While several places fit, it drives as carefully as in a
/// building that it does not know, because it does not know where it is: it explores.
class PlaceFinder final : public Navigator {
 public:
  /// @param building    must outlive the construction only
  /// @param T_map_hint  where somebody says that the vehicle is
  PlaceFinder(const PlaceFinderParams& params, const VehicleDescription& vehicle, const Building& building,
              const std::optional<Pose2>& T_map_hint);

  /// kDone when it is found; kFailed with what is known instead when it is not.
  Decision step(const Observation& observation) override;

  const Localiser& localiser() const { return localiser_; }
  const ExplorerNavigator& explorer() const { return explorer_; }
  double path_m() const { return path_m_; }

 private:
  void see(const Observation& observation);
  std::string why_not_found() const;

  PlaceFinderParams params_;
  VehicleDescription vehicle_;
  std::unique_ptr<ScanSource> sensor_;
  ExplorerNavigator explorer_;
  Localiser localiser_;
  ScanView view_;
  std::vector<Vec2> hits_;
  Pose2 T_scan_vehicle_;  ///< since the last scan, by odometry
  double path_m_ = 0;
  std::optional<double> begun_s_;
};

}  // namespace aisle
