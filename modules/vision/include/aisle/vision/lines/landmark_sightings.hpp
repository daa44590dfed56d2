#pragma once
/// C98's local features: where the vertical lines of an image stand on the floor, as the vehicle sees it.

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/vision/floor/floor_edges.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

struct LandmarkSightingParams {
  VerticalLineParams verticals{.usual_score_min = 0.3};  ///< faint lines are all that a bare wall shows
  FloorEdgeParams floor_edges;
  BackProjectionNoise noise;
  double relief_m = 0.02;
  double edge_m = 0.01;
  double distance_max_m = 12;
  double leaning_max_rad = 2 * kDegree;
  double board_height_m = 0.16;
  double floor_point_px = 4;
  bool hanging = true;   ///< use lines that end above the floor, too: see LandmarkDetector
  bool corners = false;  ///< use corners where two floor edges meet, even without a line there

  void describe(FieldList& fields);
};

/// A vertical line that stands on the floor.
struct LandmarkSighting {
  Vec2 p_vehicle = Vec2::Zero();   ///< its floor point, in base_link [m]
  Mat2 covariance = Mat2::Zero();  ///< of the floor point [m^2]; long along the line of sight
  Vec2 by_tilt = Vec2::Zero();     ///< the part of that which all sightings of one image share: how far the
                                   ///< floor point goes when the tilt is off by a standard deviation [m]
  Vec2 floor_point_px = Vec2::Zero();  ///< in the image
  bool brighter_right = false;         ///< the right side of the line is brighter; false for a corner

  /// The part of the covariance that the image's other sightings do not share.
  Mat2 own_covariance() const { return covariance - by_tilt * by_tilt.transpose(); }
};

/// Image -> vertical lines -> floor edges -> floor points. A line that ends on a floor edge, or on the
/// skirting board above it, has its floor point there. A line that ends higher (a poster's edge) hangs on the
/// wall above that edge: its floor point is where its azimuth meets the edge, if there is only one. A line
/// that goes on beneath the edge stands nearer, where no edge was seen, and has none; its reflection in the
/// floor does not count. Floor points beyond 7 m are used only where no nearer one is seen. No allocation
/// once warm.
class LandmarkDetector {
 public:
  LandmarkDetector(const LandmarkSightingParams& params, const CameraIntrinsics& intrinsics,
                   const CameraMount& mount);

  /// From left to right; valid until the next call.
  /// @throws std::invalid_argument unless the image has one channel
  const std::vector<LandmarkSighting>& detect(const Image& grey);

  /// The lines and edges of the last image, for drawings; floor points as in the sightings.
  const std::vector<VerticalLine>& lines() const { return lines_; }
  const std::vector<FloorEdge>& floor_edges() const { return *floor_edges_; }

 private:
  /// Where a line's azimuth meets an edge.
  struct Meeting {
    Vec2 p_vehicle = Vec2::Zero();
    double distance_m = 0;  ///< from the point beneath the lens
    Vec2 pixel_px = Vec2::Zero();
    double sigma_m = 0;  ///< of the distance: the edge is where the wall is, and the line may stand proud
  };

  void add_corners();
  std::optional<Vec2> corner_of(const Segment2& a, const Segment2& b) const;
  bool is_upright(const VerticalLine& line) const;
  void leave_out_far();
  std::optional<Vec2> azimuth(const Vec2& pixel_px) const;
  void meet_edges(const VerticalLine& line);
  bool may_hang(const FloorEdge& edge) const;
  std::optional<LandmarkSighting> sighting_at(const Meeting& floor_point) const;
  std::optional<Meeting> floor_point_of(const Image& grey, const VerticalLine& line) const;
  std::optional<Meeting> standing_floor_point(const Image& grey, const VerticalLine& line) const;
  bool stands_proud(const VerticalLine& line, const Meeting& meeting) const;
  std::optional<Meeting> hanging_floor_point(const VerticalLine& line) const;
  double height_m(const Vec2& pixel_px, double distance_m) const;

  LandmarkSightingParams params_;
  CameraModel camera_;
  CameraMount mount_;
  Mat3 R_vehicle_camera_;
  BackProjection floor_;
  BackProjection floor_tilted_;  ///< the same with the tilt off by a standard deviation
  VerticalLineDetector verticals_;
  FloorEdgeDetector floor_edge_detector_;
  std::vector<VerticalLine> lines_;
  const std::vector<FloorEdge>* floor_edges_ = nullptr;
  std::vector<Meeting> meetings_;  ///< of one line, the nearest first
  std::vector<LandmarkSighting> sightings_;
};

}  // namespace aisle
