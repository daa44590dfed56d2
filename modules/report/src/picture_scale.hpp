#pragma once

#include "aisle/maps/wall_map.hpp"
#include "aisle/report/map_picture.hpp"

namespace aisle {

/// Places the map on the paper. Paper coordinates are pixels from the top left corner, y down.
struct PictureScale {
  int width_px = 0;  ///< of the whole picture
  int height_px = 0;
  double px_per_m = 1;
  Vec2 low = Vec2::Zero();          ///< lower left corner of the visible area [m]
  Vec2 high = Vec2::Zero();         ///< upper right corner
  Vec2 p_paper_low = Vec2::Zero();  ///< position of the lower left corner on the paper [px]

  /// The point on the paper, rounded to an eighth of a pixel: finer differences only make files larger.
  Vec2 to_paper(const Vec2& p_map) const;
};

inline constexpr double kMargin_px = 48;
inline constexpr double kHeader_px = 104;  ///< title and caption
inline constexpr double kFooter_px = 84;   ///< scale bar and legend

/// The bounds of a picture's content.
struct PictureContent {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);

  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

/// The largest scale that shows all content in a picture whose longer side is 1600 px. No content: 10 m x 10
/// m.
PictureScale fit_scale(PictureContent content);

/// The scale that shows walls and path.
PictureScale fit_scale(const MapPicture& picture);

/// The largest of 1, 2, 5 times a power of ten that is at most `length`; `length` > 0.
double round_length(double length);

}  // namespace aisle
