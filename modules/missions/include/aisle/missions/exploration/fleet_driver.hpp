#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/fleet/fleet_client.hpp"
#include "aisle/fleet/fleet_graph.hpp"
#include "aisle/guidance/exploration/guide_navigator.hpp"
#include "aisle/guidance/exploration/place_finder.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"

namespace aisle {

struct FleetDriverParams {
  GuideNavigatorParams guide;
  double node_spacing_m = kFleetSpacing_m;
  double off_edge_m = 1.5;
  double retry_s = 5;

  void describe(FieldList& fields);
};

/// Drives what a fleet's master control orders, edge by edge, and nothing else: it stands at the end of the
/// base, while it is paused, without an order, and while it does not know where it is. Each edge is driven as
/// GuideNavigator drives, but only along a path that stays near the edge: others may drive beyond.
class FleetDriver final : public Navigator {
 public:
  /// @param building  a building file's text
  /// @param link      must outlive the driver
  /// @param timestamp  what time it is: ISO 8601, UTC
  /// @return problems as those of GuideDriver::make
  static Result<std::unique_ptr<FleetDriver>> make(const FleetDriverParams& params,
                                                   const std::string& building,
                                                   const VehicleDescription& vehicle,
                                                   const MissionStart& start, const FleetIdentity& identity,
                                                   FleetLink& link, std::function<std::string()> timestamp);

  FleetDriver(const FleetDriverParams& params, const VehicleDescription& vehicle, Building building,
              const MissionStart& start, const FleetIdentity& identity, FleetLink& link,
              std::function<std::string()> timestamp);
  FleetDriver(const FleetDriver&) = delete;
  FleetDriver& operator=(const FleetDriver&) = delete;

  Decision step(const Observation& observation) override;
  /// Says that the vehicle leaves the fleet.
  void leave() { client_.leave(); }

  const GuideNavigator& navigator() const { return navigator_; }
  const FleetGraph& graph() const { return graph_; }
  const OrderTracker& tracker() const { return client_.tracker(); }
  bool is_finding() const { return finder_ != nullptr; }
  std::size_t times_lost() const { return times_lost_; }

 private:
  Decision drive(const Observation& observation);
  Decision find(const Observation& observation);
  void begin_finding(const std::optional<Pose2>& T_map_hint);
  void take_initial_pose();
  VehicleState vehicle_state(const Observation& observation);
  void follow_target(double stamp_s);
  void stand(double stamp_s);
  std::string why_not(const Vec2& p_map) const;
  double path_off_edge_m() const;
  Decision blocked(const std::string& why, double stamp_s);
  Command slowed(Command command) const;

  FleetDriverParams params_;
  VehicleDescription vehicle_;
  Building building_;
  FleetGraph graph_;
  GuideNavigator navigator_;
  FleetClient client_;
  std::unique_ptr<PlaceFinder> finder_;  ///< while nobody knows where the vehicle is
  std::optional<FleetTarget> sent_;      ///< the target that the navigator drives to
  std::optional<double> retry_at_s_;     ///< blocked until then
  std::optional<double> stamp_s_;        ///< of the last cycle
  Command command_;                      ///< of the last cycle
  bool needs_help_ = false;              ///< it could not find itself
  std::size_t times_lost_ = 0;
};

}  // namespace aisle
