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

/// Lengths in px apply to the working image, which is shrunk to `width_max_px`. A narrower image is not
/// enlarged; the lengths shrink with it.
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

/// Finds the wall-floor edges to the left and right: edges towards the corridor's vanishing point, on which
/// vertical lines end, with the route region beneath them and not above. An image of 640 x 480 takes about
/// 2 ms.
class BaseLineDetector {
 public:
  /// @param camera  if given, lines are fitted where its distortion is undone; they are reported as seen
  explicit BaseLineDetector(const BaseLineParams& params = {},
                            const std::optional<CameraModel>& camera = std::nullopt);
  BaseLineDetector(BaseLineDetector&&) noexcept;
  ~BaseLineDetector();

  /// @param verticals  of the same image, as VerticalLineDetector finds them; more of them make the answer
  ///                   surer
  /// @throws std::invalid_argument unless the image has one channel
  BaseLines detect(const Image& grey, std::span<const VerticalLine> verticals);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// Ends vertical lines at the floor. Lines that lie on it (reflections) are dropped, lines that fade beneath
/// their base line end there. Lines whose lower end is on the base line or its skirting board are extended to
/// it and marked as having their floor point.
/// @param grey, verticals  the image and its lines; both as given to and returned by the detectors
void stand_on_floor(const Image& grey, const BaseLines& base_lines, const BaseLineParams& params,
                    std::vector<VerticalLine>& verticals);

}  // namespace aisle
