#include "worlds/world_fields.hpp"

#include <array>

namespace aisle {
namespace {

constexpr Range kShare = {0, 1};
constexpr Range kMeasure_m = {0.01, 1000};
constexpr Range kHeight_m = {0.01, 100};

WorldField number(std::string_view key, double& target, Range range) {
  return {.key = key, .target = &target, .range = range};
}

WorldField angle(std::string_view key, double& target_rad) {
  return {.key = key, .target = &target_rad, .range = {-360, 360}, .inner_unit = kDegree};
}

WorldField count(std::string_view key, int& target, Range range) {
  return {.key = key, .target = &target, .range = range};
}

WorldField whole_number(std::string_view key, std::uint64_t& target) {
  return {.key = key, .target = &target, .range = {}};
}

WorldField point(std::string_view key, double& x_m, double& y_m, Range range = kCoordinate_m) {
  return {.key = key, .target = PointTarget{{&x_m, &y_m}}, .range = range};
}

WorldField point(std::string_view key, Vec3& target) {
  return {.key = key, .target = PointTarget{{&target.x(), &target.y(), &target.z()}}, .range = kCoordinate_m};
}

WorldField point(std::string_view key, Vec2& target) {
  return point(key, target.x(), target.y());
}

WorldField size(std::string_view key, Vec2& target) {
  return point(key, target.x(), target.y(), kMeasure_m);
}

WorldField points(std::string_view key, std::vector<Vec2>& target) {
  return {.key = key, .target = &target, .range = kCoordinate_m};
}

WorldField text(std::string_view key, std::string& target) {
  return {.key = key, .target = &target, .range = {}};
}

/// `words` in the order of the enumeration.
template <class Kind>
WorldField word(std::string_view key, Kind& kind, std::span<const std::string_view> words) {
  return {.key = key,
          .target = WordTarget{words, [&kind] { return static_cast<std::size_t>(kind); },
                               [&kind](std::size_t index) { kind = static_cast<Kind>(index); }},
          .range = {}};
}

WorldField needed(WorldField field) {
  field.is_needed = true;
  return field;
}

constexpr std::array<std::string_view, 2> kPosterKinds = {"poster", "notice_board"};
constexpr std::array<std::string_view, 3> kFloorKinds = {"plain", "tiles", "carpet"};
constexpr std::array<std::string_view, 4> kFurnitureKinds = {"box", "table", "chair", "pillar"};

}  // namespace

WorldFields fields_of(WallLine& wall) {
  return {needed(points("line", wall.line)), number("height_m", wall.height_m, kHeight_m),
          number("brightness", wall.brightness, kShare)};
}

WorldFields fields_of(Door& door) {
  return {needed(point("hinge", door.hinge)),
          needed(angle("closed_heading_deg", door.closed_heading_rad)),
          angle("open_deg", door.open_rad),
          number("width_m", door.width_m, {0.05, 20}),
          number("height_m", door.height_m, kHeight_m),
          number("brightness", door.brightness, kShare),
          number("frame_width_m", door.frame_width_m, {0, 1}),
          number("frame_brightness", door.frame_brightness, kShare),
          number("wall_depth_m", door.wall_depth_m, {0, 5})};
}

WorldFields fields_of(Poster& poster) {
  return {word("kind", poster.kind, kPosterKinds),        needed(point("centre", poster.centre)),
          needed(angle("facing_deg", poster.facing_rad)), number("width_m", poster.width_m, kMeasure_m),
          number("height_m", poster.height_m, kHeight_m), number("bottom_m", poster.bottom_m, {0, 100})};
}

WorldFields fields_of(Lamp& lamp) {
  return {needed(point("centre", lamp.centre)), number("length_m", lamp.length_m, kMeasure_m),
          number("width_m", lamp.width_m, kMeasure_m), angle("heading_deg", lamp.heading_rad),
          number("power", lamp.power, {0, 100})};
}

WorldFields fields_of(FloorCovering& floor) {
  return {word("kind", floor.kind, kFloorKinds), number("tile_m", floor.tile_m, {0.01, 10}),
          number("brightness", floor.brightness, kShare), number("contrast", floor.contrast, kShare),
          number("gloss", floor.gloss, kShare)};
}

WorldFields fields_of(FloorPaper& paper) {
  return {needed(point("centre", paper.centre)), angle("heading_deg", paper.heading_rad),
          number("length_m", paper.length_m, kMeasure_m), number("width_m", paper.width_m, kMeasure_m),
          number("brightness", paper.brightness, kShare)};
}

WorldFields fields_of(Furniture& piece) {
  return {word("kind", piece.kind, kFurnitureKinds),
          needed(point("centre", piece.centre)),
          needed(size("size", piece.size)),
          angle("heading_deg", piece.heading_rad),
          number("height_m", piece.height_m, kHeight_m),
          number("brightness", piece.brightness, kShare)};
}

WorldFields fields_of(ParkingFrame& frame) {
  return {needed(text("name", frame.name)),
          needed(point("centre", frame.centre)),
          needed(size("size", frame.size)),
          angle("heading_deg", frame.heading_rad),
          number("line_width_m", frame.line_width_m, {0.001, 1}),
          number("brightness", frame.brightness, kShare)};
}

WorldFields fields_of(CalibrationBoard& board) {
  return {needed(point("centre", board.p_world_centre)), angle("yaw_deg", board.yaw_rad),
          angle("pitch_deg", board.pitch_rad),           angle("roll_deg", board.roll_rad),
          count("columns", board.columns, {2, 100}),     count("rows", board.rows, {2, 100}),
          number("square_m", board.square_m, {0.001, 1})};
}

WorldFields fields_of(Person& person) {
  return {needed(points("path", person.path)), number("speed_mps", person.speed_mps, {0, 10}),
          number("start_s", person.start_s, {0, 1e6}), number("radius_m", person.radius_m, {0.01, 2}),
          number("height_m", person.height_m, kHeight_m)};
}

WorldFields fields_of(NamedPlace& place) {
  WorldFields fields = fields_of(place.T_world_place);
  fields.insert(fields.begin(), needed(text("name", place.name)));
  return fields;
}

WorldFields fields_of(WorldRoute& route) {
  return {needed(text("name", route.name)), word("park", route.parking, kParkingWords),
          needed(points("path", route.path))};
}

WorldFields fields_of(TaughtTurning& turning) {
  constexpr int kTurnings = 13;
  constexpr Range kLength_m = {0, 20};
  return {needed(text("route", turning.route)), needed(count("number", turning.number, {1, kTurnings})),
          needed(point("at", turning.at)), number("before_m", turning.before_m, kLength_m),
          number("after_m", turning.after_m, kLength_m)};
}

WorldFields fields_of(Pose2& pose) {
  return {needed(point("at", pose.x, pose.y)), angle("heading_deg", pose.theta)};
}

WorldFields fields_of(World& world) {
  return {text("name", world.name),
          number("ceiling_m", world.ceiling_m, {0.1, 100}),
          number("ceiling_brightness", world.ceiling_brightness, kShare),
          number("skirting_height_m", world.skirting_height_m, {0, 10}),
          number("skirting_brightness", world.skirting_brightness, kShare),
          number("ambient_light", world.ambient_light, kShare),
          whole_number("texture_seed", world.texture_seed),
          points("tour", world.tour)};
}

}  // namespace aisle
