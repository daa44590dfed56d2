#pragma once
/// Whether a camera sees what the vehicle would drive by, judged by many images without truth: by how often
/// features are found, found again, and agree with each other. It cannot know whether they are right.

#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/vision/check/image_evidence.hpp"

namespace aisle {

/// The shares' defaults are those that tell right findings from wrong ones on labelled images of others
/// (benchmarks/reports/2026-11-29-real-images).
struct ViewCheckParams {
  int images_min = 5;
  double share_min = 0.6;
  int verticals_min = 3;
  int standing_min = 2;
  double floor_beneath_min = 0.4;
  double horizon_apart_max = 0.1;
  double floor_overlap_min = 0.65;
  double floor_beyond_max = 0.5;
  double floor_above_max = 0.08;
  double floor_share_min = 0.05;

  void describe(FieldList& fields);
};

enum class ViewVerdict {
  kSeen,       ///< in so many images that chance does not explain it
  kDoubtful,   ///< in some
  kNotSeen,    ///< in so few images that chance does not explain it
  kNotJudged,  ///< there are too few images
};

/// One feature, over all images.
struct FeatureCheck {
  ViewVerdict verdict = ViewVerdict::kNotJudged;
  int images = 0;         ///< that were looked at
  int good = 0;           ///< of these, in which the feature is seen and agrees with the others
  double share_low = 0;   ///< of all such images, 0 to 1: the 90 % interval of Wilson's score ...
  double share_high = 1;  ///< ... as if they had been drawn at random
};

/// What of one image is seen and agrees.
struct GoodViews {
  bool left_edge = false, right_edge = false;
  bool verticals = false;     ///< enough of them, found again
  bool floor_points = false;  ///< enough verticals stand on a wall-floor edge
  bool floor = false;
};

/// What would probably help. A hint is no measurement.
enum class ViewHint {
  kMoreImages,
  kLensUnknown,
  kSmall,         ///< few pixels
  kDark,          ///< much is black
  kBright,        ///< much is burnt out
  kFlat,          ///< little contrast
  kBlurAcross,    ///< from left to right, as of turning too fast
  kBlurDown,      ///< from row to row, as of a nodding camera
  kLooksUp,       ///< the corridor's end is low in the image: little floor is seen
  kLooksDown,     ///< it is high: lines are cut off
  kNods,          ///< its row changes from image to image
  kRolled,        ///< verticals lean to one side
  kFeetUnseen,    ///< verticals are seen, but not where they stand
  kFloorUnclear,  ///< the free floor climbs the walls, or changes with the light
  kOneSided,      ///< edges are seen on one side alone
};

struct ViewMedians {
  double width_px = 0, height_px = 0;
  ImageQuality quality;
  double verticals = 0, standing = 0;
  double found_again_share = 0;         ///< of the verticals
  std::optional<double> horizon;        ///< row of the corridor's end, as a share of the height from above
  std::optional<double> horizon_range;  ///< from the row's lower quartile to the upper
  std::optional<double> lean_rad;
  double floor_share = 0, floor_left_share = 0, floor_above_end = 0, floor_beyond_edges = 0,
         floor_overlap = 0;
};

/// Over pairs of images in a row that show nearly the same.
struct SteadinessCheck {
  int pairs = 0;
  int edges = 0, edges_stayed = 0;  ///< both sides together
  int verticals = 0, verticals_followed = 0;
  double floor_overlap = 0;  ///< median
};

struct ViewCheck {
  std::vector<GoodViews> views;  ///< of each image
  FeatureCheck left_edge, right_edge;
  FeatureCheck edges;  ///< at least one side
  FeatureCheck verticals, floor_points, floor;
  FeatureCheck landmarks, sections, rooms;  ///< the methods, by what each drives by
  ViewMedians medians;
  SteadinessCheck steadiness;
  std::vector<ViewHint> hints;
};

/// @param images  at least one
/// @param is_lens_known  lines were fitted with a calibration
/// @throws std::invalid_argument if there is no image
ViewCheck check_views(std::span<const ImageEvidence> images, std::span<const PairEvidence> pairs,
                      bool is_lens_known, const ViewCheckParams& params = {});

/// Of `images`, `good` ones. @param images  >= 0
FeatureCheck judged(int good, int images, const ViewCheckParams& params);

}  // namespace aisle
