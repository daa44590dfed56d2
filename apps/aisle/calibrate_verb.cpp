#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>

#include "aisle/commands/calibration/calibrate_camera.hpp"
#include "aisle/commands/calibration/calibrate_floor.hpp"
#include "aisle/commands/calibration/calibrate_laser.hpp"
#include "aisle/core/angle.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

/// "9x6": inner corners per row and per column.
void read_board(const std::string& text, Chessboard& board) {
  const char* const end = text.data() + text.size();
  const auto [times, first] = std::from_chars(text.data(), end, board.columns);
  const bool has_both = first == std::errc() && times != end && *times == 'x';
  const auto [rest, second] = has_both ? std::from_chars(times + 1, end, board.rows)
                                       : std::from_chars_result{end, std::errc::invalid_argument};
  const auto is_valid = [](int corners) { return corners >= 3 && corners <= 50; };
  if (second == std::errc() && rest == end && is_valid(board.columns) && is_valid(board.rows)) return;
  throw CLI::ValidationError(
      "--board", fmt::format("'{}' is not COLUMNSxROWS of inner corners, such as 9x6 (3 to 50 each)", text));
}

/// "x,y,deg"
BoardOnFloor read_place(const std::string& text) {
  std::array<double, 3> values{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    const bool is_last = i + 1 == values.size();
    if (error != std::errc() || std::abs(values[i]) > 1000 || (next == end) != is_last) break;
    if (is_last) return {{values[0], values[1]}, values[2] * kDegree};
    if (*next != ',') break;
    at = next + 1;
  }
  throw CLI::ValidationError(
      "--board-at",
      fmt::format("'{}' is not x,y,degrees (metres; 0 degrees: the upper edge points ahead)", text));
}

template <class Options>
void add_board(CLI::App& verb, const std::shared_ptr<Options>& options) {
  verb.add_option_function<std::string>(
          "--board", [options](const std::string& text) { read_board(text, options->board); },
          "inner corners of the chessboard (default 9x6)")
      ->type_name("COLUMNSxROWS");
  verb.add_option("--square-m", options->board.square_m,
                  "side of a chessboard square in metres (default 0.025)")
      ->check(CLI::Range(0.001, 10.0));
}

template <class Options>
void add_out(CLI::App& verb, const std::shared_ptr<Options>& options) {
  verb.add_option(
      "-o,--out", options->out,
      "output directory for camera.yaml (OpenCV), camera_info.yaml (ROS) and plots of the residuals");
  verb.add_flag("--force", options->force, "overwrite existing results");
}

void add_camera(CLI::App& calibrate, Work& work) {
  CLI::App* verb =
      calibrate.add_subcommand("camera", "calibrate the lens from at least 3 images of a chessboard");
  verb->fallthrough();
  add_examples(
      *verb, {"aisle calibrate camera board-1.png board-2.png board-3.png --square-m 0.03 --out out/lens",
              "aisle calibrate camera board-1.png board-2.png board-3.png --board 7x5 --same-focal-lengths"});
  auto options = std::make_shared<CalibrateCameraOptions>();
  verb->add_option("IMAGES", options->images,
                   "images of the same size that show the board at different tilts")
      ->required();
  add_board(*verb, options);
  verb->add_option("--camera", options->camera_name, "camera name in the output files (default camera)");
  verb->add_flag("--same-focal-lengths", options->lens.same_focal_lengths, "assume square pixels: fx = fy");
  add_out(*verb, options);
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_calibrate_camera(*options, console); };
  });
}

void add_floor(CLI::App& calibrate, Work& work) {
  CLI::App* verb = calibrate.add_subcommand(
      "floor", "calibrate the camera's mount on the vehicle from chessboards or marks on the floor");
  verb->fallthrough();
  add_examples(*verb, {"aisle calibrate floor floor.png --calibration out/lens/camera.yaml --board-at "
                       "1.2,0,0 --out out/mount",
                       "aisle calibrate floor --calibration out/lens/camera.yaml --marks marks.txt"});
  auto options = std::make_shared<CalibrateFloorOptions>();
  verb->add_option("IMAGES", options->images, "images of a chessboard that lies flat on the floor");
  verb->add_option("--calibration", options->camera, "lens calibration (YAML)")->required();
  verb->add_option_function<std::vector<std::string>>(
          "--board-at",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) options->boards_at.push_back(read_place(text));
          },
          "pose of the board on the floor, once per image: centre of its inner corners in metres ahead and "
          "left of base_link, and direction of its upper edge in degrees (0: upright as seen from the "
          "vehicle, with the black outer square at the upper left)")
      ->type_name("X,Y,DEG")
      ->type_size(1)
      ->allow_extra_args(false);
  verb->add_option("--marks", options->marks,
                   "file with marks on the floor, one 'u v x y' per line (pixels, metres)");
  add_board(*verb, options);
  add_out(*verb, options);
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_calibrate_floor(*options, console); };
  });
}

void add_laser(CLI::App& calibrate, Work& work) {
  CLI::App* verb = calibrate.add_subcommand(
      "laser", "calibrate the height and slope of the laser plane from its stripe on walls");
  verb->fallthrough();
  add_examples(
      *verb,
      {"aisle calibrate laser wall.png --calibration out/mount/camera.yaml --wall-at 1.5 --out out/laser",
       "aisle calibrate laser near.png far.png --calibration out/mount/camera.yaml"});
  auto options = std::make_shared<CalibrateLaserOptions>();
  verb->add_option("IMAGES", options->images,
                   "images of the laser stripe on a wall, ideally at several distances")
      ->required();
  verb->add_option("--calibration", options->camera, "calibration of lens and mount (YAML)")->required();
  verb->add_option(
          "--wall-at", options->walls_at_m,
          "perpendicular distance from base_link to the wall ahead in metres, once per image (default: "
          "measured from a chessboard on the wall)")
      ->check(CLI::Range(0.05, 100.0))
      ->allow_extra_args(false);
  add_board(*verb, options);
  add_out(*verb, options);
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_calibrate_laser(*options, console); };
  });
}

}  // namespace

void add_calibrate_verb(CLI::App& app, Work& work) {
  CLI::App* calibrate = app.add_subcommand("calibrate", "calibrate a camera, its mount and the line lasers");
  calibrate->require_subcommand(1);
  calibrate->fallthrough();
  add_camera(*calibrate, work);
  add_floor(*calibrate, work);
  add_laser(*calibrate, work);
  add_examples(*calibrate,
               {"aisle calibrate camera board-1.png board-2.png board-3.png --out out/lens",
                "aisle calibrate floor floor.png --calibration out/lens/camera.yaml --board-at 1.2,0,0"});
}
