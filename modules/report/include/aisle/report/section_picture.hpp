#pragma once

#include <span>
#include <string>

#include "aisle/maps/route.hpp"

namespace aisle {

/// A route with its sections, each in the colour of its kind and marked with its letter (L03 Fig. 4).
struct SectionPicture {
  const Route& route;                  ///< with sections
  std::span<const Pose2> driven = {};  ///< a thin line
  std::string driven_as = "as taught";
  std::string title = {};
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const SectionPicture& picture);

}  // namespace aisle
