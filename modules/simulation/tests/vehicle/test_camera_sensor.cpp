#include "aisle/simulation/vehicle/camera_sensor.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "office_corridor.hpp"

using namespace aisle;

namespace {

constexpr double kPrecision_px = 0.1;

/// Tilted, panned and rolled, with a distorting lens.
CameraDescription ordinary_camera() {
  CameraDescription camera;
  camera.width_px = 322;  // no multiple of a packet's side
  camera.height_px = 239;
  camera.intrinsics = {240, 241, 160.2, 118.7, -0.15, 0.02, 0.001, -0.0005, 0};
  camera.mount = {.p_vehicle_camera = {0.5, 0.05, 1.0},
                  .tilt_rad = 10 * kDegree,
                  .pan_rad = 3 * kDegree,
                  .roll_rad = 2 * kDegree};
  return camera;
}

CameraSensorParams without_faults() {
  CameraSensorParams params;
  params.vignetting = 0;
  params.noise_sigma = 0;
  params.shake_pitch_rad = params.shake_roll_rad = 0;
  params.gamma = 1;
  params.rays_per_pixel = 64;
  return params;
}

Image image_of(const World& world, const CameraMoment& moment = {}) {
  return CameraSensor(ordinary_camera(), without_faults(), 1).take(RenderedWorld(world), moment);
}

Vec2 projected(const Vec3& p_vehicle) {
  const CameraDescription camera = ordinary_camera();
  return CameraModel(camera.intrinsics).project(camera.mount.to_camera(p_vehicle)).value();
}

/// An evenly lit world with a plain dark floor.
World dark_floor() {
  World world;
  world.floor = {.kind = FloorCovering::Kind::kPlain, .brightness = 0.1, .contrast = 0};
  return world;
}

double grey_at(const Image& image, const Vec2& pixel) {
  return image.row(static_cast<int>(std::lround(pixel.y())))[std::lround(pixel.x())];
}

struct Spot {
  Vec2 centre;
  double share_of_pixels = 0;
};

/// Centre and area of what is brighter than the background around a pixel, by its brightness.
Spot bright_spot(const Image& image, const Vec2& around, int half_px) {
  const int u0 = static_cast<int>(std::lround(around.x())), v0 = static_cast<int>(std::lround(around.y()));
  const double background = image.row(v0 - half_px)[u0 - half_px];
  double sum = 0, brightest = 0;
  Vec2 moment = Vec2::Zero();
  for (int v = v0 - half_px; v <= v0 + half_px; ++v) {
    for (int u = u0 - half_px; u <= u0 + half_px; ++u) {
      const double brighter = std::max(0.0, image.row(v)[u] - background - 1);
      sum += brighter;
      brightest = std::max(brightest, brighter);
      moment += brighter * Vec2(u, v);
    }
  }
  return {moment / sum, sum / brightest};
}

/// Centre and area of the quadrilateral that a rectangle of the floor is seen as.
Spot projected_rectangle(const Vec2& centre, const Vec2& size) {
  std::vector<Vec2> outline;
  constexpr int kSteps = 50;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < kSteps; ++i) {
      const double share = static_cast<double>(i) / kSteps - 0.5;
      const Vec2 on_side = side == 0   ? Vec2(share, -0.5)
                           : side == 1 ? Vec2(0.5, share)
                           : side == 2 ? Vec2(-share, 0.5)
                                       : Vec2(-0.5, -share);
      const Vec2 p = centre + on_side.cwiseProduct(size);
      outline.push_back(projected({p.x(), p.y(), 0}));
    }
  }
  Spot spot{Vec2::Zero(), 0};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double twice_area = a.x() * b.y() - b.x() * a.y();
    spot.share_of_pixels += twice_area / 2;
    spot.centre += twice_area * (a + b) / 6;
  }
  spot.centre /= spot.share_of_pixels;
  spot.share_of_pixels = std::abs(spot.share_of_pixels);
  return spot;
}

TEST(CameraSensor, SeesAPaperOnTheFloorWhereTheLensModelProjectsIt) {
  for (const Vec2& centre : {Vec2(2, 0), Vec2(2.2, 0.7), Vec2(3, -0.9), Vec2(2.3, -0.5)}) {
    World world = dark_floor();
    const Vec2 size{0.12, 0.09};
    world.papers = {{.centre = centre, .length_m = size.x(), .width_m = size.y()}};
    const Spot expected = projected_rectangle(centre, size);
    const Spot seen = bright_spot(image_of(world), expected.centre, 14);
    EXPECT_LT((seen.centre - expected.centre).norm(), kPrecision_px) << centre.transpose();
    EXPECT_NEAR(seen.share_of_pixels / expected.share_of_pixels, 1, 0.06) << centre.transpose();
  }
}

/// Where two lines of squares cross: the saddle of a quadratic fitted to the grey levels around it, weighted
/// by their distance.
Vec2 saddle_near(const Image& image, const Vec2& guess) {
  constexpr int kHalf = 5, kRounds = 8;
  constexpr double kSigma_px = 1.5;
  Vec2 saddle = guess;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (int dv = -kHalf; dv <= kHalf; ++dv) {
      for (int du = -kHalf; du <= kHalf; ++du) {
        const Vec2 pixel{std::round(saddle.x()) + du, std::round(saddle.y()) + dv};
        const Vec2 d = pixel - saddle;
        const double weight = std::exp(-d.squaredNorm() / (2 * kSigma_px * kSigma_px));
        Eigen::Matrix<double, 6, 1> row;
        row << d.x() * d.x(), d.x() * d.y(), d.y() * d.y(), d.x(), d.y(), 1;
        normal += weight * row * row.transpose();
        right += weight * row * grey_at(image, pixel);
      }
    }
    const Eigen::Matrix<double, 6, 1> f = normal.inverse() * right;
    Mat2 hessian;
    hessian << 2 * f[0], f[1], f[1], 2 * f[2];
    saddle -= hessian.inverse() * Vec2(f[3], f[4]);
  }
  return saddle;
}

void expect_corners_where_projected(const CalibrationBoard& board) {
  World world = dark_floor();
  world.boards = {board};
  const Image image = image_of(world);
  double squares = 0, worst = 0;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      const Vec2 expected = projected(board.p_world_corner(column, row));
      const double error = (saddle_near(image, expected) - expected).norm();
      squares += error * error;
      worst = std::max(worst, error);
    }
  }
  EXPECT_LT(std::sqrt(squares / (board.rows * board.columns)), kPrecision_px);
  EXPECT_LT(worst, 3 * kPrecision_px);
  const Vec2 upper_left = projected(board.p_world_corner(0, 0)),
             lower_left = projected(board.p_world_corner(0, 1)), next = projected(board.p_world_corner(1, 0));
  const Vec2 outwards = upper_left - next, upwards = upper_left - lower_left;
  EXPECT_LT(grey_at(image, upper_left + (outwards + upwards) / 2), 60);     // the outer square is black
  EXPECT_GT(grey_at(image, upper_left + (outwards - upwards) / 2), 150);    // the one below it white
  EXPECT_GT(grey_at(image, upper_left + 1.5 * (outwards + upwards)), 150);  // the margin
}

TEST(CameraSensor, SeesTheCornersOfAnUprightChessboardWhereTheLensModelProjectsThem) {
  expect_corners_where_projected(
      {.p_world_centre = {1.7, 0, 0.9}, .yaw_rad = kPi + 0.3, .pitch_rad = 0.2, .square_m = 0.05});
}

TEST(CameraSensor, SeesTheCornersOfAChessboardOnTheFloorWhereTheLensModelProjectsThem) {
  expect_corners_where_projected(
      {.p_world_centre = {2.8, 0, 0}, .yaw_rad = kPi, .pitch_rad = kPi / 2, .square_m = 0.15});
}

World wall_ahead(double height_m) {
  World world = dark_floor();
  world.skirting_height_m = 0;
  world.walls = {{.floor_edge = {{3, -5}, {3, 5}}, .height_m = height_m, .brightness = 0.3}};
  return world;
}

CameraMoment with_laser() {
  CameraMoment moment;
  moment.laser_on = true;
  moment.laser_height_m = 0.4;
  return moment;
}

/// Row of the brightest light in a column near a row, by its centre of gravity; nothing if there is none.
std::optional<double> stripe_row(const Image& image, const Vec2& near) {
  const auto u = std::lround(near.x());
  const int v0 = static_cast<int>(std::lround(near.y()));
  const double background = image.row(v0 - 8)[u];
  double sum = 0, moment = 0;
  for (int v = v0 - 6; v <= v0 + 6; ++v) {
    const double brighter = std::max(0.0, image.row(v)[u] - background - 4);
    sum += brighter;
    moment += brighter * v;
  }
  if (sum < 30) return std::nullopt;
  return moment / sum;
}

TEST(CameraSensor, TheLaserStripeRunsAtItsHeightOverTheWall) {
  const Image image = image_of(wall_ahead(2.7), with_laser());
  for (double y = -1.5; y <= 1.5; y += 0.25) {
    const Vec2 expected = projected({3, y, 0.4});
    const auto row = stripe_row(image, expected);
    ASSERT_TRUE(row) << y;
    // The wanted row is the stripe's in this very column.
    const Vec2 beside = projected({3, y + 0.1, 0.4});
    const double slope = (beside.y() - expected.y()) / (beside.x() - expected.x());
    const double wanted = expected.y() + slope * (std::round(expected.x()) - expected.x());
    EXPECT_NEAR(*row, wanted, 2 * kPrecision_px) << y;
  }
}

/// Where the floor mirrors a point to the camera of `ordinary_camera`.
Vec3 mirrored_at(const Vec3& p_vehicle) {
  const Vec3 p_camera = ordinary_camera().mount.p_vehicle_camera;
  const double share = p_camera.z() / (p_camera.z() + p_vehicle.z());
  return {p_camera.x() + share * (p_vehicle.x() - p_camera.x()),
          p_camera.y() + share * (p_vehicle.y() - p_camera.y()), 0};
}

TEST(CameraSensor, APolishedFloorMirrorsTheWallBehindIt) {
  World world = wall_ahead(2.7);
  world.walls[0].brightness = 1;
  const Image dull = image_of(world);
  world.floor.gloss = 0.8;
  const Image polished = image_of(world);
  for (const Vec3& on_wall : {Vec3(3, 0.3, 0.3), Vec3(3, -0.4, 0.5), Vec3(3, 1, 0.8)}) {
    const Vec3 on_floor = mirrored_at(on_wall);
    const Vec3 ray = on_floor - ordinary_camera().mount.p_vehicle_camera;
    const double share = 0.8 * (0.04 + 0.96 * std::pow(1 + ray.z() / ray.norm(), 5));
    const double floor = grey_at(dull, projected(on_floor)), wall = grey_at(dull, projected(on_wall));
    EXPECT_GT(share * (wall - floor), 5);
    EXPECT_NEAR(grey_at(polished, projected(on_floor)), (1 - share) * floor + share * wall, 1.5);
    EXPECT_EQ(grey_at(polished, projected(on_wall)), wall);
  }
}

TEST(CameraSensor, APolishedFloorMirrorsTheStripe) {
  World world = wall_ahead(2.7);
  world.floor.gloss = 1;
  const Image dark = image_of(world), lit = image_of(world, with_laser());
  const Vec2 mirrored = projected(mirrored_at({3, 0.2, 0.4}));
  const auto brighter_at = [&](double below_px) {
    const Vec2 pixel = mirrored + Vec2(0, below_px);
    return grey_at(lit, pixel) - grey_at(dark, pixel);
  };
  EXPECT_GT(brighter_at(0), 4);
  EXPECT_EQ(brighter_at(-4), 0);
  EXPECT_EQ(brighter_at(4), 0);
}

TEST(CameraSensor, PaperOnAPolishedFloorMirrorsNothing) {
  World world = wall_ahead(2.7);
  world.papers = {{.centre = {2, 0}}};
  const Vec2 on_paper = projected({2, 0, 0});
  const double dull = grey_at(image_of(world), on_paper);
  world.floor.gloss = 1;
  EXPECT_EQ(grey_at(image_of(world), on_paper), dull);
}

TEST(CameraSensor, AWallLowerThanTheLightPlaneHasNoStripe) {
  const Image image = image_of(wall_ahead(0.2), with_laser());
  const Vec2 above = projected({3, 0.2, 0.4});
  EXPECT_FALSE(stripe_row(image, above));
}

TEST(CameraSensor, ABoxTakesTheStripeFromTheWallBehindIt) {
  World world = wall_ahead(2.7);
  world.furniture = {{.centre = {1.6, 0.5}, .size = {0.2, 0.2}, .height_m = 0.42, .brightness = 0.3}};
  const Image image = image_of(world, with_laser());
  // From the projector at x = 0.6 the box's shadow on the wall is around y = 1.2; the camera sees over the
  // box.
  EXPECT_FALSE(stripe_row(image, projected({3, 1.2, 0.4})));
  EXPECT_TRUE(stripe_row(image, projected({3, -0.5, 0.4})));
  EXPECT_TRUE(stripe_row(image, projected({1.5, 0.5, 0.4})));
}

TEST(CameraSensor, UnderATableItIsDarkerThanBesideIt) {
  World world = wall_ahead(2.7);
  world.floor.brightness = 0.5;
  world.lamps = {{.centre = {2, 0}}};
  world.furniture = {
      {.kind = Furniture::Kind::kTable, .centre = {2.2, 0.6}, .size = {0.5, 0.8}, .height_m = 0.7}};
  const Image image = image_of(world);
  EXPECT_LT(grey_at(image, projected({2.0, 0.75, 0})) + 20, grey_at(image, projected({2.0, -0.75, 0})));
}

TEST(CameraSensor, WhatIsOnTheLeftIsOnTheLeft) {
  World world = wall_ahead(2.7);
  world.furniture = {{.centre = {2, 0.7}, .size = {0.3, 0.3}, .height_m = 1, .brightness = 1}};
  const Image image = image_of(world);
  EXPECT_GT(grey_at(image, {70, 130}), grey_at(image, {250, 130}) + 50);
}

TEST(CameraSensor, AMovingBodyHidesWhatIsBehindItUntilItIsTakenAway) {
  RenderedWorld world(wall_ahead(2.7));
  CameraSensor sensor(ordinary_camera(), without_faults(), 1);
  const Image empty = sensor.take(world, {});
  const std::vector<MovingBody> bodies = {{.T_world_body = {2, 0, 0}, .size = {0.3, 0.3}, .brightness = 0.9}};
  world.place(bodies);
  const Vec2 on_body = projected({1.85, 0, 0.8});
  EXPECT_GT(grey_at(sensor.take(world, {}), on_body), grey_at(empty, on_body) + 50);
  world.place({});
  EXPECT_EQ(sensor.take(world, {}), empty);
}

CameraMoment driving() {
  CameraMoment moment;
  moment.T_world_vehicle = {1, 0.1, 0.05};
  moment.speed_mps = 0.5;
  moment.turn_rate_rad_s = 0.5;
  moment.laser_on = true;
  moment.image = 7;
  return moment;
}

TEST(CameraSensor, TakesTheSameImageWhateverTheNumberOfThreads) {
  const auto image = [](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    RenderedWorld world(office_corridor(2));
    const std::vector<MovingBody> bodies = {{MovingBody::Kind::kPerson, {4, -0.3, 3}, {0.3, 0.5}}};
    world.place(bodies);
    return CameraSensor(ordinary_camera(), {}, 1).take(world, driving());
  };
  EXPECT_EQ(image(1), image(2));
}

TEST(CameraSensor, TakesTheSameImageWhateverWasTakenBefore) {
  const RenderedWorld bright(office_corridor(2)), other(wall_ahead(2.7));
  CameraSensor sensor(ordinary_camera(), {}, 1);
  const Image first = sensor.take(bright, driving());
  sensor.take(other, driving());
  EXPECT_EQ(sensor.take(bright, driving()), first);
}

TEST(CameraSensor, NoiseIsAsStrongAsItsParameterAndAnotherInEachImage) {
  World world = dark_floor();
  world.floor.brightness = 0.25;  // mid grey
  CameraSensorParams params = without_faults();
  params.gamma = 2;
  const RenderedWorld rendered(world);
  const Image clean = CameraSensor(ordinary_camera(), params, 1).take(rendered, {});
  params.noise_sigma = 3;
  CameraSensor noisy(ordinary_camera(), params, 1);
  CameraMoment moment;
  const Image first = noisy.take(rendered, moment);
  moment.image = 1;
  EXPECT_NE(first, noisy.take(rendered, moment));
  double squares = 0;
  int count = 0;
  for (int v = 190; v < 239; ++v) {
    for (int u = 0; u < 322; ++u, ++count) squares += std::pow(first.row(v)[u] - clean.row(v)[u], 2);
  }
  EXPECT_NEAR(std::sqrt(squares / count), 3, 0.15);
}

TEST(CameraSensor, LampsThatAreOffLeaveTheLightFromEverywhere) {
  World world = wall_ahead(2.7);
  world.floor.brightness = 0.5;
  for (double x = 0; x < 4; x += 1) world.lamps.push_back({.centre = {x, 0}});
  CameraMoment moment;
  const Vec2 place = projected({2, 0, 0});
  const double lit = grey_at(image_of(world, moment), place);
  moment.lamps_on = false;
  const double unlit = grey_at(image_of(world, moment), place);
  EXPECT_NEAR(unlit / lit, world.ambient_light, 0.1);
}

}  // namespace
