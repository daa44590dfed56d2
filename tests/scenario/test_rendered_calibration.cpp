/// Calibrations from images of the simulated camera, including noise and lens distortion, compared with the
/// camera's true parameters.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "aisle/calibration/board_pose.hpp"
#include "aisle/calibration/laser_calibration.hpp"
#include "aisle/calibration/lens_calibration.hpp"
#include "aisle/calibration/mount_calibration.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"

namespace aisle {
namespace {

/// A plain room of 8 m x 6 m; the vehicle stands at (2, 3), and the wall ahead is `ahead_m` away.
World room(double ahead_m = 6) {
  const Vec2 a(0, 0), b(2 + ahead_m, 0), c(2 + ahead_m, 6), d(0, 6);
  World world;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
    world.walls.push_back({.floor_edge = {from, to}});
  }
  world.lamps = {{.centre = {2, 2}}, {.centre = {2.5, 4}}, {.centre = {5, 3}}};
  return world;
}

const Pose2 kStand{2, 3, 0};

struct Case {
  const char* name;
  CameraIntrinsics lens;
  CameraMount mount;

  friend void PrintTo(const Case& shown, std::ostream* out) { *out << shown.name; }
};

const Case kCases[] = {
    {"Corridor", {460, 460, 319.5, 239.5, -0.18, 0.03, 0, 0, 0}, {{0.85, 0, 1.0}, 14 * kDegree, 0, 0}},
    {"Crooked",
     {530, 534, 330, 232, -0.28, 0.08, 0.001, -0.0008, 0},
     {{0.6, -0.1, 0.8}, 20 * kDegree, 4 * kDegree, -2 * kDegree}},
    {"HighAndSteep",
     {400, 400, 315, 245, 0, 0, 0, 0, 0},
     {{0.8, 0.05, 1.25}, 38 * kDegree, -3 * kDegree, 1 * kDegree}}};

class RenderedCalibration : public testing::TestWithParam<Case> {
 protected:
  CameraDescription camera() const {
    CameraDescription camera;
    camera.intrinsics = GetParam().lens;
    camera.mount = GetParam().mount;
    return camera;
  }

  Image image(const World& world, std::uint64_t number, bool laser_on = false) const {
    CameraMoment moment;
    moment.T_world_vehicle = kStand;
    moment.image = number;
    moment.laser_on = laser_on;
    return CameraSensor(camera(), {}, 1).take(RenderedWorld(world), moment);
  }

  bool is_in_view(const CalibrationBoard& board) const {
    const CameraModel lens(GetParam().lens);
    for (const int column : {-2, board.columns + 1}) {
      for (const int row : {-2, board.rows + 1}) {
        const Vec3 p_vehicle = board.p_world_corner(column, row) - Vec3(kStand.x, kStand.y, 0);
        const auto pixel = lens.project(GetParam().mount.to_camera(p_vehicle));
        if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > 639 || pixel->y() > 479) return false;
      }
    }
    return true;
  }

  /// Held about half a metre before the camera, turned.
  CalibrationBoard held_board(Random& random) const {
    const CameraMount& mount = GetParam().mount;
    while (true) {
      const double away_m = random.uniform(0.4, 0.7);
      const Vec3 p_camera(random.uniform(-0.6, 0.6) * away_m, random.uniform(-0.45, 0.45) * away_m, away_m);
      CalibrationBoard board;
      board.p_world_centre = mount.p_vehicle_camera + mount.R_vehicle_camera() * p_camera;
      board.p_world_centre.head<2>() += kStand.position();
      board.yaw_rad = kPi + mount.pan_rad + random.uniform(-40, 40) * kDegree;
      board.pitch_rad = mount.tilt_rad + random.uniform(-40, 40) * kDegree;
      board.roll_rad = random.uniform(-30, 30) * kDegree;
      if (is_in_view(board)) return board;
    }
  }
};

TEST_P(RenderedCalibration, BoardsHeldBeforeTheCameraGiveItsTrueLens) {
  const Chessboard board{9, 6, 0.03};
  Random random(7);
  std::vector<BoardView> views;
  for (std::uint64_t number = 0; number < 10; ++number) {
    World world = room();
    world.boards = {held_board(random)};
    if (auto corners = find_chessboard(image(world, number), board)) {
      views.push_back({std::to_string(number), std::move(*corners)});
    }
  }
  ASSERT_GE(views.size(), 9U);
  const auto found = calibrate_lens(views, board, 640, 480);
  ASSERT_TRUE(found);
  const CameraIntrinsics &lens = found->intrinsics, &truth = GetParam().lens;
  RecordProperty("fx_error_percent", std::to_string(100 * (lens.fx_px / truth.fx_px - 1)));
  RecordProperty("rms_px", std::to_string(found->rms_px));
  EXPECT_NEAR(lens.fx_px / truth.fx_px, 1, 0.003);
  EXPECT_NEAR(lens.fy_px / truth.fy_px, 1, 0.003);
  EXPECT_NEAR(lens.cx_px, truth.cx_px, 1.5);
  EXPECT_NEAR(lens.cy_px, truth.cy_px, 1.5);
  EXPECT_NEAR(lens.k1, truth.k1, 0.03);
  EXPECT_LT(found->rms_px, 0.2);
}

TEST_P(RenderedCalibration, ABoardOnTheFloorGivesTheTrueMount) {
  const CameraMount& truth = GetParam().mount;
  const Chessboard board{9, 6, 0.08};
  const double ahead_m = truth.p_vehicle_camera.z() / std::tan(truth.tilt_rad + 15 * kDegree);
  const BoardOnFloor place{{truth.p_vehicle_camera.x() + ahead_m, 0.05}, 10 * kDegree};
  World world = room();
  const Vec2 p_world = kStand * place.p_vehicle_centre;
  world.boards = {{.p_world_centre = {p_world.x(), p_world.y(), 0.0001},
                   .yaw_rad = kPi + place.heading_rad,
                   .pitch_rad = kPi / 2,
                   .square_m = board.square_m}};
  const auto corners = find_chessboard(image(world, 1), board);
  ASSERT_TRUE(corners);
  std::vector<FloorMark> marks;
  for (std::size_t i = 0; i < corners->size(); ++i) {
    marks.push_back({(*corners)[i], place.p_vehicle_corners(board)[i]});
  }
  const auto found = calibrate_mount(marks, CameraModel(GetParam().lens), {.pixel_px = 0.2});
  ASSERT_TRUE(found);
  RecordProperty("height_error_mm",
                 std::to_string(1000 * (found->mount.p_vehicle_camera.z() - truth.p_vehicle_camera.z())));
  RecordProperty("tilt_error_deg", std::to_string(to_degrees(found->mount.tilt_rad - truth.tilt_rad)));
  RecordProperty("rms_px", std::to_string(found->rms_px));
  EXPECT_NEAR(found->mount.p_vehicle_camera.z(), truth.p_vehicle_camera.z(), 0.002);
  EXPECT_NEAR(to_degrees(found->mount.tilt_rad), to_degrees(truth.tilt_rad), 0.05);
  EXPECT_NEAR(to_degrees(found->mount.pan_rad), to_degrees(truth.pan_rad), 0.1);
  EXPECT_NEAR(to_degrees(found->mount.roll_rad), to_degrees(truth.roll_rad), 0.1);
}

TEST_P(RenderedCalibration, StripesOnWallsGiveTheTrueLaserHeight) {
  std::vector<StripeView> views;
  for (const double ahead_m : {2.0, 2.5, 3.0}) {
    StripeView view{wall_ahead(ahead_m), {}};
    for (const LaserStripe& stripe : find_laser_stripes(image(room(ahead_m), 3, true))) {
      view.points_px.insert(view.points_px.end(), stripe.points_px.begin(), stripe.points_px.end());
    }
    views.push_back(view);
  }
  const auto found = calibrate_laser(views, CameraModel(GetParam().lens), GetParam().mount);
  ASSERT_TRUE(found);
  RecordProperty("height_error_mm", std::to_string(1000 * (found->height_m - 0.3)));
  EXPECT_NEAR(found->height_m, 0.3, 0.002);
  EXPECT_NEAR(found->slope_ahead, 0, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Cameras, RenderedCalibration, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace aisle
