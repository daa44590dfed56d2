#include "aisle/commands/calibration/calibrate_camera.hpp"

#include <fmt/format.h>

#include <array>

#include "aisle/core/angle.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "calibration/calibration_steps.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// The images in which the board was found, and the names of the other images.
struct BoardViews {
  int width_px = 0;
  int height_px = 0;
  std::vector<BoardView> found;
  std::vector<std::string> without_board;
};

Result<BoardViews> find_boards(const CalibrateCameraOptions& options, Progress& progress) {
  BoardViews views;
  Problems problems;
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    progress.report("looking for boards", i, options.images.size());
    const auto image = read_image(options.images[i]);
    if (!image) {
      problems.insert(problems.end(), image.problems().begin(), image.problems().end());
      continue;
    }
    if (views.width_px == 0) views.width_px = image->width_px, views.height_px = image->height_px;
    if (image->width_px != views.width_px || image->height_px != views.height_px) {
      problems.push_back({{options.images[i].string()},
                          fmt::format("has {} x {} pixels, the first image {} x {}; a calibration needs "
                                      "images of one size",
                                      image->width_px, image->height_px, views.width_px, views.height_px)});
      continue;
    }
    if (auto corners = find_chessboard(*image, options.board)) {
      views.found.push_back({options.images[i].filename().string(), std::move(*corners)});
    } else {
      views.without_board.push_back(options.images[i].string());
    }
  }
  if (!problems.empty()) return problems;
  return views;
}

Problem too_few(const BoardViews& views, const CalibrateCameraOptions& options) {
  return {{options.images.front().string()},
          fmt::format("the board with {} x {} inner corners is whole in {} of {} images; at least {} are "
                      "needed (is --board right?)",
                      options.board.columns, options.board.rows, views.found.size(), options.images.size(),
                      kLensViewsMin)};
}

Json figures_of(const LensCalibration& lens, const BoardViews& views) {
  const CameraIntrinsics &c = lens.intrinsics, &d = lens.deviations;
  struct Row {
    const char* name;
    double value, deviation;
  };
  const std::array<Row, 9> rows = {{{"fx_px", c.fx_px, d.fx_px},
                                    {"fy_px", c.fy_px, d.fy_px},
                                    {"cx_px", c.cx_px, d.cx_px},
                                    {"cy_px", c.cy_px, d.cy_px},
                                    {"k1", c.k1, d.k1},
                                    {"k2", c.k2, d.k2},
                                    {"p1", c.p1, d.p1},
                                    {"p2", c.p2, d.p2},
                                    {"k3", c.k3, d.k3}}};
  Json figures = {{"width_px", lens.width_px}, {"height_px", lens.height_px}};
  for (const Row& row : rows) {
    figures[row.name] = nine_digits(row.value);
    figures["deviations"][row.name] = nine_digits(row.deviation);
  }
  figures["rms_px"] = nine_digits(lens.rms_px);
  figures["views"] = Json::array();
  for (const CalibratedView& view : lens.views) {
    figures["views"].push_back({{"file", view.name}, {"rms_px", nine_digits(view.rms_px)}});
  }
  figures["without_board"] = views.without_board;
  figures["coverage"] = nine_digits(lens.coverage);
  figures["largest_turn_deg"] = nine_digits(to_degrees(lens.largest_turn_rad));
  figures["verdict"] = verdict_figures(lens.verdict);
  return figures;
}

std::string text_of(const LensCalibration& lens, const BoardViews& views) {
  const CameraIntrinsics &c = lens.intrinsics, &d = lens.deviations;
  std::string text = fmt::format(
      "{} views of the board, {} images without: rms {:.3f} px\n"
      "  fx {:.2f} +- {:.2f}, fy {:.2f} +- {:.2f}, cx {:.2f} +- {:.2f}, cy {:.2f} +- {:.2f} px\n"
      "  k1 {:.4f} +- {:.4f}, k2 {:.4f} +- {:.4f}, p1 {:.5f} +- {:.5f}, p2 {:.5f} +- {:.5f}, k3 {:.4f} +- "
      "{:.4f}\n"
      "  {:.0f} % of the image covered, board turned by up to {:.0f} deg\n",
      lens.views.size(), views.without_board.size(), lens.rms_px, c.fx_px, d.fx_px, c.fy_px, d.fy_px, c.cx_px,
      d.cx_px, c.cy_px, d.cy_px, c.k1, d.k1, c.k2, d.k2, c.p1, d.p1, c.p2, d.p2, c.k3, d.k3,
      100 * lens.coverage, to_degrees(lens.largest_turn_rad));
  for (const CalibratedView& view : lens.views)
    text += fmt::format("  {:<32} {:.3f} px\n", view.name, view.rms_px);
  return text + verdict_text(lens.verdict);
}

ResidualPicture residuals_of(const LensCalibration& lens, const std::string& camera_name) {
  ResidualPicture picture{lens.width_px, lens.height_px, {}, "Calibration of " + camera_name, ""};
  picture.caption =
      fmt::format("{} views, rms {:.3f} px, fx {:.1f}, fy {:.1f}: {}", lens.views.size(), lens.rms_px,
                  lens.intrinsics.fx_px, lens.intrinsics.fy_px, to_string(lens.verdict.quality));
  for (const CalibratedView& view : lens.views) {
    picture.groups.push_back({view.name, view.rms_px, view.corners_px, view.residuals_px});
  }
  return picture;
}

}  // namespace

Result<Outcome> run_calibrate_camera(const CalibrateCameraOptions& options, Console& console) {
  const auto out = open_calibration_directory(options.out, options.force, true);
  if (!out) return out.problems();
  const auto views = find_boards(options, console.progress);
  if (!views) return views.problems();
  for (const std::string& name : views->without_board) console.warn(name + ": no whole board, left out");
  if (views->found.size() < kLensViewsMin) return too_few(*views, options);
  const auto lens =
      calibrate_lens(views->found, options.board, views->width_px, views->height_px, options.lens);
  if (!lens) {
    return Problem{{options.images.front().string()},
                   "the views determine no lens: the board must be turned and moved between the images"};
  }

  Outcome outcome{.verb = "calibrate camera"};
  outcome.ok = lens->verdict.quality != CalibrationQuality::kPoor;
  outcome.figures = figures_of(*lens, *views);
  outcome.text = text_of(*lens, *views);
  if (*out) {
    CameraCalibration calibration;
    calibration.camera_name = options.camera_name;
    calibration.width_px = lens->width_px;
    calibration.height_px = lens->height_px;
    calibration.intrinsics = lens->intrinsics;
    calibration.rms_px = lens->rms_px;
    const auto written =
        (*out)->write(calibration_files(calibration, residuals_of(*lens, options.camera_name)));
    if (!written) return written.problems();
    outcome.files = *written;
  }
  return outcome;
}

}  // namespace aisle
