#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "aisle/core/angle.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/vision/places/column_view.hpp"
#include "building_texts.hpp"

namespace aisle {
namespace {

using nlohmann::json;
using testing::Gt;
using testing::HasSubstr;

RoomRoute framed_room() {
  RoomRoute room;
  room.brightness = {150.25, 2.5};
  room.turnings = {{5, 0.5, 0.75}, {13, 0.5, 1}};
  room.parking = ParkingStrategy::kFrame;
  room.frame_size_m = {1.2, 0.8};
  room.edges = {{0.25, {1, -0.5}}, {0.5, {1.125, 0.5}}};
  return room;
}

RoomRoute room_with_views() {
  RoomRoute room;
  Image columns(kViewColumns, kViewBands);
  for (std::size_t i = 0; i < columns.bytes.size(); ++i) columns.bytes[i] = static_cast<std::uint8_t>(i * 7);
  room.views.push_back({0.25, {{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 1}, columns}});
  room.views.push_back({-0.125, {}});
  return room;
}

void add_routes(Building& building) {
  const Pose2 T_map_start{1, 2, 179.999999999 * kDegree};
  Route framed{.name = "by pieces", .path = Path({PathPiece{T_map_start, {1, 0.5}}}), .start_view = {}};
  framed.start_view.push_back({{3.125, -1}, true});
  framed.room = framed_room();
  Route seen{.name = "by sections", .path = {}, .start_view = {}};
  for (const char* const line : {"a 2 right 0.55", "l 36", "d 0.9", "l 36", "a 2 right 0.4"})
    seen.sections.push_back(*parse_section(line));
  seen.path = path_of(seen.sections, T_map_start);
  seen.room = room_with_views();
  building.routes = {framed, seen};
}

/// Has every part, and every key of each.
Building whole_building() {
  Building building{.name = "whole \"building\""};
  building.has_dominant_direction = true;
  building.walls.walls.push_back(
      {{{0, 0}, {12.3456, 0}}, true, WallEnd::kSeen, WallEnd::kUnknown, 17, 0.0125});
  building.camera.emplace().name = "corridor";
  building.camera->intrinsics = {.k1 = 0.1, .model = LensModel::kEquidistant, .k4 = -0.01};
  Landmark landmark{.p_map = {3.125, -1.05}, .mass = 41.512345, .weight = 1.25, .sightings = 38, .passes = 2};
  landmark.covariance << 0.0004, -0.0001, -0.0001, 0.0009;
  landmark.seen_from = unit(-172 * kDegree);
  landmark.seen_near_m = 1.85;
  landmark.seen_far_m = 6.5;
  building.landmarks.add(landmark);
  building.wall_directions.push_back({{0, -0.25}, 1.35 * kDegree, 0.15 * kDegree});
  add_routes(building);
  building.corridors.nodes = {{CorridorNode::Kind::kEnd, {0, 0}}, {CorridorNode::Kind::kRound, {3, 4}}};
  building.corridors.corridors.push_back({0, 1, {{0, 0}, {3, 4}}, 2.05});
  building.places.push_back({"lift", {4, 6, 179.99999 * kDegree}});
  building.barriers.push_back({Barrier::Kind::kGlass, {{4.8, 2}, {4.8, 3.525}}});
  building.zones.push_back({.kind = Zone::Kind::kSlow,
                            .name = "door",
                            .outline = {{1, 0}, {2, 0}, {2, 1}},
                            .speed_max_mps = 0.25});
  building.zones.push_back(
      {.kind = Zone::Kind::kOneWay, .outline = {{3, 0}, {4, 0}, {4, 1}}, .direction_rad = kPi / 2});
  building.floor.emplace(0.05).set(FloorCell{-2, 7}, Floor::kOccupied);
  return building;
}

/// A key of some object of a document.
struct KeyPlace {
  json::json_pointer object;
  std::string path;  ///< of the object, as problems name it
  std::string key;
};

/// The keys of all objects in `value`, which is at `pointer`.
void find_keys(const json& value, const json::json_pointer& pointer, const std::string& path,
               std::vector<KeyPlace>& found) {
  for (const auto& [key, inner] : value.items()) {
    if (value.is_array()) {
      find_keys(inner, pointer / std::stoul(key), fmt::format("{}[{}]", path, key), found);
    } else if (value.is_object()) {
      found.push_back({pointer, path, key});
      find_keys(inner, pointer / key, path.empty() ? key : path + "." + key, found);
    }
  }
}

std::vector<KeyPlace> keys_of_document(const json& document) {
  std::vector<KeyPlace> found;
  find_keys(document, json::json_pointer(), "", found);
  return found;
}

TEST(BuildingFields, EveryPartIsReadAndWrittenAgainToTheLastByte) {
  const std::string written = building_json(whole_building());
  const auto read = parse_building(written, "written");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_EQ(building_json(*read), written);
}

TEST(BuildingFields, EveryKeyUnderANameNearbyIsRefusedWithItsPlace) {
  const json document = json::parse(building_json(whole_building()));
  const std::vector<KeyPlace> keys = keys_of_document(document);
  ASSERT_THAT(keys.size(), Gt(90U));
  for (const KeyPlace& place : keys) {
    if (place.path.empty() && place.key == "format") continue;  // without it, it is no building at all
    json misspelt = document;
    json& object = misspelt[place.object];
    object[place.key + "x"] = object[place.key];
    object.erase(place.key);
    const std::string dot = place.path.empty() ? "" : ".";
    EXPECT_THAT(building_problems(misspelt.dump()),
                HasSubstr(fmt::format("b.json: {}{}{}x: unknown key", place.path, dot, place.key)));
  }
}

TEST(BuildingFields, EveryColumnUnderANameNearbyIsRefusedWithItsPlace) {
  const json document = json::parse(building_json(whole_building()));
  const json& columns = document["landmarks"]["columns"];
  ASSERT_THAT(columns.size(), 10U);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string other = columns[i].get<std::string>() + "x";
    json misspelt = document;
    misspelt["landmarks"]["columns"][i] = other;
    EXPECT_THAT(building_problems(misspelt.dump()),
                HasSubstr(fmt::format("b.json: landmarks.rows[0].{}: unknown key", other)));
  }
}

TEST(BuildingFields, AKeyUnderItsFormerNameIsReadAndUnderBothRefused) {
  json document = json::parse(building_json(whole_building()));
  json& corridor = document["corridors"]["corridors"][0];
  corridor["way_m"] = corridor["path_m"];
  EXPECT_THAT(building_problems(document.dump()),
              HasSubstr("corridors.corridors[0].way_m: is the former name of `path_m`, which is there too"));
  corridor.erase("path_m");
  EXPECT_EQ(building_problems(document.dump()), "");
}

TEST(BuildingFields, WithoutNodesACorridorHasNone) {
  json document = json::parse(building_json(whole_building()));
  document["corridors"]["nodes"] = json::array();
  EXPECT_THAT(building_problems(document.dump()),
              HasSubstr("corridors.corridors[0].from: is no node: there are none"));
}

}  // namespace
}  // namespace aisle
