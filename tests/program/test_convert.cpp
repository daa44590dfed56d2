#include <gmock/gmock.h>

#include "room_plan.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const std::string kMaze =
    "o---o---o\n"
    "| S |   |\n"
    "o   o---o\n"
    "|     G |\n"
    "o---o---o\n";

class Convert : public Workplace {
 protected:
  ProgramRun convert(const Arguments& arguments, const std::string& out) const {
    Arguments all = {"convert"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"-o", at(out), "--json"});
    return run_aisle(all);
  }
};

TEST_F(Convert, AnImageBecomesAWorldThatCanBeDriven) {
  const auto result = convert({file("room.pbm", room_pbm(100, 60))}, "room.yaml").json();
  EXPECT_EQ(result["verb"], "convert");
  EXPECT_EQ(result["figures"]["walls"], 4);
  EXPECT_NEAR(result["figures"]["walls_m"].get<double>(), 16, 1e-9);
  EXPECT_GT(result["figures"]["tour_m"], 1);
  EXPECT_EQ(run_aisle({"sim", "log", at("room.yaml"), "--out", at("log"), "--json"}).exit_code, 0);
}

TEST_F(Convert, AMapServerMapIsReadThroughItsYamlFile) {
  file("map.pgm", std::string("P2\n3 3\n255\n0 0 0\n0 254 0\n0 0 0\n"));
  const std::string yaml =
      file("map.yaml", "image: map.pgm\nresolution: 2\norigin: [10, 20, 0]\nnegate: 0\n");
  EXPECT_EQ(convert({yaml}, "world.yaml").json()["figures"]["drivable_m2"].get<double>() > 1, true);
  EXPECT_THAT(read_bytes(at("world.yaml")), HasSubstr("[14, 22]"));
}

/// Two rooms of 4 x 4 m with walls of three pixels and, if wanted, a gap of 1.2 m between them.
std::string two_rooms(int wall_grey, bool has_gap) {
  std::string pgm = "P2\n166 86\n255\n";
  for (int y = 0; y < 86; ++y) {
    for (int x = 0; x < 166; ++x) {
      const bool border = x < 3 || y < 3 || x >= 163 || y >= 83;
      const bool between = x >= 81 && x < 84 && !(has_gap && y >= 30 && y < 54);
      pgm += std::to_string(border || between ? wall_grey : 255) + (x == 165 ? "\n" : " ");
    }
  }
  return pgm;
}

std::string text_of_run(const std::string& plan, const std::vector<std::string>& more,
                        const std::string& out) {
  Arguments all = {"convert", plan, "-o", out, "--force"};
  all.insert(all.end(), more.begin(), more.end());
  const ProgramRun run = run_aisle(all);
  return std::to_string(run.exit_code) + " " + run.err;
}

TEST_F(Convert, FloorOutOfReachIsSaid) {
  EXPECT_EQ(text_of_run(file("open.pgm", two_rooms(0, true)), {}, at("open.yaml")), "0 ");
  EXPECT_THAT(text_of_run(file("shut.pgm", two_rooms(0, false)), {}, at("shut.yaml")),
              HasSubstr("50 % of the floor where a vehicle 0.6 m wide fits cannot be reached"));
}

TEST_F(Convert, LightGreyWallsAreSaidAndFoundByAThreshold) {
  const std::string plan = file("light.pgm", two_rooms(215, true));
  EXPECT_THAT(text_of_run(plan, {}, at("light.yaml")), HasSubstr("--threshold 216"));
  EXPECT_EQ(text_of_run(plan, {"--threshold", "216"}, at("light.yaml")), "0 ");
  EXPECT_EQ(text_of_run(plan, {"--threshold", "0.1"}, at("light.yaml")), "0 ");
}

TEST_F(Convert, TwoPointsGiveTheScale) {
  const std::string plan = file("rooms.pgm", two_rooms(0, true));
  const auto walls_m = [&](const Arguments& more) {
    Arguments all = {plan};
    all.insert(all.end(), more.begin(), more.end());
    return convert(all, "scaled.yaml").json()["figures"]["walls_m"].get<double>();
  };
  const double usual_m = walls_m({"--force"});
  EXPECT_NEAR(walls_m({"--force", "--scale-by", "0,0 100,0 10 m"}), 2 * usual_m, 0.2);
  EXPECT_THAT(text_of_run(plan, {"--scale-by", "0,0 0,0 3 m"}, at("x.yaml")),
              HasSubstr("is not two different points"));
}

TEST_F(Convert, ADrawingBecomesAWorld) {
  const std::string svg =
      file("room.svg",
           "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\"><rect x=\"5\" "
           "y=\"5\" width=\"590\" height=\"390\" fill=\"none\" stroke=\"black\" "
           "stroke-width=\"10\"/></svg>");
  EXPECT_THAT(text_of_run(svg, {}, at("room.yaml")), HasSubstr("--scale-by"));
  EXPECT_EQ(convert({svg, "--scale-by", "0,0 600,0 6", "--force"}, "room.yaml").json()["figures"]["walls"],
            4);
}

TEST_F(Convert, AMazeBecomesCorridorsOfTheWidthAskedFor) {
  const auto result =
      convert({file("maze.txt", kMaze), "--corridor-width", "2", "--wall-thickness", "0.5"}, "maze.yaml")
          .json();
  EXPECT_EQ(result["figures"]["walls"], 6) << "an L";
  EXPECT_THAT(read_bytes(at("maze.yaml")), HasSubstr("[4.5, 0]"));
  EXPECT_THAT(read_bytes(at("maze.yaml")), HasSubstr("goal"));
}

TEST_F(Convert, WallSegmentsAreRecognisedByTheirContent) {
  const std::string plan = file("floor.txt", "# a square\n0 0 4 0 W\n4 0 4 4 W\n4 4 0 4 W\n0 4 0 0 W\n");
  EXPECT_EQ(convert({plan}, "floor.yaml").json()["figures"]["walls"], 4);
}

TEST_F(Convert, ARandomBuildingIsTheSameForTheSameSeed) {
  for (const std::string kind : {"office", "ring", "comb", "hall"}) {
    EXPECT_EQ(convert({"--random", "5", "--kind", kind}, kind + "1.yaml").exit_code, 0) << kind;
    convert({"--random", "5", "--kind", kind}, kind + "2.yaml");
    convert({"--random", "6", "--kind", kind}, kind + "3.yaml");
    EXPECT_EQ(read_bytes(at(kind + "1.yaml")), read_bytes(at(kind + "2.yaml")));
    EXPECT_NE(read_bytes(at(kind + "1.yaml")), read_bytes(at(kind + "3.yaml")));
  }
}

TEST_F(Convert, ADecoratedPlanHasDoorsAndLamps) {
  const auto result = convert({file("room.pbm", room_pbm(200, 60)), "--dress"}, "room.yaml").json();
  EXPECT_GT(result["figures"]["doors"], 1);
  EXPECT_GT(result["figures"]["lamps"], 0);
}

TEST_F(Convert, APlanWithoutRoomForTheVehicleIsConvertedWithAWarning) {
  const ProgramRun run = convert({file("closet.pbm", room_pbm(9, 9))}, "closet.yaml");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("no room for a vehicle 0.6 m wide"));
}

TEST_F(Convert, BadInputIsRefusedAndNothingIsWritten) {
  EXPECT_THAT(convert({at("none.pbm")}, "w.yaml"), IsRefused("none.pbm"));
  EXPECT_THAT(convert({file("cut.pbm", "P1\n4 4\n0 1")}, "w.yaml"), IsRefused("ends after 2 of 16 pixels"));
  EXPECT_THAT(convert({file("black.pbm", "P1\n2 2\n1 1 1 1\n")}, "w.yaml"), IsRefused("shows no free floor"));
  EXPECT_THAT(convert({file("m.yaml", "image: none.pgm\nresolution: 1\norigin: [0, 0, 0]\n")}, "w.yaml"),
              IsRefused("none.pgm"));
  EXPECT_THAT(convert({"--random", "1", "--corridor-width", "0.9"}, "w.yaml"), IsRefused("corridor-width"));
  EXPECT_THAT(convert({"--random", "1", at("plan.pbm")}, "w.yaml"),
              IsRefused("cannot be combined with --random"));
  EXPECT_THAT(convert({"--random", "x"}, "w.yaml"), IsRefused("random"));
  EXPECT_THAT(convert({}, "w.yaml"), IsRefused("PLAN"));
  EXPECT_TRUE(names_in(at("")).size() == 3) << "only what the test wrote";
  convert({file("room.pbm", room_pbm(40, 40))}, "there.yaml");
  EXPECT_THAT(convert({at("room.pbm")}, "there.yaml"), IsRefused("exists already"));
}

}  // namespace
}  // namespace aisle
