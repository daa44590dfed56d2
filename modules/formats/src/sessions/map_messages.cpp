#include "aisle/formats/sessions/map_messages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "buildings/building_parts.hpp"
#include "sessions/frame_messages.hpp"

namespace aisle {
namespace {

constexpr double kPlanEvery_m = 0.1;
constexpr double kTextHeight_m = 0.4;

constexpr ros::ColorRGBA kWallColour{0.2F, 0.2F, 0.25F, 1};
constexpr ros::ColorRGBA kLandmarkColour{0.8F, 0.3F, 0.1F, 1};
constexpr ros::ColorRGBA kGraphColour{0.1F, 0.5F, 0.8F, 1};
constexpr ros::ColorRGBA kRouteColour{0.2F, 0.6F, 0.2F, 1};
constexpr ros::ColorRGBA kKeepOutColour{0.8F, 0.2F, 0.2F, 1};
constexpr ros::ColorRGBA kGlassColour{0.2F, 0.7F, 0.85F, 1};
constexpr ros::ColorRGBA kZoneColour{0.9F, 0.55F, 0.0F, 1};
constexpr double kZoneArrow_m = 0.5;

ros::Vector3 point(const Vec2& p) {
  return {.x = p.x(), .y = p.y()};
}

ros::Pose pose_on_floor(const Pose2& T) {
  return {{.x = T.x, .y = T.y}, {.z = std::sin(T.theta / 2), .w = std::cos(T.theta / 2)}};
}

ros::Header map_header(ros::Stamp_ns stamp) {
  return {ros::time_of(stamp), kMapFrame};
}

ros::Marker marker(ros::Stamp_ns stamp, const char* name, ros::Marker::Kind kind, double width_m,
                   const ros::ColorRGBA& colour) {
  ros::Marker marker;
  marker.header = map_header(stamp);
  marker.ns = name;
  marker.type = kind;
  marker.scale = {width_m, width_m, width_m};
  marker.color = colour;
  return marker;
}

std::vector<double> plan_marks_m(const Path& path) {
  const auto count = static_cast<std::size_t>(path.length_m() / kPlanEvery_m);
  std::vector<double> marks;
  marks.reserve(count + 2);
  for (std::size_t i = 0; i <= count; ++i) marks.push_back(static_cast<double>(i) * kPlanEvery_m);
  marks.push_back(path.length_m());
  return marks;
}

ros::Marker barriers_of(const Building& building, Barrier::Kind kind, ros::Marker lines) {
  for (const Barrier& barrier : lines_not_crossed(building)) {
    if (barrier.kind != kind) continue;
    lines.points.push_back(point(barrier.segment.start));
    lines.points.push_back(point(barrier.segment.end));
  }
  return lines;
}

ros::Marker walls_of(const Building& building, ros::Stamp_ns stamp) {
  ros::Marker walls = marker(stamp, "walls", ros::Marker::kLineList, 0.04, kWallColour);
  walls.points.reserve(2 * building.walls.walls.size());
  for (const Wall& wall : building.walls.walls) {
    walls.points.push_back(point(wall.segment.start));
    walls.points.push_back(point(wall.segment.end));
  }
  return walls;
}

ros::Marker landmarks_of(const Building& building, ros::Stamp_ns stamp) {
  ros::Marker landmarks = marker(stamp, "landmarks", ros::Marker::kSphereList, 0.1, kLandmarkColour);
  landmarks.points.reserve(building.landmarks.size());
  for (const Landmark& landmark : building.landmarks.all()) landmarks.points.push_back(point(landmark.p_map));
  return landmarks;
}

/// Adds a polyline as a marker of its own.
void add_line(ros::MarkerArray& array, ros::Marker line, const std::vector<Vec2>& polyline) {
  line.id = static_cast<std::int32_t>(array.markers.size());
  line.points.reserve(polyline.size());
  for (const Vec2& p : polyline) line.points.push_back(point(p));
  array.markers.push_back(std::move(line));
}

std::vector<Vec2> polyline_of(const Path& path) {
  std::vector<Vec2> polyline;
  for (const double mark_m : plan_marks_m(path)) polyline.push_back(path.at(mark_m).T_map_path.position());
  return polyline;
}

void add_places(ros::MarkerArray& array, const Building& building, ros::Stamp_ns stamp) {
  for (const MapPlace& place : building.places) {
    ros::Marker text = marker(stamp, "places", ros::Marker::kText, kTextHeight_m, kGraphColour);
    text.id = static_cast<std::int32_t>(array.markers.size());
    text.pose = pose_on_floor(place.T_map_place);
    text.text = place.name;
    array.markers.push_back(std::move(text));
  }
}

/// Slow zones by their outline; one-way zones with an arrow in their middle, too.
void add_zones(ros::MarkerArray& array, const Building& building, ros::Stamp_ns stamp) {
  for (const Zone& zone : building.zones) {
    if (zone.kind == Zone::Kind::kKeepOut) continue;  // its outline is a line that is not crossed
    const ros::Marker line = marker(stamp, zone.kind == Zone::Kind::kSlow ? "slow" : "one_way",
                                    ros::Marker::kLineStrip, 0.04, kZoneColour);
    std::vector<Vec2> outline = zone.outline;
    outline.push_back(outline.front());
    add_line(array, line, outline);
    if (zone.kind == Zone::Kind::kSlow) continue;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : zone.outline) middle += corner / static_cast<double>(zone.outline.size());
    const Pose2 T_map_arrow{middle.x(), middle.y(), zone.direction_rad};
    add_line(array, line,
             {T_map_arrow * Vec2(-kZoneArrow_m, 0), T_map_arrow * Vec2(kZoneArrow_m, 0),
              T_map_arrow * Vec2(kZoneArrow_m / 2, kZoneArrow_m / 4),
              T_map_arrow * Vec2(kZoneArrow_m / 2, -kZoneArrow_m / 4), T_map_arrow * Vec2(kZoneArrow_m, 0)});
  }
}

std::int8_t occupancy(Floor floor) {
  if (floor == Floor::kUnknown) return -1;
  return floor == Floor::kOccupied ? 100 : 0;
}

}  // namespace

const SessionTopic& pose_topic() {
  static const SessionTopic topic{"/pose", ros::PoseWithCovarianceStamped::kType};
  return topic;
}

std::string pose_cdr(ros::Stamp_ns stamp, const UncertainPose2& T_map_vehicle) {
  ros::PoseWithCovarianceStamped message{map_header(stamp), {pose_on_floor(T_map_vehicle.mean), {}}};
  constexpr std::array<std::size_t, 3> kRow{0, 1, 5};  // x, y and the rotation about z of six
  for (std::size_t i = 0; i < kRow.size(); ++i) {
    for (std::size_t j = 0; j < kRow.size(); ++j)
      message.pose.covariance[6 * kRow[i] + kRow[j]] =
          T_map_vehicle.covariance(static_cast<int>(i), static_cast<int>(j));
  }
  return cdr_bytes(message);
}

const SessionTopic& plan_topic() {
  static const SessionTopic topic{"/plan", ros::Path::kType};
  return topic;
}

std::string plan_cdr(ros::Stamp_ns stamp, const Path& path) {
  ros::Path message{map_header(stamp), {}};
  if (path.empty()) return cdr_bytes(message);
  for (const double mark_m : plan_marks_m(path))
    message.poses.push_back({map_header(stamp), pose_on_floor(path.at(mark_m).T_map_path)});
  return cdr_bytes(message);
}

const SessionTopic& map_topic() {
  static const SessionTopic topic{"/map", ros::MarkerArray::kType, true};
  return topic;
}

std::string map_cdr(ros::Stamp_ns stamp, const Building& building) {
  ros::MarkerArray array{{walls_of(building, stamp), landmarks_of(building, stamp)}};
  for (const Corridor& corridor : building.corridors.corridors)
    add_line(array, marker(stamp, "graph", ros::Marker::kLineStrip, 0.05, kGraphColour), corridor.path);
  for (const Route& route : building.routes)
    add_line(array, marker(stamp, "routes", ros::Marker::kLineStrip, 0.05, kRouteColour),
             polyline_of(route.path));
  add_places(array, building, stamp);
  array.markers.push_back(
      barriers_of(building, Barrier::Kind::kKeepOut,
                  marker(stamp, "keep_out", ros::Marker::kLineList, 0.06, kKeepOutColour)));
  array.markers.push_back(barriers_of(building, Barrier::Kind::kGlass,
                                      marker(stamp, "glass", ros::Marker::kLineList, 0.06, kGlassColour)));
  add_zones(array, building, stamp);
  return cdr_bytes(array);
}

const SessionTopic& floor_topic() {
  static const SessionTopic topic{"/floor", ros::String::kType, true};
  return topic;
}

std::string floor_cdr(const FloorGrid& floor) {
  return cdr_bytes(ros::String{floor_json(floor)});
}

const SessionTopic& grid_topic() {
  static const SessionTopic topic{"/grid", ros::OccupancyGrid::kType, true};
  return topic;
}

std::string grid_cdr(ros::Stamp_ns stamp, const FloorGrid& floor) {
  const FloorBox& box = floor.known();
  ros::OccupancyGrid grid;
  grid.header = map_header(stamp);
  grid.info.map_load_time = grid.header.stamp;
  grid.info.resolution = static_cast<float>(floor.cell_m());
  if (box.empty()) return cdr_bytes(grid);
  grid.info.width = static_cast<std::uint32_t>(box.end.x - box.low.x);
  grid.info.height = static_cast<std::uint32_t>(box.end.y - box.low.y);
  grid.info.origin.position = {.x = box.low.x * floor.cell_m(), .y = box.low.y * floor.cell_m()};
  grid.data.reserve(std::size_t{grid.info.width} * grid.info.height);
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) grid.data.push_back(occupancy(floor.at(FloorCell{x, y})));
  }
  return cdr_bytes(grid);
}

}  // namespace aisle
