#include "aisle/commands/calibration/calibrate_floor.hpp"

#include <fmt/format.h>

#include <cmath>

#include "aisle/calibration/mount_calibration.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/formats/buildings/floor_marks.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "calibration/calibration_steps.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// The marks of one file.
struct MarkSource {
  std::string name;
  std::size_t count = 0;
};

struct CollectedMarks {
  std::vector<FloorMark> marks;
  std::vector<MarkSource> sources;

  void add(const std::string& name, const std::vector<FloorMark>& more) {
    marks.insert(marks.end(), more.begin(), more.end());
    sources.push_back({name, more.size()});
  }
};

Result<std::vector<FloorMark>> board_marks(const std::filesystem::path& path, const BoardOnFloor& place,
                                           const Chessboard& board, const CameraCalibration& camera) {
  const auto image = read_calibrated_image(path, camera);
  if (!image) return image.problems();
  const auto corners = find_chessboard(*image, board);
  if (!corners) {
    return Problem{
        {path.string()},
        fmt::format("no whole board with {} x {} inner corners is seen", board.columns, board.rows)};
  }
  const std::vector<Vec2> p_vehicle_corners = place.p_vehicle_corners(board);
  std::vector<FloorMark> marks;
  for (std::size_t i = 0; i < corners->size(); ++i) marks.push_back({(*corners)[i], p_vehicle_corners[i]});
  return marks;
}

Result<CollectedMarks> collect(const CalibrateFloorOptions& options, const CameraCalibration& camera) {
  CollectedMarks collected;
  Problems problems;
  const auto add = [&](const std::filesystem::path& path, const Result<std::vector<FloorMark>>& marks) {
    if (marks) {
      collected.add(path.filename().string(), *marks);
    } else {
      problems.insert(problems.end(), marks.problems().begin(), marks.problems().end());
    }
  };
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    add(options.images[i], board_marks(options.images[i], options.boards_at[i], options.board, camera));
  }
  if (options.marks) add(*options.marks, read_floor_marks(*options.marks));
  if (!problems.empty()) return problems;
  return collected;
}

Problems contradictions(const CalibrateFloorOptions& options) {
  if (options.images.size() != options.boards_at.size()) {
    return {{{"--board-at"},
             fmt::format("is given {} times for {} images; each image needs its own",
                         options.boards_at.size(), options.images.size())}};
  }
  if (options.images.empty() && !options.marks) {
    return {{{"--marks"}, "neither images of a board nor a file of marks is given"}};
  }
  if (!options.images.empty() && !options.board.has_one_orientation()) {
    return {{{"--board"},
             fmt::format("a board of {} x {} inner corners looks the same turned half round; one "
                         "with an odd sum, such as 9x6, does not",
                         options.board.columns, options.board.rows)}};
  }
  return {};
}

Json mount_figures(const CameraMount& mount) {
  const auto degrees = [](double angle_rad) { return nine_digits(to_degrees(angle_rad)); };
  const Vec3& p = mount.p_vehicle_camera;
  return {{"x_m", nine_digits(p.x())},         {"y_m", nine_digits(p.y())},
          {"height_m", nine_digits(p.z())},    {"tilt_deg", degrees(mount.tilt_rad)},
          {"pan_deg", degrees(mount.pan_rad)}, {"roll_deg", degrees(mount.roll_rad)}};
}

Json figures_of(const MountCalibration& found, const CollectedMarks& marks) {
  Json figures = mount_figures(found.mount);
  figures["deviations"] = mount_figures(found.deviations);
  figures["rms_px"] = nine_digits(found.rms_px);
  figures["points"] = Json::array();
  for (std::size_t i = 0; i < marks.marks.size(); ++i) {
    const Vec2& residual = found.residuals_px[i];
    Json residual_px = nullptr;
    if (residual.allFinite()) residual_px = {nine_digits(residual.x()), nine_digits(residual.y())};
    figures["points"].push_back({{"pixel_px", {marks.marks[i].pixel_px.x(), marks.marks[i].pixel_px.y()}},
                                 {"residual_px", residual_px},
                                 {"fits", static_cast<bool>(found.fits[i])}});
  }
  figures["verdict"] = verdict_figures(found.verdict);
  return figures;
}

std::string text_of(const MountCalibration& found, const CollectedMarks& marks) {
  const CameraMount &m = found.mount, &d = found.deviations;
  const Vec3 &p = m.p_vehicle_camera, &dp = d.p_vehicle_camera;
  std::string text = fmt::format(
      "{} points on the floor: rms {:.3f} px\n"
      "  height {:.4f} +- {:.4f} m, ahead {:.4f} +- {:.4f} m, left {:.4f} +- {:.4f} m\n"
      "  tilt {:.3f} +- {:.3f}, pan {:.3f} +- {:.3f}, roll {:.3f} +- {:.3f} deg\n",
      marks.marks.size(), found.rms_px, p.z(), dp.z(), p.x(), dp.x(), p.y(), dp.y(), to_degrees(m.tilt_rad),
      to_degrees(d.tilt_rad), to_degrees(m.pan_rad), to_degrees(d.pan_rad), to_degrees(m.roll_rad),
      to_degrees(d.roll_rad));
  for (std::size_t i = 0; i < marks.marks.size(); ++i) {
    if (found.fits[i]) continue;
    const FloorMark& mark = marks.marks[i];
    text += fmt::format("  does not fit: pixel {:.1f} {:.1f} at {:.3f} {:.3f} m\n", mark.pixel_px.x(),
                        mark.pixel_px.y(), mark.p_vehicle.x(), mark.p_vehicle.y());
  }
  return text + verdict_text(found.verdict);
}

double rms_px(const std::vector<Vec2>& residuals_px) {
  double squares = 0, count = 0;
  for (const Vec2& residual : residuals_px) {
    if (!residual.allFinite()) continue;
    squares += residual.squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

/// Files of marks do not give the size of the image: then it is taken as twice the principal point.
ResidualPicture residuals_of(const MountCalibration& found, const CollectedMarks& marks,
                             const CameraCalibration& camera) {
  ResidualPicture image;
  const CameraIntrinsics& lens = camera.intrinsics;
  const auto side = [](int stated_px, double centre_px) {
    return stated_px > 0 ? stated_px : std::max(16, static_cast<int>(std::lround(2 * centre_px)));
  };
  image.width_px = side(camera.width_px, lens.cx_px);
  image.height_px = side(camera.height_px, lens.cy_px);
  image.title = "Mount of " + camera.camera_name;
  image.caption =
      fmt::format("height {:.4f} m, tilt {:.2f} deg, rms {:.3f} px: {}", found.mount.p_vehicle_camera.z(),
                  to_degrees(found.mount.tilt_rad), found.rms_px, to_string(found.verdict.quality));
  std::size_t at = 0;
  for (const MarkSource& source : marks.sources) {
    ResidualGroup& group = image.groups.emplace_back();
    group.name = source.name;
    for (const std::size_t end = at + source.count; at < end; ++at) {
      group.points_px.push_back(marks.marks[at].pixel_px);
      group.residuals_px.push_back(found.residuals_px[at]);
    }
    group.rms_px = rms_px(group.residuals_px);
  }
  return image;
}

}  // namespace

Result<Outcome> run_calibrate_floor(const CalibrateFloorOptions& options, Console& console) {
  if (const Problems problems = contradictions(options); !problems.empty()) return problems;
  const auto out = open_calibration_directory(options.out, options.force, true);
  if (!out) return out.problems();
  auto camera = read_calibration(options.camera);
  if (!camera) return camera.problems();
  console.progress.report("looking for boards", 0, 1);
  const auto marks = collect(options, *camera);
  if (!marks) return marks.problems();
  const std::string first = options.marks ? options.marks->string() : options.images.front().string();
  if (are_on_one_line(marks->marks)) {
    return Problem{{first}, "all points lie on one line of the floor; some must lie beside it"};
  }
  constexpr double kCorner_px = 0.2, kMark_px = 0.5;
  const auto found = calibrate_mount(marks->marks, CameraModel(camera->intrinsics),
                                     {.pixel_px = options.marks ? kMark_px : kCorner_px});
  if (!found) {
    return Problem{{first},
                   "no camera above the floor sees the points so: are pixels (u right, v down) and places "
                   "(x ahead, y left, in metres) right?"};
  }

  Outcome outcome{.verb = "calibrate floor"};
  outcome.ok = found->verdict.quality != CalibrationQuality::kPoor;
  outcome.figures = figures_of(*found, *marks);
  outcome.text = text_of(*found, *marks);
  if (*out) {
    camera->mount = found->mount;
    const auto written = (*out)->write(calibration_files(*camera, residuals_of(*found, *marks, *camera)));
    if (!written) return written.problems();
    outcome.files = *written;
  }
  return outcome;
}

}  // namespace aisle
