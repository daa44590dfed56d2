#pragma once
/// What all plans share: the strip behind a wall's face, title, scale bar, legend.

#include <functional>
#include <span>
#include <string>

#include "aisle/geometry/segment2.hpp"
#include "canvas.hpp"
#include "palette.hpp"
#include "picture_scale.hpp"

namespace aisle {

inline constexpr Color kWallBody{0.86, 0.88, 0.905};
inline constexpr Color kPath{0.13, 0.47, 0.86};
inline constexpr Font kLabelFont{17, kInk};

/// A wall is given by its face; a strip behind it joins faces that belong together into one solid wall.
void draw_wall_bodies(Canvas& canvas, const PictureScale& scale, std::span<const Segment2> faces);

/// Title and, below it, one line of caption; in smaller type if they would not fit.
void draw_header(Canvas& canvas, const PictureScale& scale, const std::string& title,
                 const std::string& caption);

/// In the lower left corner.
void draw_scale_bar(Canvas& canvas, const PictureScale& scale);

/// In the lower right corner, from right to left; entries that do not fit beside the scale bar go above it.
class Legend {
 public:
  Legend(Canvas& canvas, const PictureScale& scale);

  /// @param draw_sign  draws around the given point, at most `width_px` wide
  void add(const std::string& label, double width_px, const std::function<void(const Vec2&)>& draw_sign);
  void add_line(const std::string& label, const Pen& pen);

 private:
  Canvas& canvas_;
  double rightmost_px_;
  double right_px_;
  double y_px_;
  bool is_beside_bar_ = true;
};

}  // namespace aisle
