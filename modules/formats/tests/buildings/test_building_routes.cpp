#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "building_texts.hpp"
#include "learned_routes.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::string routes_with(const std::string& passage, const std::string& other) {
  return golden_building("building_routes.v1.json", passage, other);
}

/// A nearly straight route of 1 km in which every piece is rounded in the same direction.
Path long_path(const Arc& arc) {
  std::vector<PathPiece> pieces;
  Pose2 T_map_piece{1, 2, 0.3};
  for (int i = 0; i < 10000; ++i) {
    pieces.push_back({T_map_piece, arc});
    T_map_piece = pieces.back().end();
  }
  return Path(std::move(pieces));
}

TEST(BuildingRoutes, TheGoldenFileSaysWhatWasLearned) {
  const auto building = parse_building(golden_building("building_routes.v1.json"), "golden");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  ASSERT_TRUE(building->camera);
  EXPECT_EQ(building->camera->name, "corridor");
  EXPECT_EQ(building->camera->intrinsics.fy_px, 460.5);
  EXPECT_NEAR(building->camera->mount.tilt_rad, 14 * kDegree, 1e-12);
  ASSERT_EQ(building->landmarks.size(), 2U);
  const Landmark& landmark = building->landmarks[0];
  EXPECT_THAT(landmark.p_map, PointNear(Vec2(3.125, 1.05), 0));
  EXPECT_NEAR(landmark.covariance(0, 0), 0.0213 * 0.0213, 1e-12);
  EXPECT_NEAR(landmark.covariance(0, 1), -0.25 * 0.0213 * 0.008, 1e-12);
  EXPECT_NEAR(landmark.covariance(1, 1), 0.008 * 0.008, 1e-12);
  EXPECT_EQ(landmark.mass, 41.5);
  EXPECT_EQ(landmark.weight, 1.25);
  EXPECT_EQ(landmark.sightings, 38);
  EXPECT_EQ(landmark.passes, 2);
  EXPECT_THAT(landmark.seen_from, PointNear(unit(-172 * kDegree), 1e-12));
  EXPECT_EQ(landmark.seen_near_m, 1.85);
  EXPECT_EQ(landmark.seen_far_m, 6.5);
  EXPECT_TRUE(landmark.brighter_right);
  EXPECT_FALSE(building->landmarks[1].brighter_right);
  ASSERT_THAT(building->routes, SizeIs(2));
  const Route& route = building->routes[0];
  EXPECT_EQ(route.name, "desk to stairs");
  ASSERT_THAT(route.path.pieces(), SizeIs(4));
  EXPECT_THAT(route.path.at(0).T_map_path, PoseNear(Pose2{0, -0.25, 1.5 * kDegree}, 1e-9, 1e-9));
  EXPECT_NEAR(route.path.length_m(), 4 + kPi / 2 + 0.5, 1e-6);
  EXPECT_TRUE(route.path.pieces()[2].is_on_the_spot());
  ASSERT_THAT(route.start_view, SizeIs(1));
  EXPECT_THAT(route.start_view[0].p_vehicle, PointNear(Vec2(3.158, 1.218), 0));
  EXPECT_TRUE(route.start_view[0].brighter_right);
}

RC_GTEST_PROP(BuildingRoutes, WhatIsReadIsWrittenAgainToTheLastByte, (std::uint64_t seed)) {
  Random random(seed);
  Building building = any_learned_building(random, 20, 4, 30);
  if (random.uniform() < 0.5) building.landmarks = with_views(building.landmarks, random);
  const std::string written = building_json(building);
  const auto read = parse_building(written, "written");
  RC_ASSERT(read.ok());
  RC_ASSERT(building_json(*read) == written);
}

RC_GTEST_PROP(BuildingRoutes, RoutesAreReadWhereTheyWere, (std::uint64_t seed)) {
  Random random(seed);
  const Building building = any_learned_building(random, 1, 2, 40);
  const auto read = parse_building(building_json(building), "written");
  RC_ASSERT(read.ok());
  for (std::size_t i = 0; i < building.routes.size(); ++i) {
    const Path &was = building.routes[i].path, &is = read->routes[i].path;
    RC_ASSERT(is.pieces().size() == was.pieces().size());
    RC_ASSERT(read->routes[i].name == building.routes[i].name);
    for (std::size_t j = 0; j < was.pieces().size(); ++j) {
      const Pose2 a = was.pieces()[j].T_map_start, b = is.pieces()[j].T_map_start;
      RC_ASSERT((a.position() - b.position()).norm() < 1e-4);
      RC_ASSERT(std::abs(wrap_angle(a.theta - b.theta)) < 1e-6);
    }
  }
}

TEST(BuildingRoutes, AKilometreEndsWithinAMillimetreHoweverItsPiecesAreRounded) {
  for (const Arc& arc :
       {Arc{0.10000004999, 0.00000000499 * kDegree}, Arc{0.09999995001, 0.03600000499 * kDegree}}) {
    Building building;
    building.routes.push_back({.name = "far", .path = long_path(arc), .start_view = {}});
    const auto read = parse_building(building_json(building), "far");
    ASSERT_TRUE(read.ok()) << to_string(read.problems());
    const Pose2 end = building.routes[0].path.end();
    EXPECT_THAT(read->routes[0].path.end(), PoseNear(end, 0.001, 0.01 * kDegree));
  }
}

TEST(BuildingRoutes, AHundredMetresOfCorridorAreSmall) {
  Random random(1);
  EXPECT_LE(building_json(any_learned_building(random, 250, 1, 120)).size(), 50000U);
}

TEST(BuildingRoutes, AHundredMetresThatWereLearnedAreSmallWithTheirViewsToo) {
  constexpr int kLandmarks = 500, kPieces = 15;  // c98-corridor, 20 m, has 99 and 1 when it was taught once
  Random random(1);
  Building building = any_learned_building(random, kLandmarks, 1, kPieces);
  building.landmarks = with_views(building.landmarks, random);
  EXPECT_LE(building_json(building).size(), 50000U);
}

TEST(BuildingRoutes, LandmarksThatVanishedAndPiecesThatRoundToNothingAreNotWritten) {
  Random random(1);
  Building building = any_learned_building(random, 3, 0, 0);
  building.landmarks.remove(1);
  const PathPiece metre{{}, {1, 0}}, speck{metre.end(), {1e-9, 0}};
  building.routes.push_back({.name = "r", .path = Path({metre, speck}), .start_view = {}});
  const auto read = parse_building(building_json(building), "written");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_EQ(read->landmarks.size(), 2U);
  EXPECT_THAT(read->routes[0].path.pieces(), SizeIs(1));
}

TEST(BuildingRoutes, ARouteWithoutNameOrLengthIsNotWritten) {
  Building building;
  building.routes.push_back({.name = "r", .path = {}, .start_view = {}});
  EXPECT_THROW((void)building_json(building), std::invalid_argument);
  building.routes[0] = {.name = "", .path = Path({PathPiece{{}, {1, 0}}}), .start_view = {}};
  EXPECT_THROW((void)building_json(building), std::invalid_argument);
}

TEST(BuildingRoutes, LandmarksNeedTheirCamera) {
  EXPECT_THAT(building_problems(R"({"format": "aisle.building", "version": 1,
                           "landmarks": [{"at_m": [1, 2], "sigma_m": [0.1, 0.1], "brighter": "left"}]})"),
              HasSubstr("camera: is missing"));
}

TEST(BuildingRoutes, BadLandmarksNameTheirKeys) {
  EXPECT_THAT(building_problems(routes_with("\"correlation\": -0.25", "\"correlation\": 1")),
              HasSubstr("b.json: landmarks[0].correlation: is not a number from -0.9999 to 0.9999"));
  EXPECT_THAT(building_problems(routes_with("[0.0213, 0.008]", "[0, -1]")),
              AllOf(HasSubstr("landmarks[0].sigma_m[0]: is not a number from 1e-06"),
                    HasSubstr("landmarks[0].sigma_m[1]: is not a number")));
  EXPECT_THAT(building_problems(routes_with("\"weight\": 0.5", "\"weight\": 0")),
              HasSubstr("landmarks[1].weight: is not"));
  EXPECT_THAT(building_problems(routes_with("\"mass\": 9", "\"mass\": -9")),
              HasSubstr("landmarks[1].mass: is not"));
  EXPECT_THAT(building_problems(routes_with("\"brighter\": \"right\"", "\"brighter\": \"up\"")),
              HasSubstr("landmarks[0].brighter: is neither \"right\" nor \"left\""));
  EXPECT_THAT(building_problems(routes_with("[1.85, 6.5]", "[6.5, 1.85]")),
              HasSubstr("landmarks[0].seen_from_m[1]: is not a number from 6.5 to 1000"));
  EXPECT_THAT(building_problems(routes_with("\"passes\": 2", "\"pases\": 2")),
              HasSubstr("landmarks[0].pases: unknown key"));
  EXPECT_THAT(building_problems(routes_with("\"at_m\": [3.125, 1.05], ", "")),
              HasSubstr("landmarks[0].at_m: is missing"));
}

/// A building with its landmarks in a table.
std::string problems_of_table(const std::string& columns, const std::string& rows) {
  return building_problems(routes_with(R"([
{"at_m": [3.125, 1.05], "sigma_m": [0.0213, 0.008], "correlation": -0.25, "mass": 41.5, "weight": 1.25, "sightings": 38, "passes": 2, "seen_from_deg": -172, "seen_from_m": [1.85, 6.5], "brighter": "right"},
{"at_m": [4.025, -1.05], "sigma_m": [0.03, 0.012], "correlation": 0, "mass": 9, "weight": 0.5, "sightings": 12, "passes": 1, "brighter": "left"}
])",
                                       R"({"columns": )" + columns + R"(, "rows": )" + rows + "}"));
}

TEST(BuildingRoutes, ATableHasItsColumnsInAnyOrderAndNullWhereNothingIsKnown) {
  EXPECT_EQ(problems_of_table(R"(["brighter", "sigma_m", "mass", "at_m"])",
                              R"([["left", [0.1, 0.1], null, [1, 2]], ["right", [0.1, 0.1], 3, [1, 2]]])"),
            "");
}

TEST(BuildingRoutes, BadTablesNameTheirRows) {
  EXPECT_THAT(problems_of_table(R"(["at_m", "sigma_m", "bright"])", R"([[[1, 2], [0.1, 0.1], "left"]])"),
              AllOf(HasSubstr("landmarks.rows[0].bright: unknown key"),
                    HasSubstr("landmarks.rows[0].brighter: is missing")));
  EXPECT_THAT(
      problems_of_table(R"(["at_m", "sigma_m", "brighter"])", R"([[[1, 2], null, "left"], [[1, 2]], 7])"),
      AllOf(HasSubstr("landmarks.rows[0].sigma_m: is missing"),
            HasSubstr("landmarks.rows[1]: is not a list of 3"),
            HasSubstr("landmarks.rows[2]: is not a list of 3")));
  EXPECT_THAT(problems_of_table(R"([1, "at_m"])", R"([])"), HasSubstr("landmarks.columns[0]: is not a text"));
  EXPECT_THAT(problems_of_table(R"({})", R"([])"), HasSubstr("landmarks.columns: is not a list"));
  EXPECT_THAT(building_problems(R"({"format": "aisle.building", "version": 2, "landmarks": {"row": []}})"),
              AllOf(HasSubstr("landmarks.row: unknown key"), HasSubstr("landmarks.columns: is missing"),
                    HasSubstr("landmarks.rows: is missing")));
}

TEST(BuildingRoutes, ABadCameraNamesItsKeys) {
  EXPECT_THAT(building_problems(routes_with("\"fx_px\": 460", "\"fx_px\": 0")),
              HasSubstr("camera.fx_px: is not a number from 1 to 100000"));
  EXPECT_THAT(building_problems(routes_with("\"width_px\": 640", "\"width_px\": 1e9")),
              HasSubstr("camera.width_px: is not a whole number from 16 to 8192"));
  EXPECT_THAT(building_problems(routes_with("\"tilt_deg\": 14, ", "")),
              HasSubstr("camera.tilt_deg: is missing"));
  EXPECT_THAT(building_problems(routes_with("\"name\": \"corridor\"", "\"name\": \"\"")),
              HasSubstr("camera.name: is not a text of 1 to 200 bytes"));
}

TEST(BuildingRoutes, BadRoutesNameTheirKeys) {
  EXPECT_THAT(building_problems(routes_with("stairs to desk", "desk to stairs")),
              HasSubstr("routes[1].name: is the name of routes[0] too"));
  EXPECT_THAT(building_problems(routes_with("stairs to desk", "")),
              HasSubstr("routes[1].name: is not a text of 1"));
  EXPECT_THAT(building_problems(routes_with("\"length_m\": 5,", "\"length_m\": 0,")),
              HasSubstr("routes[1].pieces: have no piece of a millimetre or more"));
  EXPECT_THAT(building_problems(routes_with("\"length_m\": 5,", "\"length_m\": 1e6,")),
              HasSubstr("routes[1].pieces[0].length_m: is not a number from -100000 to 100000"));
  EXPECT_THAT(building_problems(routes_with("\"length_m\": 4,", "\"length_m\": 99999,")),
              HasSubstr("routes[0].pieces: are longer than 100000 m in total"));
  EXPECT_THAT(building_problems(routes_with("\"turn_deg\": 12.5", "\"turn_deg\": \"left\"")),
              HasSubstr("routes[1].pieces[0].turn_deg: is not a number"));
  EXPECT_THAT(building_problems(routes_with("\"heading_deg\": -180", "\"heading_deg\": 1000")),
              HasSubstr("routes[1].start.heading_deg: is not a number from -360 to 360"));
  EXPECT_THAT(building_problems(routes_with(R"([
{"at_m": [3.158, 1.218], "brighter": "right"}
])",
                                            R"([{"at_m": [1]}, 7])")),
              AllOf(HasSubstr("routes[0].start_view[0].at_m: is not a list of 2"),
                    HasSubstr("routes[0].start_view[0].brighter: is missing"),
                    HasSubstr("routes[0].start_view[1]: is not an object")));
}

TEST(BuildingRoutes, AListThatIsTooLongIsRefusedUnread) {
  std::string pieces = "[7";
  for (int i = 0; i < 100000; ++i) pieces += ",7";
  EXPECT_THAT(building_problems(routes_with("[\n{\"length_m\": 5, \"turn_deg\": 12.5}\n]", pieces + "]")),
              AllOf(HasSubstr("routes[1].pieces: has more than 100000 elements"), Not(HasSubstr("object"))));
}

}  // namespace
}  // namespace aisle
