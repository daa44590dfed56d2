#pragma once
/// What a camera that looks down ahead shows of the route: L96 section 3.1.

#include <optional>
#include <span>
#include <vector>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "aisle/vision/stripes/stripe_scan.hpp"

namespace aisle {

struct RouteViewParams {
  RegionParams region;
  StripeScanParams stripe{.wide_m = 0.6};
  double far_scan_m = 2.2;
  double near_scan_m = 1.3;
  double check_ahead_m = 0.5;
  double check_beside_m = 0.12;
  double check_share = 0.85;
  double edge_range_m = 4;

  void describe(FieldList& fields);
};

/// Where an obstacle will be too near (L96 Fig. 7), and on which side there is more free floor.
struct RouteChecks {
  bool ahead = false;     ///< A
  bool left = false;      ///< B
  bool right = false;     ///< C
  double left_share = 0;  ///< route area in the left half of the view, of that half
  double right_share = 0;
};

/// One look at the route.
struct RouteSight {
  Image mask;             ///< 255 on the route, as large as the image
  double share = 0;       ///< route area, of the image
  double patch_grey = 0;  ///< mean of the patch before the vehicle (L96 section 2.2)
  double patch_deviation = 0;
  RouteChecks checks;
  std::vector<Vec2> p_vehicle_edges;    ///< where the route ends, seen from the vehicle; within edge_range_m
  std::vector<Vec2> p_vehicle_cut_off;  ///< on the view's lower edge: what stands there is nearer than shown
};

/// Sees the route with one camera. All points are in base_link. Beyond the paper: where the stripe of the
/// vehicle's line lasers is seen, something stands, however much it looks like the route.
class RouteView {
 public:
  /// Whether the camera looks down: the middle of its lowest row must see the floor.
  static bool sees_floor(const CameraIntrinsics& intrinsics, const CameraMount& mount, int width_px,
                         int height_px);

  /// Throws std::invalid_argument unless the camera sees the floor.
  /// @param width_m  of the vehicle
  /// @param stripe_height_m  of the line lasers' light plane above the floor; nullopt: brightness alone
  ///                         decides
  RouteView(const RouteViewParams& params, const CameraIntrinsics& intrinsics, const CameraMount& mount,
            int width_px, int height_px, double width_m, std::optional<double> stripe_height_m = {});

  /// @return valid until the next image
  const RouteSight& look(const Image& image);
  /// The latest; nullopt: there was no image.
  const std::optional<RouteSight>& sight() const { return sight_; }

  /// B' of L96 Algorithm 4: the middle of the two scan lines' middles, on the floor. The view's left and
  /// right margins, as shares of its width, are masked.
  /// @return nullopt unless the region meets both lines
  std::optional<Vec2> middle(const RouteSight& sight, double mask_left, double mask_right) const;

  /// Image rows of the two scan lines.
  int far_row() const { return far_row_; }
  int near_row() const { return near_row_; }

  /// The pixel that sees a floor point; nullopt: none does.
  std::optional<Vec2> pixel_of(const Vec2& p_vehicle) const;
  /// The floor point that a pixel sees, if it is not too far away to be known.
  std::optional<Vec2> floor_point(const Vec2& pixel_px) const { return floor_.point(pixel_px); }
  /// Whether a floor point is in view and is route there.
  bool sees_route(const RouteSight& sight, const Vec2& p_vehicle) const;
  /// Whether an obstacle at a floor point stands on the patch before the vehicle, or hides it.
  bool is_before_patch_end(const Vec2& p_vehicle) const;

 private:
  using FloorPatch = std::vector<std::size_t>;  ///< pixels, as offsets into a mask
  /// A piece of an obstacle that the line lasers' stripe lights.
  struct LitPiece {
    std::span<const Vec2> p_vehicle;     ///< from right to left
    bool goes_on = false;                ///< from the previous piece: they share a point
    std::optional<bool> has_floor_edge;  ///< the floor edge is seen beneath it; nullopt: out of view
  };

  std::optional<Vec2> projected(const Vec2& p_vehicle, double height_m) const;
  FloorPatch patch_of(double ahead_from_m, double ahead_to_m, const Interval& lateral_m) const;
  bool is_occupied(const Image& mask, const FloorPatch& patch) const;
  void find_edges(RouteSight& sight) const;
  void take_out_lit(const Image& image, Image& mask);
  void find_lit_pieces(const Image& grey);
  std::optional<bool> has_floor_edge(const Image& grey, std::span<const Vec2> p_vehicle_thing) const;
  bool leaves_view(const Vec2& p_vehicle_inwards, const Vec2& p_vehicle_end) const;
  int floor_point_column(const Vec2& p_vehicle) const;
  void take_out_columns(int begin, int end, Image& mask) const;
  void take_out_above(const Vec2& p_vehicle_right, const Vec2& p_vehicle_left, Image& mask) const;
  int row_at(double ahead_m) const;

  RouteViewParams params_;
  RouteRegionFinder regions_;
  std::optional<RouteSight> sight_;
  CameraModel camera_;
  CameraMount mount_;
  BackProjection floor_;
  int width_px_, height_px_;
  double nearest_m_ = 0;                 ///< ahead, the floor at the view's lower edge
  Vec2 p_vehicle_patch_ = Vec2::Zero();  ///< the patch's far left corner
  int far_row_ = 0, near_row_ = 0;
  FloorPatch ahead_, left_, right_;
  std::optional<StripeScan> stripe_;
  double stripe_height_m_ = 0;
  std::vector<Vec2> p_vehicle_returns_;
  std::vector<LitPiece> lit_pieces_;
  Image grey_;
};

}  // namespace aisle
