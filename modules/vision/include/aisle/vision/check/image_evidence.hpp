#pragma once
/// What one image tells of how well its features are seen, without anybody knowing where they truly are.
/// Lengths are shares of the image's width or height, so that images of all sizes compare.

#include <optional>

#include "aisle/core/image.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/vision/floor/line_finder.hpp"
#include "aisle/vision/route/route_region.hpp"

namespace aisle {

/// Light and sharpness. Grey levels are 0 to 255.
struct ImageQuality {
  double dark_share = 0;    ///< pixels of at most 5 grey levels: no detail is left there
  double bright_share = 0;  ///< pixels of at least 250 grey levels: nor there
  double contrast = 0;      ///< from the darkest twentieth of the pixels to the brightest [grey levels]
  double blur_across = 0;   ///< 0: sharp, 1: no step from left to right is sharp; 0 where there is no step
  double blur_down = 0;     ///< the same from row to row
};

/// Blur is that of Crete et al. (2007): how little of the steps between neighbouring pixels is lost when the
/// image, shrunk to 640 columns if it is wider, is blurred once more. Noise hides blur.
ImageQuality image_quality(const Image& grey);

/// A wall-floor edge against the free floor, which is found by other means.
struct EdgeEvidence {
  bool is_found = false;
  double floor_beneath = 0;     ///< share of the edge beneath which there is free floor
  double wall_above = 0;        ///< share of the edge above which there is none
  bool is_found_again = false;  ///< in the same image, smaller and darker, in the same place
};

struct ImageEvidence {
  int width_px = 0;
  int height_px = 0;
  ImageQuality quality;

  EdgeEvidence left, right;
  std::optional<Vec2>
      vanishing_point;  ///< of the corridor, as shares of width and height from the upper left

  int verticals = 0;
  int verticals_left = 0;          ///< whose middle is in the left half
  int standing = 0;                ///< verticals with a floor point
  int found_again = 0;             ///< verticals that are found in the same image, smaller and darker
  std::optional<double> lean_rad;  ///< median of those in the middle third; > 0: the top is to the right

  double floor_share = 0;       ///< of the image
  double floor_left_share = 0;  ///< of the free floor, in the left half
  double floor_top = 1;         ///< its highest row, as a share of the height from above
  double floor_above_end = 0;   ///< share of the free floor above the corridor's end; 0 if that is not found
  double floor_beyond_edges = 0;  ///< share of the free floor on the wall's side of a wall-floor edge
  double floor_overlap = 0;       ///< with what is found in the same image, smaller and darker: IoU
};

/// Looks at images one by one. Keeps buffers, and what it found in the last image.
class ImageExaminer {
 public:
  /// @param camera  if given, its distortion is removed before lines are fitted
  explicit ImageExaminer(const std::optional<CameraIntrinsics>& camera = std::nullopt);

  /// @param image  not empty
  ImageEvidence examine(const Image& image);

  /// Of the last image, in its pixels.
  const FoundLines& lines() const { return lines_; }
  /// Of the last image: 255 on the free floor, else 0.
  const Image& floor() const { return floor_; }

 private:
  void compare_with_smaller_and_darker(const Image& image, ImageEvidence& evidence);

  LineFinder finder_;
  LineFinder second_finder_;  ///< for the smaller image
  RouteRegionFinder floor_finder_;
  FoundLines lines_;
  Image floor_;
};

/// Two images in a row of one drive.
struct PairEvidence {
  bool is_alike = false;                        ///< they show nearly the same; if not, the rest says nothing
  bool left_came = false, left_stayed = false;  ///< found in either of the two; in both, nearly in one place
  bool right_came = false, right_stayed = false;  ///< the same of the right edge
  int verticals = 0;                              ///< of the later image
  int followed = 0;                               ///< of these, seen in the earlier image
  double floor_overlap = 0;                       ///< IoU of both images' free floor
};

/// Compares each image with the one before.
class PairExaminer {
 public:
  /// @return nullopt for the first image, and where the size changes
  std::optional<PairEvidence> take(const Image& image, const FoundLines& lines, const Image& floor);

  /// The next image has none before it.
  void forget() { before_.reset(); }

 private:
  struct Seen {
    Image grey;
    FoundLines lines;
    Image floor;
  };
  std::optional<Seen> before_;
};

}  // namespace aisle
