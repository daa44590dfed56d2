#include "worlds/world_fields.hpp"

#include <array>

namespace aisle {
namespace {

constexpr Range kShare = {0, 1};
constexpr Range kMeasure_m = {0.01, 1000};
constexpr Range kHeight_m = {0.01, 100};

ObjectField point(std::string_view key, Vec2& target) {
  return field::point(key, target, kCoordinate_m);
}

ObjectField size(std::string_view key, Vec2& target) {
  return field::point(key, target, kMeasure_m);
}

constexpr std::array<std::string_view, 2> kPosterKinds = {"poster", "notice_board"};
constexpr std::array<std::string_view, 3> kFloorKinds = {"plain", "tiles", "carpet"};
constexpr std::array<std::string_view, 4> kFurnitureKinds = {"box", "table", "chair", "pillar"};

}  // namespace

ObjectFields fields_of(WallLine& wall) {
  return {needed(field::points("line", wall.line, kCoordinate_m)),
          field::number("height_m", wall.height_m, kHeight_m),
          field::number("brightness", wall.brightness, kShare),
          field::number("returns", wall.returns, kShare)};
}

ObjectFields fields_of(Door& door) {
  return {needed(point("hinge", door.hinge)),
          needed(field::angle("closed_heading_deg", door.closed_heading_rad)),
          field::angle("open_deg", door.open_rad),
          field::number("width_m", door.width_m, {0.05, 20}),
          field::number("height_m", door.height_m, kHeight_m),
          field::number("brightness", door.brightness, kShare),
          field::number("frame_width_m", door.frame_width_m, {0, 1}),
          field::number("frame_brightness", door.frame_brightness, kShare),
          field::number("wall_depth_m", door.wall_depth_m, {0, 5})};
}

ObjectFields fields_of(Poster& poster) {
  return {field::word("kind", poster.kind, kPosterKinds),
          needed(point("centre", poster.centre)),
          needed(field::angle("facing_deg", poster.facing_rad)),
          field::number("width_m", poster.width_m, kMeasure_m),
          field::number("height_m", poster.height_m, kHeight_m),
          field::number("bottom_m", poster.bottom_m, {0, 100})};
}

ObjectFields fields_of(Lamp& lamp) {
  return {needed(point("centre", lamp.centre)), field::number("length_m", lamp.length_m, kMeasure_m),
          field::number("width_m", lamp.width_m, kMeasure_m), field::angle("heading_deg", lamp.heading_rad),
          field::number("power", lamp.power, {0, 100})};
}

ObjectFields fields_of(FloorCovering& floor) {
  return {field::word("kind", floor.kind, kFloorKinds), field::number("tile_m", floor.tile_m, {0.01, 10}),
          field::number("brightness", floor.brightness, kShare),
          field::number("contrast", floor.contrast, kShare), field::number("gloss", floor.gloss, kShare)};
}

ObjectFields fields_of(FloorPaper& paper) {
  return {needed(point("centre", paper.centre)), field::angle("heading_deg", paper.heading_rad),
          field::number("length_m", paper.length_m, kMeasure_m),
          field::number("width_m", paper.width_m, kMeasure_m),
          field::number("brightness", paper.brightness, kShare)};
}

ObjectFields fields_of(Furniture& piece) {
  return {field::word("kind", piece.kind, kFurnitureKinds),
          needed(point("centre", piece.centre)),
          needed(size("size", piece.size)),
          field::angle("heading_deg", piece.heading_rad),
          field::number("height_m", piece.height_m, kHeight_m),
          field::number("brightness", piece.brightness, kShare),
          field::number("returns", piece.returns, kShare)};
}

ObjectFields fields_of(ParkingFrame& frame) {
  return {needed(field::text("name", frame.name)),
          needed(point("centre", frame.centre)),
          needed(size("size", frame.size)),
          field::angle("heading_deg", frame.heading_rad),
          field::number("line_width_m", frame.line_width_m, {0.001, 1}),
          field::number("brightness", frame.brightness, kShare)};
}

ObjectFields fields_of(CalibrationBoard& board) {
  return {needed(field::point("centre", board.p_world_centre, kCoordinate_m)),
          field::angle("yaw_deg", board.yaw_rad),
          field::angle("pitch_deg", board.pitch_rad),
          field::angle("roll_deg", board.roll_rad),
          field::count("columns", board.columns, {2, 100}),
          field::count("rows", board.rows, {2, 100}),
          field::number("square_m", board.square_m, {0.001, 1})};
}

ObjectFields fields_of(Person& person) {
  return {needed(field::points("path", person.path, kCoordinate_m)),
          field::number("speed_mps", person.speed_mps, {0, 10}),
          field::number("start_s", person.start_s, {0, 1e6}),
          field::number("radius_m", person.radius_m, {0.01, 2}),
          field::number("height_m", person.height_m, kHeight_m)};
}

ObjectFields fields_of(NamedPlace& place) {
  ObjectFields fields = fields_of(place.T_world_place);
  fields.insert(fields.begin(), needed(field::text("name", place.name)));
  return fields;
}

ObjectFields fields_of(WorldRoute& route) {
  return {needed(field::text("name", route.name)), field::word("park", route.parking, kParkingWords),
          needed(field::points("path", route.path, kCoordinate_m))};
}

ObjectFields fields_of(TaughtTurning& turning) {
  constexpr Range kLength_m = {0, 20};
  return {needed(field::text("route", turning.route)),
          needed(field::count("number", turning.number, {1, kTurningNumbers})),
          needed(point("at", turning.at)), field::number("before_m", turning.before_m, kLength_m),
          field::number("after_m", turning.after_m, kLength_m)};
}

ObjectFields fields_of(Pose2& pose) {
  return {needed(field::point("at", pose.x, pose.y, kCoordinate_m)), field::angle("heading_deg", pose.theta)};
}

ObjectFields fields_of(World& world) {
  return {field::text("name", world.name),
          field::number("ceiling_m", world.ceiling_m, {0.1, 100}),
          field::number("ceiling_brightness", world.ceiling_brightness, kShare),
          field::number("skirting_height_m", world.skirting_height_m, {0, 10}),
          field::number("skirting_brightness", world.skirting_brightness, kShare),
          field::number("ambient_light", world.ambient_light, kShare),
          field::whole_number("texture_seed", world.texture_seed),
          field::points("tour", world.tour, kCoordinate_m)};
}

}  // namespace aisle
