#pragma once

#include <span>
#include <string>

#include "aisle/core/image.hpp"

namespace aisle {

/// A camera image with its title.
struct TakenPicture {
  Image picture;
  std::string title;
};

/// Images of one drive side by side, in rows of four, each with its title in its corner (L03 Fig. 7).
/// @return a PNG file
/// @throws std::invalid_argument if there is none
std::string picture_sheet_png(std::span<const TakenPicture> pictures);

}  // namespace aisle
