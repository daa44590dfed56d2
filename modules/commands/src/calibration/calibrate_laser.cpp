#include "aisle/commands/calibration/calibrate_laser.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/calibration/board_pose.hpp"
#include "aisle/calibration/laser_calibration.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"
#include "calibration/calibration_steps.hpp"

namespace aisle {
namespace {

std::vector<Vec2> stripe_points(const Image& image) {
  std::vector<Vec2> points;
  for (const LaserStripe& stripe : find_laser_stripes(image)) {
    points.insert(points.end(), stripe.points_px.begin(), stripe.points_px.end());
  }
  return points;
}

/// Keeps only points within a board's width of the board: those farther away may be on another wall.
void keep_beside(const std::vector<Vec2>& corners_px, std::vector<Vec2>& points_px) {
  const auto [left, right] = std::minmax_element(corners_px.begin(), corners_px.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  const double width_px = right->x() - left->x();
  const double from_px = left->x() - width_px, to_px = right->x() + width_px;
  std::erase_if(points_px, [=](const Vec2& p) { return p.x() < from_px || p.x() > to_px; });
}

/// The stripe on the wall that the image's chessboard hangs on.
Result<StripeView> view_with_board(const std::filesystem::path& path, const Image& image,
                                   const Chessboard& board, const CameraModel& lens,
                                   const CameraMount& mount) {
  const auto corners_px = find_chessboard(image, board);
  const auto pose = corners_px ? board_pose(*corners_px, board, lens) : std::nullopt;
  if (!pose) {
    return Problem{{path.string()},
                   fmt::format("no whole board with {} x {} inner corners is seen; --wall-at tells the "
                               "distance of a bare wall",
                               board.columns, board.rows)};
  }
  StripeView view{plane_seen(mount, pose->p_camera_board, pose->R_camera_board.col(2)), stripe_points(image)};
  keep_beside(*corners_px, view.points_px);
  return view;
}

Result<std::vector<StripeView>> collect(const CalibrateLaserOptions& options, const CameraCalibration& camera,
                                        Progress& progress) {
  const CameraModel lens(camera.intrinsics);
  std::vector<StripeView> views;
  Problems problems;
  const auto fail = [&](const Problems& more) { problems.insert(problems.end(), more.begin(), more.end()); };
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    progress.report("looking for stripes", i, options.images.size());
    const auto image = read_calibrated_image(options.images[i], camera);
    if (!image) {
      fail(image.problems());
    } else if (!options.walls_at_m.empty()) {
      views.push_back({wall_ahead(options.walls_at_m[i]), stripe_points(*image)});
    } else {
      auto view = view_with_board(options.images[i], *image, options.board, lens, *camera.mount);
      if (!view) fail(view.problems());
      if (view) views.push_back(*view);
    }
  }
  if (!problems.empty()) return problems;
  return views;
}

nlohmann::ordered_json figures_of(const LaserCalibration& c) {
  return {{"laser_height_m", nine_digits(c.height_m)},
          {"slope_ahead_deg", nine_digits(to_degrees(std::atan(c.slope_ahead)))},
          {"slope_left_deg", nine_digits(to_degrees(std::atan(c.slope_left)))},
          {"deviations",
           {{"laser_height_m", nine_digits(c.height_deviation_m)},
            {"slope_ahead_deg", nine_digits(to_degrees(c.slope_ahead_deviation))},
            {"slope_left_deg", nine_digits(to_degrees(c.slope_left_deviation))}}},
          {"rms_px", nine_digits(c.rms_px)},
          {"rms_m", nine_digits(c.rms_m)},
          {"points", c.points},
          {"points_seen", c.points_seen},
          {"verdict", verdict_figures(c.verdict)}};
}

std::string text_of(const LaserCalibration& c) {
  return fmt::format(
             "{} of {} stripe points on one plane: rms {:.2f} px, {:.2f} mm\n"
             "  height {:.4f} +- {:.4f} m, rising {:.3f} deg to the front, {:.3f} deg to the left\n",
             c.points, c.points_seen, c.rms_px, 1000 * c.rms_m, c.height_m, c.height_deviation_m,
             to_degrees(std::atan(c.slope_ahead)), to_degrees(std::atan(c.slope_left))) +
         verdict_text(c.verdict);
}

}  // namespace

Result<Outcome> run_calibrate_laser(const CalibrateLaserOptions& options, Console& console) {
  if (!options.walls_at_m.empty() && options.walls_at_m.size() != options.images.size()) {
    return Problem{{"--wall-at"},
                   fmt::format("is given {} times for {} images; each needs its own",
                               options.walls_at_m.size(), options.images.size())};
  }
  const auto out = open_calibration_directory(options.out, options.force, false);
  if (!out) return out.problems();
  auto camera = read_calibration(options.camera);
  if (!camera) return camera.problems();
  if (!camera->mount) {
    return Problem{{options.camera.string(), 0, "vehicle_mount"},
                   "is missing; 'aisle calibrate floor' finds how the camera sits on the vehicle"};
  }
  const auto views = collect(options, *camera, console.progress);
  if (!views) return views.problems();
  const auto found = calibrate_laser(*views, CameraModel(camera->intrinsics), *camera->mount);
  if (!found) {
    return Problem{
        {options.images.front().string()},
        fmt::format("fewer than {} stripe points agree on a plane: is the laser on, the wall flat, "
                    "the distance right?",
                    kStripePointsMin)};
  }

  Outcome outcome{.verb = "calibrate laser"};
  outcome.ok = found->verdict.quality != CalibrationQuality::kPoor;
  outcome.figures = figures_of(*found);
  outcome.text = text_of(*found);
  if (*out) {
    camera->laser_height_m = found->height_m;
    const auto written = (*out)->write(calibration_files(*camera, std::nullopt));
    if (!written) return written.problems();
    outcome.files = *written;
  }
  return outcome;
}

}  // namespace aisle
