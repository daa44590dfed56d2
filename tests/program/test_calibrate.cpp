#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A lens of 500 px, 640 x 480, without distortion.
constexpr const char* kLens = "image_width: 640\nimage_height: 480\nK: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n";

/// The same on a vehicle: 1 m above the floor at base_link, level.
const std::string kMounted =
    std::string(kLens) + "vehicle_mount: {x_m: 0, y_m: 0, z_m: 1, tilt_deg: 0, pan_deg: 0, roll_deg: 0}\n";

/// What that camera sees of points at (x, y): u = 320 - 500 y / x, v = 240 + 500 / x.
constexpr const char* kMarks =
    "445 490 2 -0.5\n195 490 2 0.5\n445 365 4 -1\n195 365 4 1\n320 406.6666667 3 0\n520 440 2.5 -1\n";

std::string grey_image(int width, int height) {
  return "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n" +
         std::string(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\x80');
}

/// A grey image of a wall with the laser's stripe in row `row`.
std::string striped_image(std::size_t row) {
  std::string image = grey_image(640, 480);
  image.replace(image.size() - (480 - row) * 640, 640, std::string(640, '\xff'));
  return image;
}

class Calibrate : public Workplace {};

TEST_F(Calibrate, MarksOnTheFloorGiveTheMountAndFilesThatAreReadAgain) {
  const std::string lens = file("lens.yaml", kLens), marks = file("marks.txt", kMarks);
  const ProgramRun run = run_aisle(
      {"calibrate", "floor", "--calibration", lens, "--marks", marks, "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  const auto figures = run.json()["figures"];
  EXPECT_NEAR(figures["height_m"], 1, 1e-5);
  EXPECT_NEAR(figures["tilt_deg"], 0, 1e-4);
  EXPECT_NEAR(figures["x_m"], 0, 1e-5);
  EXPECT_THAT(names_in(at("out")),
              ElementsAre("camera.yaml", "camera_info.yaml", "residuals.png", "residuals.svg"));
  for (const char* name : {"out/camera.yaml", "out/camera_info.yaml"}) {
    const ProgramRun again = run_aisle({"calibrate", "floor", "--calibration", at(name), "--marks", marks});
    EXPECT_EQ(again.exit_code, 0) << name << again.err;
  }
}

TEST_F(Calibrate, AStripeOnAWallGivesTheLasersHeight) {
  // Row 415 at 2 m: 1 - 2 * (415 - 240) / 500 = 0.3 m.
  const std::string camera = file("camera.yaml", kMounted), image = file("wall.pgm", striped_image(415));
  const ProgramRun run = run_aisle(
      {"calibrate", "laser", image, "--wall-at", "2", "--calibration", camera, "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_NEAR(run.json()["figures"]["laser_height_m"], 0.3, 1e-4);
  EXPECT_THAT(read_bytes(at("out/camera.yaml")), HasSubstr("laser_height_m: 0.3"));
}

TEST_F(Calibrate, MarksThatDoNotFitMakeAPoorResultAndExitCodeOne) {
  const std::string lens = file("lens.yaml", kLens);
  const std::string marks = file(
      "marks.txt", "445 460 2 -0.5\n195 490 2 0.5\n465 365 4 -1\n195 390 4 1\n300 406 3 0\n520 400 2.5 -1\n");
  const ProgramRun run = run_aisle({"calibrate", "floor", "--calibration", lens, "--marks", marks, "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_EQ(run.json()["ok"], false);
  EXPECT_EQ(run.json()["figures"]["verdict"]["quality"], "poor");
}

TEST_F(Calibrate, CameraRefusesImagesThatTellNothing) {
  const std::string a = file("a.pgm", grey_image(64, 48)), b = file("b.pgm", grey_image(48, 64));
  EXPECT_THAT(run_aisle({"calibrate", "camera", a, a, a, "--json", "--quiet"}),
              IsRefused("a.pgm: the board with 9 x 6 inner corners is whole in 0 of 3 images"));
  EXPECT_THAT(run_aisle({"calibrate", "camera", a, b, "--json"}), IsRefused("b.pgm: has 48 x 64 pixels"));
  EXPECT_THAT(run_aisle({"calibrate", "camera", file("c.png", "no image"), "--json"}),
              IsRefused("c.png: is not an image"));
  EXPECT_THAT(run_aisle({"calibrate", "camera", a, "--board", "9by6", "--json"}), IsRefused("'9by6' is not"));
  EXPECT_THAT(run_aisle({"calibrate", "camera", a, "--square-m", "0", "--json"}), IsRefused("--square-m"));
}

TEST_F(Calibrate, FloorNamesWhatIsWrongWithMarksAndBoards) {
  const std::string lens = file("lens.yaml", kLens), image = file("a.pgm", grey_image(640, 480));
  const auto floor = [&](std::vector<std::string> more) {
    Arguments arguments = {"calibrate", "floor", "--calibration", lens, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  };
  EXPECT_THAT(floor({}), IsRefused("--marks: neither images of a board nor a file of marks"));
  EXPECT_THAT(floor({"--marks", file("m.txt", "1 2 3\n")}), IsRefused("m.txt:1: the line ends"));
  EXPECT_THAT(floor({"--marks", file("l.txt", "320 490 2 0\n320 365 4 0\n320 340 5 0\n320 323 6 0\n")}),
              IsRefused("l.txt: all points lie on one line"));
  EXPECT_THAT(floor({image}), IsRefused("--board-at: is given 0 times for 1 images"));
  EXPECT_THAT(floor({image, "--board-at", "1,2"}), IsRefused("'1,2' is not x,y,degrees"));
  EXPECT_THAT(floor({image, "--board-at", "2,0,0"}), IsRefused("a.pgm: no whole board"));
  EXPECT_THAT(floor({image, "--board-at", "2,0,0", "--board", "8x6"}), IsRefused("turned half round"));
  EXPECT_THAT(floor({file("small.pgm", grey_image(64, 48)), "--board-at", "2,0,0"}),
              IsRefused("small.pgm: has 64 x 48 pixels; the calibration is for 640 x 480"));
}

TEST_F(Calibrate, LaserNeedsAMountAndAStripe) {
  const std::string lens = file("lens.yaml", kLens), camera = file("camera.yaml", kMounted);
  const std::string blank = file("a.pgm", grey_image(640, 480));
  EXPECT_THAT(run_aisle({"calibrate", "laser", blank, "--wall-at", "2", "--calibration", lens, "--json"}),
              IsRefused("lens.yaml: vehicle_mount: is missing"));
  EXPECT_THAT(run_aisle({"calibrate", "laser", blank, "--wall-at", "2", "--calibration", camera, "--json"}),
              IsRefused("a.pgm: fewer than 20 stripe points"));
  EXPECT_THAT(run_aisle({"calibrate", "laser", blank, "--calibration", camera, "--json"}),
              IsRefused("a.pgm: no whole board"));
}

}  // namespace
}  // namespace aisle
