#include "aisle/missions/viewer_messages.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {
namespace {

using ViewerJson = nlohmann::ordered_json;

std::string text_cdr(const ViewerJson& json) {
  return cdr_bytes(ros::String{json.dump()});
}

/// Laser light on objects, as dashes.
void append_light(Overlay& overlay, std::span<const Vec2> p_vehicle_returns, const CameraDescription& camera,
                  double height_m) {
  const Vec2 lateral(3, 0);
  const CameraModel model(camera.intrinsics);
  for (const Vec2& p : p_vehicle_returns) {
    const auto pixel = model.project(camera.mount.to_camera({p.x(), p.y(), height_m}));
    if (pixel) overlay.push_back({"stripe", *pixel - lateral, *pixel + lateral});
  }
}

/// The lowest row of a column that is not on the route; nullopt if that is the bottom row.
std::optional<int> top_of(const Image& mask, int u) {
  int v = mask.height_px - 1;
  while (v >= 0 && mask.row(v)[u] != 0) --v;
  return v == mask.height_px - 1 ? std::nullopt : std::optional(v);
}

}  // namespace

Overlay overlay_of(const LandmarkNavigator& navigator, const VehicleDescription& vehicle,
                   const std::string& camera) {
  const Vec2 lateral(7, 0), up(0, 7);
  Overlay overlay;
  for (const VerticalLine& line : navigator.lines())
    overlay.push_back({"vertical line", line.top_px, line.bottom_px});
  for (const LandmarkSighting& sighting : navigator.sightings()) {
    overlay.push_back({"foot", sighting.floor_point_px - lateral, sighting.floor_point_px + lateral});
    overlay.push_back({"foot", sighting.floor_point_px - up, sighting.floor_point_px + up});
  }
  if (const CameraDescription* eye = vehicle.camera(camera); eye != nullptr && vehicle.laser_markers)
    append_light(overlay, navigator.p_vehicle_returns(), *eye, vehicle.laser_markers->height_m);
  return overlay;
}

Overlay overlay_of(std::span<const FloorEdge> edges) {
  Overlay overlay;
  overlay.reserve(edges.size());
  for (const FloorEdge& edge : edges) overlay.push_back({"base line", edge.start_px, edge.end_px});
  return overlay;
}

Overlay overlay_of(const RouteView& view, const RouteSight& sight) {
  constexpr int kEvery_px = 8;
  const int right = sight.mask.width_px - 1;
  Overlay overlay;
  overlay.push_back({"scan line", Vec2(0, view.far_row()), Vec2(right, view.far_row())});
  overlay.push_back({"scan line", Vec2(0, view.near_row()), Vec2(right, view.near_row())});
  std::optional<Vec2> last;
  for (int u = 0; u <= right; u += kEvery_px) {
    const auto v = top_of(sight.mask, u);
    const auto here = v ? std::optional<Vec2>(Vec2(u, *v)) : std::nullopt;
    if (last && here) overlay.push_back({"region", *last, *here});
    last = here;
  }
  return overlay;
}

SessionTopic overlay_topic(const std::string& camera) {
  return {"/overlay/" + camera, ros::String::kType};
}

std::string overlay_cdr(double stamp_s, const Overlay& overlay) {
  ViewerJson lines = ViewerJson::array();
  for (const auto& [kind, from_px, to_px] : overlay) {
    lines.push_back({{"kind", kind},
                     {"u0", rounded(from_px.x(), 1)},
                     {"v0", rounded(from_px.y(), 1)},
                     {"u1", rounded(to_px.x(), 1)},
                     {"v1", rounded(to_px.y(), 1)}});
  }
  return text_cdr({{"stamp_s", stamp_s}, {"lines", std::move(lines)}});
}

const SessionTopic& match_topic() {
  static const SessionTopic topic{"/match", ros::String::kType};
  return topic;
}

std::string match_cdr(double stamp_s, const ViewMatch& match) {
  return text_cdr({{"stamp_s", stamp_s}, {"quality", rounded(match.quality, 3)}, {"text", match.text}});
}

}  // namespace aisle
