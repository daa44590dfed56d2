#include <gmock/gmock.h>

#include <filesystem>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A dark grey wall with a bright stripe in row 20 above a brighter floor that begins in row 60, as PGM.
std::string image_file(int width = 120, int height = 90) {
  std::string bytes = "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
  for (int v = 0; v < height; ++v)
    bytes += std::string(static_cast<std::size_t>(width), static_cast<char>(v == 20  ? 250
                                                                            : v < 60 ? 60
                                                                                     : 160));
  return bytes;
}

/// Width and height from the header of a PNG file.
std::pair<int, int> size_of_png(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (!bytes.starts_with("\x89PNG") || bytes.size() < 24) return {0, 0};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

class Detect : public Workplace {};

TEST_F(Detect, StripesAreListedForEachImageWithItsNameAsGiven) {
  const std::string a = file("a.pgm", image_file()), b = file("b.pgm", image_file());
  const ProgramRun run = run_aisle({"detect", "stripes", a, b, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto images = run.json()["figures"]["images"];
  ASSERT_EQ(images.size(), 2);
  EXPECT_EQ(images[0]["file"], a);
  EXPECT_EQ(images[1]["file"], b);
  ASSERT_EQ(images[0]["stripes"].size(), 1);
  const auto stripe = images[0]["stripes"][0];
  EXPECT_EQ(stripe["polyline"].size(), 120);
  EXPECT_EQ(stripe["polyline"][7], (nlohmann::json{7.0, 20.0}));
  EXPECT_EQ(stripe["corners"], (nlohmann::json{{0.0, 20.0}, {119.0, 20.0}}));
}

TEST_F(Detect, TheRegionIsAMaskBesideItsOverlayBothAsLargeAsTheImage) {
  const std::string a = file("a.pgm", image_file());
  const ProgramRun run = run_aisle({"detect", "region", a, "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto image = run.json()["figures"]["images"][0];
  EXPECT_EQ(image["region_mask"], at("out/a.region.png"));
  EXPECT_NEAR(image["region_share"].get<double>(), 30.0 / 90, 0.02);
  EXPECT_THAT(names_in(at("out")), ElementsAre("a.overlay.png", "a.region.png"));
  EXPECT_EQ(size_of_png(at("out/a.region.png")), std::pair(120, 90));
  EXPECT_EQ(size_of_png(at("out/a.overlay.png")), std::pair(120, 90));
}

TEST_F(Detect, VerticalLinesAndBaseLinesHaveTheirKeys) {
  const std::string a = file("a.pgm", image_file());
  const ProgramRun verticals = run_aisle({"detect", "verticals", a, "--out", at("out"), "--json"});
  ASSERT_EQ(verticals.exit_code, 0) << verticals.err;
  EXPECT_TRUE(verticals.json()["figures"]["images"][0]["verticals"].is_array());
  EXPECT_EQ(size_of_png(at("out/a.overlay.png")), std::pair(120, 90));
  const ProgramRun base_lines = run_aisle({"detect", "baselines", a, "--json"});
  ASSERT_EQ(base_lines.exit_code, 0) << base_lines.err;
  EXPECT_TRUE(base_lines.json()["figures"]["images"][0].at("right_baseline").is_null());
  EXPECT_TRUE(base_lines.json()["figures"]["images"][0].at("left_baseline").is_null());
}

TEST_F(Detect, ADoorsEdgesAreVerticalLines) {
  std::string bytes = "P5 160 120 255\n";
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) bytes += static_cast<char>(u >= 60 && u < 100 && v > 20 ? 40 : 180);
  const ProgramRun run = run_aisle({"detect", "verticals", file("door.pgm", bytes), "--json"});
  const auto lines = run.json()["figures"]["images"][0]["verticals"];
  ASSERT_EQ(lines.size(), 2);
  EXPECT_NEAR(lines[0]["top"][0].get<double>(), 59.5, 0.5);
  EXPECT_NEAR(lines[1]["bottom"][0].get<double>(), 99.5, 0.5);
  EXPECT_LT(lines[0]["top"][1].get<double>(), lines[0]["bottom"][1].get<double>());
  EXPECT_TRUE(lines[0]["foot"].is_boolean());
}

/// The end of a corridor in three tones with lines at these columns, as PGM.
std::string image_with_lines(int first, int second, int third) {
  std::string bytes = "P5 320 240 255\n";
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      bytes += static_cast<char>(u < first ? 180 : u < second ? 60 : u < third ? 130 : 30);
    }
  }
  return bytes;
}

TEST_F(Detect, FollowedLinesKeepTheirNumbersWhileTheCameraComesNearer) {
  const std::string far = file("far.pgm", image_with_lines(120, 140, 210));
  const std::string near = file("near.pgm", image_with_lines(100, 128, 240));
  const ProgramRun run =
      run_aisle({"detect", "verticals", "--follow", far, near, "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  for (std::size_t i = 0; i < 2; ++i) {
    const auto lines = figures["images"][i]["verticals"];
    ASSERT_EQ(lines.size(), 3);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(lines[k]["number"], k);
  }
  EXPECT_EQ(figures["follow"].dump(), R"({"followed":3,"lines":3,"longest_pictures":2})");
  EXPECT_THAT(names_in(at("out")), ElementsAre("far.overlay.png", "followed.png", "near.overlay.png"));
  EXPECT_EQ(size_of_png(at("out/followed.png")), std::pair(2 * 320 + 6, 240));
}

TEST_F(Detect, ACamerasCalibrationMustBeOneAndFitTheImage) {
  const std::string a = file("a.pgm", image_file());
  const std::string calibration = file("camera.yaml",
                                       "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n"
                                       "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                                       "   data: [500., 0., 320., 0., 500., 240., 0., 0., 1.]\n"
                                       "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n"
                                       "   dt: d\n   data: [0., 0., 0., 0., 0.]\n");
  EXPECT_THAT(run_aisle({"detect", "verticals", a, "--calibration", calibration, "--json"}),
              IsRefused("a.pgm: has 120 x 90 pixels; the camera's calibration is for 640 x 480"));
  const std::string large = file("large.pgm", image_file(640, 480));
  EXPECT_EQ(run_aisle({"detect", "verticals", large, "--calibration", calibration}).exit_code, 0);
  EXPECT_THAT(run_aisle({"detect", "verticals", a, "--calibration", at("absent.yaml"), "--json"}),
              IsRefused("absent.yaml"));
}

TEST_F(Detect, WithoutADirectoryThereIsNoMask) {
  const ProgramRun run = run_aisle({"detect", "region", file("a.pgm", image_file()), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.json()["figures"]["images"][0]["region_mask"].is_null());
  EXPECT_THAT(run.json()["files"], IsEmpty());
}

TEST_F(Detect, ImagesOfTheSameNameDoNotOverwriteEachOther) {
  std::filesystem::create_directory(at("left"));
  std::filesystem::create_directory(at("right"));
  const std::string a = file("left/1.pgm", image_file()), b = file("right/1.pgm", image_file(60, 90));
  ASSERT_EQ(run_aisle({"detect", "stripes", a, b, "--out", at("out")}).exit_code, 0);
  EXPECT_THAT(names_in(at("out")), ElementsAre("1-2.overlay.png", "1.overlay.png"));
  EXPECT_EQ(size_of_png(at("out/1.overlay.png")), std::pair(120, 90));
  EXPECT_EQ(size_of_png(at("out/1-2.overlay.png")), std::pair(60, 90));
}

TEST_F(Detect, OneBadImageAmongManyIsNamedAndNothingIsWritten) {
  const std::string good = file("good.pgm", image_file());
  const std::string bad = file("bad.png", "no image");
  EXPECT_THAT(run_aisle({"detect", "region", good, bad, good, "--out", at("out"), "--json"}),
              IsRefused("bad.png: is not an image"));
  EXPECT_THAT(run_aisle({"detect", "region", good, at("absent.png"), "--out", at("out"), "--json"}),
              IsRefused("absent.png: no such file"));
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

TEST_F(Detect, ResultsAreReplacedOnlyByForce) {
  const std::string a = file("a.pgm", image_file());
  ASSERT_EQ(run_aisle({"detect", "stripes", a, "--out", at("out")}).exit_code, 0);
  EXPECT_THAT(run_aisle({"detect", "stripes", a, "--out", at("out"), "--json"}), IsRefused("--force"));
  EXPECT_EQ(run_aisle({"detect", "stripes", a, "--out", at("out"), "--force"}).exit_code, 0);
}

TEST_F(Detect, MistakesAreRefusedInOneLine) {
  const std::string a = file("a.pgm", image_file());
  EXPECT_THAT(run_aisle({"detect", "--json"}), IsRefused("A subcommand or --check IMAGES is required"));
  EXPECT_THAT(run_aisle({"detect", "stripes", "--json"}), IsRefused("IMAGE is required"));
  EXPECT_THAT(run_aisle({"detect", "stripes", a, "--out", "", "--json"}), IsRefused("--out"));
  EXPECT_THAT(run_aisle({"detect", "stripes", a, "--out", a, "--json"}),
              IsRefused("cannot be made: Not a directory"));
  EXPECT_THAT(run_aisle({"detect", "stripes", a, "--set", "stripes.corner_px=-1", "--json"}),
              IsRefused("stripes.corner_px"));
}

TEST_F(Detect, PeopleReadALineForEachImage) {
  const ProgramRun run = run_aisle({"detect", "region", file("a.pgm", image_file())});
  EXPECT_THAT(run.out, HasSubstr("a.pgm: route on 33.3 % of the image"));
}

/// A wall with a dark door from one column to another, as PGM.
std::string door_file(int from, int to, int wall_grey) {
  constexpr int kWidth = 320, kHeight = 240;
  std::string bytes = "P5 320 240 255\n";
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u)
      bytes += static_cast<char>(u >= from && u < to && v > 40 && v < 200 ? wall_grey / 3 : wall_grey);
  }
  return bytes;
}

TEST_F(Detect, TaughtPlacesAreRecognisedInOtherLight) {
  std::filesystem::create_directory(at("lap"));
  file("lap/2.pgm", door_file(30, 90, 180));
  file("lap/10.pgm", door_file(200, 290, 180));
  file("lap/notes.txt", "no image");
  const std::string extra = file("extra.pgm", door_file(150, 170, 180));
  const std::string late = file("late.pgm", door_file(30, 90, 140)),
                    bare = file("bare.pgm", door_file(0, 0, 140));
  const ProgramRun run = run_aisle({"detect", "places", late, extra, bare, "--taught", at("lap"), extra,
                                    "--set", "places.rival_apart=0", "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto images = run.json()["figures"]["images"];
  EXPECT_EQ(images[0]["place"], at("lap/2.pgm"));
  EXPECT_LT(images[0]["unlike"], 0.1);
  EXPECT_GT(images[0]["rival_unlike"], 0.1);
  EXPECT_EQ(images[1]["place"], extra);
  EXPECT_TRUE(images[2]["place"].is_null());
  EXPECT_TRUE(images[2]["most_alike"].is_string());
  EXPECT_THAT(names_in(at("out")), ElementsAre("bare.overlay.png", "extra.overlay.png", "late.overlay.png"));
  EXPECT_EQ(size_of_png(at("out/late.overlay.png")), std::pair(2 * 320 + 6, 240));
}

TEST_F(Detect, PlacesOfOneDriveConfirmEachOther) {
  std::vector<std::string> command = {"detect", "places"};
  for (const int from : {30, 110, 190})
    command.push_back(file(std::to_string(from) + ".pgm", door_file(from, from + 60, 180)));
  command.insert(command.end(),
                 {"--taught", command[2], command[3], command[4], "--set", "places.unlike_max=0", "--json"});
  const auto alone = run_aisle(command).json()["figures"]["images"];
  for (const auto& image : alone) EXPECT_TRUE(image["place"].is_null());
  command.push_back("--follow");
  const auto together = run_aisle(command).json()["figures"]["images"];
  for (const auto& image : together) EXPECT_EQ(image["place"], image["file"]);
}

TEST_F(Detect, PlacesWithoutTaughtImagesAreRefused) {
  const std::string image = file("a.pgm", image_file());
  EXPECT_THAT(run_aisle({"detect", "places", image}).err, HasSubstr("--taught"));
  std::filesystem::create_directory(at("empty"));
  const ProgramRun run =
      run_aisle({"detect", "places", image, "--taught", at("empty"), at("none.png"), "--out", at("out")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("has no images"));
  EXPECT_THAT(run.err, HasSubstr("none.png")) << "all that is wrong at once";
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

}  // namespace
}  // namespace aisle
