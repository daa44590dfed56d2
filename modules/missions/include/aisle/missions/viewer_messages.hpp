#pragma once
/// What a navigator sees and how sure it is, as JSON for the live page (docs/reference/live-server.md).
/// Sessions do not contain these messages.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/vision/floor/floor_edges.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

/// A line in an image.
struct OverlayLine {
  const char* kind = "";
  Vec2 from_px = Vec2::Zero();
  Vec2 to_px = Vec2::Zero();
};
using Overlay = std::vector<OverlayLine>;

/// Vertical lines, the floor points of landmarks as small crosses, and the stripes of the line lasers.
/// @param camera  of the image
Overlay overlay_of(const LandmarkNavigator& navigator, const VehicleDescription& vehicle,
                   const std::string& camera);
/// The wall-floor edges.
Overlay overlay_of(std::span<const FloorEdge> edges);
/// The region's outline as seen from the image's lower border, and the two scan lines.
Overlay overlay_of(const RouteView& view, const RouteSight& sight);

SessionTopic overlay_topic(const std::string& camera);
/// @param stamp_s  of the image
std::string overlay_cdr(double stamp_s, const Overlay& overlay);

/// How well the view matches the map.
struct ViewMatch {
  double quality = 0;  ///< 0 .. 1
  std::string text;    ///< "41 of 52 lines"
};

const SessionTopic& match_topic();
std::string match_cdr(double stamp_s, const ViewMatch& match);

}  // namespace aisle
