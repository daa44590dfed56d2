#include <Eigen/Geometry>

#include "rendering/scene_plan.hpp"

namespace aisle {
namespace {

constexpr double kPaint_m = 0.0001;  ///< how far above the floor what is painted on it lies
constexpr double kPaper_m = 0.0002;
constexpr double kPosterRelief_m = 0.004;
constexpr double kBoardRelief_m = 0.015;
constexpr double kBoardFrame_m = 0.02;

/// A level rectangle that faces up.
Panel lying(const Pose2& T_world_centre, const Vec2& size, double height_m, int material) {
  const Vec2 corner = T_world_centre * Vec2(size.x() / 2, -size.y() / 2);
  const Vec2 along = rotate(T_world_centre.theta, {-size.x(), 0});
  const Vec2 up = rotate(T_world_centre.theta, {0, size.y()});
  return {.corner = {corner.x(), corner.y(), height_m},
          .along = {along.x(), along.y(), 0},
          .up = {up.x(), up.y(), 0},
          .material = material};
}

/// An image that hangs: pattern coordinates run to the right and down for its viewer.
Panel hanging(const Vec3& p_world_upper_left, const Vec3& rightwards, const Vec3& downwards, int material) {
  return {.corner = p_world_upper_left,
          .along = rightwards,
          .up = downwards,
          .material = material,
          .pattern = Panel::Pattern::kFilling};
}

void add_poster(const Poster& poster, Materials& materials, Panels& panels) {
  const Vec2 outward = unit(poster.facing_rad), right = left_normal(outward);
  const bool is_board = poster.kind == Poster::Kind::kNoticeBoard;
  if (is_board) {
    add_prism(box({poster.centre.x(), poster.centre.y(), poster.facing_rad},
                  {2 * kBoardRelief_m, poster.width_m}, poster.bottom_m, poster.bottom_m + poster.height_m),
              materials.paint(0.6), panels);
  }
  const double margin_m = is_board ? kBoardFrame_m : 0;
  const double relief_m = is_board ? kBoardRelief_m + 1e-3 : kPosterRelief_m;
  const Vec2 left_end = poster.centre + relief_m * outward - (poster.width_m / 2 - margin_m) * right;
  const double width_m = poster.width_m - 2 * margin_m, height_m = poster.height_m - 2 * margin_m;
  panels.push_back(hanging({left_end.x(), left_end.y(), poster.bottom_m + poster.height_m - margin_m},
                           {width_m * right.x(), width_m * right.y(), 0}, {0, 0, -height_m},
                           is_board ? materials.notice_board() : materials.poster()));
}

void add_parking_frame(const ParkingFrame& frame, Materials& materials, Panels& panels) {
  const Pose2 T_world_frame{frame.centre.x(), frame.centre.y(), frame.heading_rad};
  const int paint = materials.paint(frame.brightness);
  const Vec2 middle = (frame.size - Vec2::Constant(frame.line_width_m)) / 2;
  for (const double side : {-1.0, 1.0}) {
    panels.push_back(lying(T_world_frame * Pose2{side * middle.x(), 0, 0},
                           {frame.line_width_m, frame.size.y()}, kPaint_m, paint));
    panels.push_back(lying(T_world_frame * Pose2{0, side * middle.y(), 0},
                           {frame.size.x() - 2 * frame.line_width_m, frame.line_width_m}, kPaint_m, paint));
  }
}

void add_lamp(const Lamp& lamp, double ceiling_m, Materials& materials, Panels& panels) {
  constexpr double kBelowCeiling_m = 0.005;
  Panel panel = lying({lamp.centre.x(), lamp.centre.y(), lamp.heading_rad}, {lamp.length_m, lamp.width_m},
                      ceiling_m - kBelowCeiling_m, materials.lamp(lamp.power));
  std::swap(panel.along, panel.up);
  panels.push_back(panel);
}

/// The print, and the grey back of the board.
void add_board(const CalibrationBoard& board, Materials& materials, Panels& panels) {
  constexpr double kThickness_m = 0.004;
  const Mat3 R_world_print = board.R_world_print();
  const Vec2 size = board.size_m();
  const Vec3 right = R_world_print.col(0) * size.x(), down = R_world_print.col(1) * size.y();
  const Vec3 corner = board.p_world_centre - (right + down) / 2;
  Panel print = hanging(corner, right, down, materials.chessboard(board));
  panels.push_back(print);
  Panel back = hanging(corner + R_world_print.col(2) * kThickness_m, down, right, materials.paint(0.5));
  back.pattern = Panel::Pattern::kMetres;
  panels.push_back(back);
}

}  // namespace

void add_furnishing(const World& world, Materials& materials, Panels& panels) {
  for (const Furniture& piece : world.furniture) {
    const int material = materials.paint(piece.brightness);
    for (const Prism& part : parts_of(piece)) add_prism(part, material, panels);
  }
  for (const Poster& poster : world.posters) add_poster(poster, materials, panels);
  for (const ParkingFrame& frame : world.parking_frames) add_parking_frame(frame, materials, panels);
  for (const FloorPaper& paper : world.papers) {
    panels.push_back(lying({paper.centre.x(), paper.centre.y(), paper.heading_rad},
                           {paper.length_m, paper.width_m}, kPaper_m, materials.paint(paper.brightness)));
  }
  for (const Lamp& lamp : world.lamps) add_lamp(lamp, world.ceiling_m, materials, panels);
  for (const CalibrationBoard& board : world.boards) add_board(board, materials, panels);
}

}  // namespace aisle
