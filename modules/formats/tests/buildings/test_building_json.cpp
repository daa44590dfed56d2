#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "building_texts.hpp"
#include "golden_files.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

const std::filesystem::path kGoldenWalls = kGolden / "building.v3.json";
const std::filesystem::path kGoldenRoutes = kGolden / "building_routes.v3.json";

/// A building of version 1 with these additional members.
std::string building_with(const std::string& members) {
  return R"({"format": "aisle.building", "version": 1, )" + members + "}";
}

Building any_building(Random& random, std::size_t walls) {
  Building building;
  building.name = "any";
  building.has_dominant_direction = random.uniform() < 0.5;
  const auto end = [&] { return random.uniform() < 0.5 ? WallEnd::kSeen : WallEnd::kUnknown; };
  for (std::size_t i = 0; i < walls; ++i) {
    Wall wall;
    wall.segment = {{random.uniform(-99, 99), random.uniform(-99, 99)},
                    {random.uniform(-99, 99), random.uniform(-99, 99)}};
    wall.is_orthogonal = random.uniform() < 0.5;
    wall.start = end();
    wall.end = end();
    wall.sightings = static_cast<int>(random.index(5000));
    wall.sigma_m = random.uniform(0, 0.3);
    wall.evidence = 1 + static_cast<int>(random.index(kSureEvidence));
    building.walls.walls.push_back(wall);
  }
  return building;
}

TEST(BuildingJson, TheEvidenceOfAWallIsLeftOutWhereItIsSure) {
  Building building;
  building.walls.walls = {{.segment = {{0, 0}, {1, 0}}, .evidence = 1}, {.segment = {{0, 1}, {1, 1}}}};
  const std::string text = building_json(building);
  EXPECT_THAT(text, HasSubstr("\"evidence\": 1}"));
  EXPECT_EQ(text.find("evidence"), text.rfind("evidence"));
  const auto read = parse_building(text, "x");
  ASSERT_TRUE(read.ok());
  EXPECT_FALSE(read->walls.walls[0].is_certain());
  EXPECT_EQ(read->walls.walls[1].evidence, kSureEvidence);
  const std::string wall = R"("walls": [{"start_m": [0, 0], "end_m": [1, 0], "evidence": 4}])";
  EXPECT_THAT(to_string(parse_building(building_with(wall), "x").problems()), HasSubstr("walls[0].evidence"));
}

TEST(BuildingJson, TheGoldenFileSaysWhatWasLearned) {
  const auto building = read_building(kGoldenWalls);
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  EXPECT_EQ(building->name, "Corridor \"B\"");
  EXPECT_TRUE(building->has_dominant_direction);
  ASSERT_THAT(building->walls.walls, SizeIs(3));
  const Wall& wall = building->walls.walls[1];
  EXPECT_THAT(wall.segment.start, PointNear(Vec2(12.345, 2.1), 0));
  EXPECT_THAT(wall.segment.end, PointNear(Vec2(-3.2, 2.1), 0));
  EXPECT_TRUE(wall.is_orthogonal);
  EXPECT_EQ(wall.start, WallEnd::kUnknown);
  EXPECT_EQ(wall.end, WallEnd::kSeen);
  EXPECT_EQ(wall.sightings, 9);
  EXPECT_EQ(wall.sigma_m, 0.02);
  EXPECT_FALSE(building->walls.walls[2].is_orthogonal);
}

TEST(BuildingJson, WritesTheGoldenFilesAsTheyStand) {
  EXPECT_EQ(building_json(*read_building(kGoldenWalls)), *read_whole_file(kGoldenWalls));
  EXPECT_EQ(building_json(*read_building(kGoldenRoutes)), *read_whole_file(kGoldenRoutes));
}

TEST(BuildingJson, FilesOfFormerVersionsAreWrittenAsVersion3) {
  for (const std::string former :
       {"building.v1", "building.v2", "building_routes.v1", "building_routes.v2", "building_corridors.v2"}) {
    const auto building = read_building(kGolden / (former + ".json"));
    ASSERT_TRUE(building.ok()) << to_string(building.problems());
    const std::string name = former.substr(0, former.find('.'));
    EXPECT_EQ(building_json(*building), *read_whole_file(kGolden / (name + ".v3.json"))) << former;
  }
}

TEST(BuildingJson, WallsAloneHaveNoLandmarks) {
  const auto building = read_building(kGoldenWalls);
  EXPECT_FALSE(building->camera);
  EXPECT_TRUE(building->landmarks.empty());
  EXPECT_TRUE(building->routes.empty());
}

RC_GTEST_PROP(BuildingJson, ReadingItGivesTheSameBuildingToTheMillimetre, (std::uint64_t seed)) {
  Random random(seed);
  const Building written = any_building(random, random.index(9));
  const auto read = parse_building(building_json(written), "written");
  RC_ASSERT(read.ok());
  RC_ASSERT(read->name == written.name);
  RC_ASSERT(read->has_dominant_direction == written.has_dominant_direction);
  RC_ASSERT(read->walls.walls.size() == written.walls.walls.size());
  for (std::size_t i = 0; i < written.walls.walls.size(); ++i) {
    const Wall& a = written.walls.walls[i];
    const Wall& b = read->walls.walls[i];
    RC_ASSERT((a.segment.start - b.segment.start).norm() < 0.001);
    RC_ASSERT((a.segment.end - b.segment.end).norm() < 0.001);
    RC_ASSERT(a.is_orthogonal == b.is_orthogonal && a.start == b.start && a.end == b.end);
    RC_ASSERT(a.sightings == b.sightings);
    RC_ASSERT(std::abs(a.sigma_m - b.sigma_m) < 0.0001);
  }
}

TEST(BuildingJson, BarriersAreReadAndWrittenAndOtherKindsAreRefused) {
  const auto building = parse_building(
      building_with(R"("barriers": [{"kind": "glass", "start_m": [1, 2], "end_m": [1, 3.5]}])"), "b.json");
  ASSERT_TRUE(building.ok());
  ASSERT_THAT(building->barriers, SizeIs(1));
  EXPECT_EQ(building->barriers[0].kind, Barrier::Kind::kGlass);
  EXPECT_THAT(building->barriers[0].segment.end, PointNear(Vec2(1, 3.5), 0));
  EXPECT_EQ(building_json(*parse_building(building_json(*building), "written")), building_json(*building));
  EXPECT_THAT(building_problems(building_with(R"("barriers": [{"kind": "fence", "start_m": [1]}])")),
              AllOf(HasSubstr("barriers[0].kind: is neither \"keep_out\" nor \"glass\""),
                    HasSubstr("barriers[0].start_m: is not a list of 2"),
                    HasSubstr("barriers[0].end_m: is missing")));
}

TEST(BuildingJson, DirectionsOfWallsAreToAQuarterTurnAndAsSureAsMayBe) {
  const auto building = parse_building(
      building_with(R"("wall_directions": [{"at_m": [0, -0.25], "direction_deg": 1.35, "sigma_deg": 0.15}])"),
      "b.json");
  ASSERT_TRUE(building.ok());
  ASSERT_THAT(building->wall_directions, SizeIs(1));
  EXPECT_THAT(building->wall_directions[0].p_map, PointNear(Vec2(0, -0.25), 0));
  EXPECT_NEAR(building->wall_directions[0].direction_rad, 1.35 * kDegree, 1e-12);
  EXPECT_NEAR(building->wall_directions[0].sigma_rad, 0.15 * kDegree, 1e-12);
  EXPECT_THAT(
      building_problems(building_with(
          R"("wall_directions": [{"at_m": [1], "direction_deg": 90, "sigma_deg": 0}, {"at_m": [1, 2]}])")),
      AllOf(HasSubstr("wall_directions[0].at_m: is not a list of 2"),
            HasSubstr("wall_directions[0].direction_deg: is not a number from -45 to 45"),
            HasSubstr("wall_directions[0].sigma_deg: is not a number from 0.01 to 45"),
            HasSubstr("wall_directions[1].direction_deg: is missing"),
            HasSubstr("wall_directions[1].sigma_deg: is missing")));
}

TEST(BuildingJson, SixHundredWallsAreSmall) {
  Random random(1);
  EXPECT_LE(building_json(any_building(random, 600)).size(), 100000U);
}

TEST(BuildingJson, EveryPartMayBeMissing) {
  const auto building = parse_building(R"({"format": "aisle.building", "version": 1})", "b.json");
  ASSERT_TRUE(building.ok());
  EXPECT_THAT(building->walls.walls, SizeIs(0));
}

TEST(BuildingJson, OtherFormatsAndVersionsAreRefused) {
  EXPECT_THAT(building_problems("{}"), HasSubstr("b.json: format: is not \"aisle.building\""));
  EXPECT_THAT(building_problems(R"({"format": "aisle.world", "version": 1})"), HasSubstr("format: is not"));
  EXPECT_THAT(building_problems(R"({"format": "aisle.building"})"), HasSubstr("version: is missing"));
  EXPECT_THAT(building_problems(R"({"format": "aisle.building", "version": 4})"),
              HasSubstr("version: 4 is unknown; this program reads versions 1 to 3"));
  EXPECT_THAT(building_problems("[]"), HasSubstr("b.json: is not a JSON object"));
}

TEST(BuildingJson, MalformedJsonNamesItsLine) {
  EXPECT_THAT(building_problems(""), HasSubstr("b.json:1: is not well-formed"));
  EXPECT_THAT(building_problems("{\n\"format\": \"aisle.building\",\n oops}"),
              HasSubstr("b.json:3: is not well-formed"));
  EXPECT_THAT(building_problems(building_with(R"("name": 1e999)")), HasSubstr("too large"));
}

TEST(BuildingJson, BadValuesNameTheirKeyPathAllAtOnce) {
  EXPECT_THAT(
      building_problems(building_with(
          R"("name": 7, "walls": [{"start_m": [1], "end_m": [1, 1e9], "sightings": -1, "ends": ["open", "seen"]}],
                               "has_dominant_direction": "yes", "doors": [])")),
      AllOf(HasSubstr("b.json: name: is not a text"), HasSubstr("walls[0].start_m: is not a list of 2"),
            HasSubstr("walls[0].end_m[1]: is not a number from -1e+06 to 1e+06"),
            HasSubstr("walls[0].sightings: is not a whole number"),
            HasSubstr("walls[0].ends[0]: is neither \"seen\" nor \"unknown\""),
            HasSubstr("has_dominant_direction: is neither true nor false"), HasSubstr("doors: unknown key")));
  EXPECT_THAT(building_problems(building_with(R"("walls": [{}])")),
              HasSubstr("walls[0].start_m: is missing"));
  EXPECT_THAT(building_problems(building_with(R"("walls": {"0": 1})")), HasSubstr("walls: is not a list"));
}

TEST(BuildingJson, ZonesAreReadAsTheyWereWritten) {
  const std::string text = building_with(
      R"("zones": [
{"kind": "keep_out", "outline_m": [[0, 0], [2, 0], [2, 1.5]], "name": "lab"},
{"kind": "slow", "outline_m": [[4, 0], [6, 0], [6, 2]], "speed_max_mps": 0.25},
{"kind": "one_way", "outline_m": [[7, 0], [9, 0], [9, 2], [7, 2]], "direction_deg": 90}
])");
  const auto building = parse_building(text, "b.json");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  ASSERT_THAT(building->zones, SizeIs(3));
  EXPECT_EQ(building->zones[0].name, "lab");
  EXPECT_EQ(building->zones[1].speed_max_mps, 0.25);
  EXPECT_DOUBLE_EQ(building->zones[2].direction_rad, kPi / 2);
  const std::string written = building_json(*building);
  EXPECT_EQ(building_json(*parse_building(written, "b.json")), written);
  EXPECT_THAT(
      written,
      HasSubstr(
          R"({"kind": "one_way", "outline_m": [[7, 0], [9, 0], [9, 2], [7, 2]], "direction_deg": 90})"));
}

TEST(BuildingJson, ZonesWithoutSenseAreRefused) {
  const auto refused = [](const std::string& zone) {
    return building_problems(building_with("\"zones\": [{" + zone + "}]"));
  };
  EXPECT_THAT(refused(R"("kind": "slow", "outline_m": [[0, 0], [2, 0], [2, 2]])"),
              HasSubstr("zones[0].speed_max_mps: is missing"));
  EXPECT_THAT(refused(R"("kind": "one_way", "outline_m": [[0, 0], [2, 0], [2, 2]])"),
              HasSubstr("zones[0].direction_deg: is missing"));
  EXPECT_THAT(refused(R"("kind": "keep_out", "outline_m": [[0, 0], [2, 0], [2, 2]], "speed_max_mps": 1)"),
              HasSubstr("zones[0].speed_max_mps: means nothing in a zone of this kind"));
  EXPECT_THAT(refused(R"("kind": "keep_out", "outline_m": [[0, 0], [2, 0]])"),
              HasSubstr("zones[0].outline_m: must have 3 to 100 corners"));
  EXPECT_THAT(refused(R"("kind": "keep_out", "outline_m": [[0, 0], [2, 0], [4, 0]])"),
              HasSubstr("zones[0].outline_m: encloses no area"));
  EXPECT_THAT(refused(R"("kind": "moat", "outline_m": [[0, 0], [2, 0], [2, 2]])"),
              HasSubstr("zones[0].kind: is none of \"keep_out\", \"slow\" and \"one_way\""));
}

}  // namespace
}  // namespace aisle
