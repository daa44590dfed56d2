#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>

#include "drawn_corridor.hpp"
#include "short_drive.hpp"

namespace aisle {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::string corridor_file(double left_m) {
  DrawnCorridor corridor;
  corridor.left_m = left_m;
  corridor.right_m = left_m + 2;
  corridor.width_px = 320;
  corridor.height_px = 240;
  corridor.camera = {250, 250, 159.5, 119.5};
  const Image image = corridor.image(2);
  return fmt::format("P5 {} {} 255\n", image.width_px, image.height_px) +
         std::string(image.bytes.begin(), image.bytes.end());
}

std::string blank_file() {
  return "P5 320 240 255\n" + std::string(320 * 240, static_cast<char>(90));
}

/// `detect --check` of images that are drawn, so that it is known what is in them.
class DetectCheck : public Workplace {
 protected:
  /// @return the folder
  std::string folder_of(const std::string& name, int images, bool is_corridor = true) const {
    std::filesystem::create_directory(at(name));
    for (int i = 0; i < images; ++i)
      file(fmt::format("{}/{}.pgm", name, i), is_corridor ? corridor_file(-1.1 + 0.02 * i) : blank_file());
    return at(name);
  }
};

std::vector<std::string> keys_of_hints(const nlohmann::json& figures) {
  std::vector<std::string> keys;
  for (const nlohmann::json& hint : figures["hints"]) keys.push_back(hint["key"]);
  return keys;
}

TEST_F(DetectCheck, AClearCorridorIsSeenAndDrawn) {
  const ProgramRun run =
      run_aisle({"detect", "--check", folder_of("frames", 12), "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json figures = run.json()["figures"];
  EXPECT_EQ(figures["found"], 12);
  EXPECT_EQ(figures["checked"], 12);
  for (const char* method : {"landmarks", "sections", "rooms"})
    EXPECT_EQ(figures["methods"][method]["verdict"], "seen") << method << run.out;
  EXPECT_NEAR(figures["medians"]["horizon"].get<double>(), 0.5, 0.03);
  EXPECT_TRUE(figures["medians"]["tilt_deg"].is_null()) << "without the lens nobody knows";
  EXPECT_GT(figures["steadiness"]["pairs"], 5);
  EXPECT_THAT(keys_of_hints(figures), Contains("lens_unknown"));
  EXPECT_THAT(figures["images"], SizeIs(12));
  EXPECT_EQ(figures["images"][3]["file"], at("frames/3.pgm"));
  EXPECT_TRUE(figures["images"][3]["right_edge"]["good"]);
  EXPECT_THAT(figures["not_judged"], Not(IsEmpty()));
  EXPECT_THAT(names_in(at("out")), SizeIs(12));
  EXPECT_THAT(names_in(at("out")), Contains("3.overlay.png"));
}

TEST_F(DetectCheck, BlankWallsAreNotSeen) {
  const ProgramRun run = run_aisle({"detect", "--check", folder_of("walls", 12, false), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json figures = run.json()["figures"];
  EXPECT_EQ(figures["methods"]["landmarks"]["verdict"], "not_seen");
  EXPECT_EQ(figures["methods"]["sections"]["verdict"], "not_seen");
  EXPECT_THAT(keys_of_hints(figures), Contains("flat"));
}

TEST_F(DetectCheck, OnePictureIsLookedAtButNotJudged) {
  const ProgramRun run = run_aisle({"detect", "--check", file("view.pgm", corridor_file(-1))});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1 of 1    not judged: too few images"));
  EXPECT_THAT(run.out, HasSubstr("Hints: what would probably help (not measured)"));
  EXPECT_THAT(run.out, HasSubstr("nobody labelled these images"));
  EXPECT_THAT(run.out, Not(HasSubstr("seen, as far as")));
}

TEST_F(DetectCheck, OfManyImagesPairsAreChosenEvenlyAndItSaysSo) {
  const std::string frames = folder_of("frames", 20);
  const ProgramRun run = run_aisle({"detect", "--check", frames, "--images-max", "6", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json figures = run.json()["figures"];
  EXPECT_EQ(figures["found"], 20);
  EXPECT_EQ(figures["checked"], 6);
  EXPECT_EQ(figures["steadiness"]["pairs"], 3);
  EXPECT_EQ(figures["images"][0]["file"], at("frames/0.pgm"));
  EXPECT_EQ(figures["images"][1]["file"], at("frames/1.pgm"));
  EXPECT_EQ(figures["images"][2]["file"], at("frames/6.pgm"));
  EXPECT_THAT(run_aisle({"detect", "--check", frames, "--images-max", "6"}).out,
              HasSubstr("6 images, evenly chosen of 20"));
}

TEST_F(DetectCheck, AListIsReadAsItsImages) {
  folder_of("drive", 6);
  std::string list = "stamp_s,file\n";
  for (int i = 0; i < 6; ++i) list += fmt::format("{},{}.pgm\n", i, i);
  file("drive/images.csv", list);
  const ProgramRun run = run_aisle({"detect", "--check", at("drive"), "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["figures"]["checked"], 6);
  EXPECT_EQ(run.json()["figures"]["images"][5]["file"], at("drive") + "#5");
  EXPECT_THAT(names_in(at("out")), Contains("image-5.overlay.png"));
}

class DetectCheckOfASession : public WorkplaceWithKeys {};

TEST_F(DetectCheckOfASession, ItsImagesAndItsLensAreUsed) {
  ASSERT_EQ(run_aisle(drive("drive")).exit_code, 0);
  const ProgramRun run = run_aisle({"detect", "--check", at("drive"), "--images-max", "10", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["checked"], 10);
  EXPECT_GT(figures["found"], 20);
  EXPECT_EQ(figures["images"][0]["file"], at("drive") + "#0");
  EXPECT_GT(figures["steadiness"]["pairs"], 2);
}

TEST_F(DetectCheck, ABrokenImageIsLeftOutOfAFolderAndRefusedByName) {
  const std::string frames = folder_of("frames", 6);
  const std::string broken = file("frames/9.pgm", "no image");
  const ProgramRun run = run_aisle({"detect", "--check", frames, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["figures"]["left_out"], 1);
  EXPECT_THAT(run.err, HasSubstr("9.pgm"));
  EXPECT_THAT(run_aisle({"detect", "--check", broken, "--json"}), IsRefused("9.pgm: is not an image"));
}

TEST_F(DetectCheck, ALensTellsTheTiltAndMustFit) {
  const auto lens = [](int width) {
    return fmt::format(
        "%YAML:1.0\n---\nimage_width: {}\nimage_height: 240\n"
        "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [250., 0., 159.5, 0., 250., 119.5, 0., 0., 1.]\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n"
        "   dt: d\n   data: [0., 0., 0., 0., 0.]\n",
        width);
  };
  const std::string frames = folder_of("frames", 6);
  const ProgramRun run =
      run_aisle({"detect", "--check", frames, "--calibration", file("lens.yaml", lens(320)), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(run.json()["figures"]["medians"]["tilt_deg"].get<double>(), 0, 1.5);
  EXPECT_THAT(keys_of_hints(run.json()["figures"]), Not(Contains("lens_unknown")));
  EXPECT_THAT(
      run_aisle({"detect", "--check", frames, "--calibration", file("other.yaml", lens(640)), "--json"}),
      IsRefused("0.pgm: has 320 x 240 pixels; the camera's calibration is for 640 x 240"));
}

TEST_F(DetectCheck, MistakesAreRefusedInOneLine) {
  const std::string image = file("a.pgm", corridor_file(-1));
  std::filesystem::create_directory(at("empty"));
  EXPECT_THAT(run_aisle({"detect", "--check", at("none"), "--json"}),
              IsRefused("none: no such file or folder"));
  EXPECT_THAT(run_aisle({"detect", "--check", at("empty"), "--json"}), IsRefused("empty: is no recording"));
  EXPECT_THAT(run_aisle({"detect", "--check", image, "--images-max", "0", "--json"}),
              IsRefused("--images-max"));
  EXPECT_THAT(run_aisle({"detect", "--check", image, "--set", "check.share_min=2", "--json"}),
              IsRefused("check.share_min"));
  EXPECT_THAT(run_aisle({"detect", "--check", image, "--out", image, "--json"}), IsRefused("cannot be made"));
  EXPECT_THAT(run_aisle({"detect", "--json", "--check"}), IsRefused("--check"));
  EXPECT_THAT(run_aisle({"detect", "--check", image, "region", image, "--json"}), IsRefused("--check"));
}

TEST_F(DetectCheck, EverythingThatIsWrongIsSaidAtOnce) {
  const ProgramRun run = run_aisle({"detect", "--check", at("one"), at("two"), "--out", at("out")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("one"));
  EXPECT_THAT(run.err, HasSubstr("two"));
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

TEST_F(DetectCheck, OverlaysAreReplacedOnlyByForce) {
  const std::string image = file("a.pgm", corridor_file(-1));
  ASSERT_EQ(run_aisle({"detect", "--check", image, "--out", at("out")}).exit_code, 0);
  EXPECT_THAT(run_aisle({"detect", "--check", image, "--out", at("out"), "--json"}), IsRefused("--force"));
  EXPECT_EQ(run_aisle({"detect", "--check", image, "--out", at("out"), "--force"}).exit_code, 0);
}

}  // namespace
}  // namespace aisle
