#pragma once
/// Where the walls of a corridor meet the floor, as seen by a camera that looks along it.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Lengths in px hold for the image that is looked at, which is shrunk to `width_max_px`; a narrower
/// image is looked at as it is and they shrink with it.
struct BaseLineParams {
  int width_max_px = 640;
  double score_min = 0.11;
  double floor_point_share = 0.03;
  double standing_share_min = 0.16;

  void describe(FieldList& fields);
};

/// (u, v) in the image as given, from far to near; two points, more where lens distortion bends the line.
using BaseLine = std::vector<Vec2>;

struct BaseLines {
  std::optional<BaseLine> left;
  std::optional<BaseLine> right;
  std::optional<Vec2> vanishing_point_px;  ///< of the corridor, where it was found
};

/// Finds the lines between floor and wall to the left and right: edges towards the corridor's vanishing
/// point, on which vertical lines end, beneath which the route region lies and above which it does not. A
/// image of 640 x 480 takes about 2 ms.
class BaseLineDetector {
 public:
  /// @param camera  if given, lines are fitted where its distortion is undone; they are reported as seen
  explicit BaseLineDetector(const BaseLineParams& params = {},
                            const std::optional<CameraModel>& camera = std::nullopt);
  BaseLineDetector(BaseLineDetector&&) noexcept;
  ~BaseLineDetector();

  /// @param verticals  of the same image, as VerticalLineDetector finds them; the more, the surer the
  /// answer
  /// @throws std::invalid_argument unless the image has one channel
  BaseLines detect(const Image& grey, std::span<const VerticalLine> verticals);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// Ends vertical lines at the floor: those that only lie on it (reflections) are dropped, those that fade
/// beneath their base line end there, and those whose lower end is on it or on its skirting board are brought
/// to it and get their floor point.
/// @param grey, verticals  the image and its lines; both as given to and returned by the detectors
void stand_on_floor(const Image& grey, const BaseLines& base_lines, const BaseLineParams& params,
                    std::vector<VerticalLine>& verticals);

}  // namespace aisle
