#pragma once

#include <span>
#include <string>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/landmark_map.hpp"
#include "aisle/maps/route.hpp"

namespace aisle {

/// The landmarks learned in a corridor and how it was driven (C98 Figs. 11 and 12). Everything is in `map`
/// [m]; all but the landmarks may be left out. Landmarks of weight 1 and more are crosses, weaker ones dots;
/// the size of both grows with their certainty. Drawn to scale, y up, the longer side 1600 px.
struct LandmarkPicture {
  const LandmarkMap& landmarks;
  std::span<const Route> routes = {};  ///< planned: grey lines with a ring where they start
  std::span<const std::vector<Pose2>> driven =
      {};                                     ///< base_link run by run: black squares at equal distances
  std::span<const Vec2> seen = {};            ///< floor points of lines as seen: small dots; far
                                              ///< outliers are left out
  std::span<const Segment2> true_walls = {};  ///< of a simulated world; the legend says so
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const LandmarkPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const LandmarkPicture& picture);

}  // namespace aisle
