#pragma once
/// Edges of door frames, corners, pillars, posters: the lines of an image that are vertical in the building.

#include <memory>
#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Lengths in px apply to the working image, which is shrunk to `width_max_px`. A narrower image is not
/// enlarged; the lengths shrink with it.
struct VerticalLineParams {
  int width_max_px = 640;
  int bands = 120;
  double contrast_min = 3.5;
  double stray_px = 1.25;
  double straight_px = 1.3;
  double slope_max = 0.33;
  double tilt_deviation_max = 0.07;
  double gap_share_max = 0.12;
  double fade_share = 0.45;
  double length_share_min = 0.07;
  double fill_min = 0.6;
  double score_min = 0.35;
  double usual_score_min = 0.7;
  double apart_px = 4;

  void describe(FieldList& fields);
};

struct VerticalLine {
  Vec2 top_px = Vec2::Zero();     ///< (u, v) in the image as given, sub-pixel
  Vec2 bottom_px = Vec2::Zero();  ///< below the top: greater v
  double contrast = 0;           ///< mean step across the line [grey levels]; > 0: the right side is brighter
  bool has_floor_point = false;  ///< the lower end stands on a base line, see base_lines.hpp
};

/// Finds near-vertical lines (C98's landmarks): horizontal steps in bands of rows, linked downwards and cut
/// where they bend. Those that agree with one vertical vanishing point are kept. Tilt and roll of the
/// camera may be up to about 15 degrees. No allocation once warm; an image of 640 x 480 takes about a
/// millisecond.
class VerticalLineDetector {
 public:
  /// @param camera  if given, lines are fitted where its distortion is undone; they are reported as seen
  explicit VerticalLineDetector(const VerticalLineParams& params = {},
                                const std::optional<CameraModel>& camera = std::nullopt);
  VerticalLineDetector(VerticalLineDetector&&) noexcept;
  ~VerticalLineDetector();

  /// The lines of one image from left to right, floor points not yet decided; valid until the next call.
  /// @throws std::invalid_argument unless the image has one channel
  const std::vector<VerticalLine>& detect(const Image& grey);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace aisle
