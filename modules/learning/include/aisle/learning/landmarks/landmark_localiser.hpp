#pragma once
/// Where the vehicle is among known landmarks: C98 Algorithm 2 steps 9-13 and Algorithm 3 steps 6-9, one
/// image after the other.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/landmarks/landmark_patterns.hpp"
#include "aisle/learning/pose_filter.hpp"
#include "aisle/learning/walls/wall_compass.hpp"

namespace aisle {

struct LandmarkLocaliserParams {
  MwghtParams mwght;
  double confidence_m2 = 4;  ///< Cd of C98 eq. (16)
  double window_sigmas = 3;
  double window_min_m = 0.08;
  double window_min_rad = 1 * kDegree;
  double window_max_m = 1.5;
  double window_max_rad = 12 * kDegree;
  double ambiguous_share = 0.8;
  double gate_sigmas = 3.5;
  double together_sigmas = 2.5;
  double landmark_sigma_m = 0.02;
  double repeat_inflation = 3;
  double matched_share_min = 0.34;
  int pairs_min = 2;
  bool polarity = true;
  bool covariance = true;
  bool heading_by_walls = true;

  void describe(FieldList& fields);
};

/// What one image said about the pose.
enum class LandmarkMatch {
  kMatched,    ///< the pose was corrected
  kAmbiguous,  ///< two displacements with different pairs fit about as well; odometry alone moves the pose
  kUnmatched,  ///< other landmarks were seen than expected; odometry alone
  kNothing,    ///< nothing was seen, or nothing known; odometry alone
};

/// A sighting and the landmark matched with it, as indices.
struct LandmarkPair {
  std::size_t sighting = 0;
  std::size_t landmark = 0;

  friend bool operator==(const LandmarkPair&, const LandmarkPair&) = default;
};

class LandmarkLocaliser {
 public:
  LandmarkLocaliser(const LandmarkLocaliserParams& params, const VehicleDescription& vehicle,
                    const UncertainPose2& T_map_vehicle);

  void predict(const OdometryReading& reading);

  /// As those of PoseFilter: around `correct`, for an image that was taken some predictions ago.
  bool go_back(int predictions) { return filter_.go_back(predictions); }
  void catch_up() { filter_.catch_up(); }

  /// Finds the displacement of the sightings against the map within the window that the pose's uncertainty
  /// leaves open (MWGHT), pairs sightings with landmarks there, and updates the filter with the pairs. The
  /// cost does not depend on the size of the map. A second image from the same place has the errors of the
  /// first: a standing vehicle does not become surer and surer.
  /// @param floor_edges  of the same image, in base_link. A match gives their direction on the map; where
  ///                     nothing known is seen, or the heading is far less sure, they give the heading.
  LandmarkMatch correct(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
                        std::span<const SensedSegment> floor_edges = {});

  /// Corrects the heading by a measurement from elsewhere; ignored if it is too far off.
  void correct_heading(const HeadingMeasurement& measured);

  /// Puts the vehicle at a pose.
  /// @param walls  direction of the walls there, if known
  void place(const UncertainPose2& T_map_vehicle, const std::optional<WallDirection>& walls = {});

  const Pose2& pose() const { return filter_.pose(); }
  Mat3 covariance() const { return filter_.covariance(); }
  const std::vector<LandmarkPair>& pairs() const { return pairs_; }  ///< of the last image
  double matched_share() const { return matched_share_; }            ///< of the last image's weights
  /// The same with each pair weighted by how well it fits, 0 .. matched_share.
  double agreement() const { return agreement_; }
  /// How much more likely the last image is here than among unknown landmarks (logarithm of the ratio): each
  /// pair adds kPairEvidence less half its squared distance in standard deviations, and never less than 0.
  double evidence() const { return evidence_; }
  static constexpr double kPairEvidence = 3;

 private:
  LandmarkMatch correct_by_landmarks(const LandmarkMap& map, std::span<const LandmarkSighting> sightings);
  bool has_matched() const;
  bool is_believable(const Pose2& T_map_guess) const;
  LandmarkMatch without_match(const LandmarkMap& map, std::span<const LandmarkSighting> sightings);
  void take_in(const Pose2& T_map_guess);
  double heading_sigma_rad() const { return std::sqrt(filter_.covariance()(2, 2)); }
  MwghtWindow window() const;
  bool is_elsewhere(const Pose2& best, const Pose2& other) const;
  void pair_up(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
               const Pose2& T_map_vehicle);

  LandmarkLocaliserParams params_;
  PoseFilter filter_;
  WallCompass compass_;
  Mwght mwght_;
  LandmarkPatterns patterns_;  ///< of the last image, in base_link as predicted
  std::vector<LandmarkPair> pairs_, first_pairs_;
  std::vector<SeenPoint> points_;
  std::vector<char> taken_;
  int taken_in_here_ = 0;      ///< images that corrected the pose since the vehicle came here
  double since_here_m_ = 0;    ///< path since the first of them ...
  double since_here_rad_ = 0;  ///< ... and how far it has turned
  double matched_share_ = 0;
  double agreement_ = 0;
  double evidence_ = 0;
};

}  // namespace aisle
