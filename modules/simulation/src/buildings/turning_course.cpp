#include "aisle/simulation/buildings/turning_course.hpp"

#include <stdexcept>

namespace aisle {
namespace {

constexpr double kHalf_m = 5;         // the room's
constexpr double kAisle_m = 1.6;      // width
constexpr double kEntry_m = 4;        // before the crossing
constexpr double kExit_m = 3;         // beyond it
constexpr double kLaneApart_m = 2.6;  // of the two lanes of a U-turn

/// Where a turning's crossing is open, as seen on the way in, and where the route leads.
struct Crossing {
  bool ahead = false, left = false, right = false;
  Vec2 towards = Vec2::Zero();
};

Crossing crossing_of(int number) {
  const Vec2 left(-1, 0), right(1, 0), ahead(0, 1);
  switch (number) {
    case 1:
      return {.left = true, .towards = left};
    case 2:
      return {.ahead = true, .left = true, .towards = ahead};
    case 3:
      return {.right = true, .towards = right};
    case 4:
      return {.ahead = true, .right = true, .towards = ahead};
    case 5:
      return {.ahead = true, .right = true, .towards = right};
    case 6:
      return {.left = true, .right = true, .towards = right};
    case 7:
      return {.ahead = true, .left = true, .towards = left};
    case 8:
      return {.left = true, .right = true, .towards = left};
    case 9:
      return {.ahead = true, .left = true, .right = true, .towards = ahead};
    case 10:
      return {.ahead = true, .left = true, .right = true, .towards = left};
    case 11:
      return {.ahead = true, .left = true, .right = true, .towards = right};
    default:
      throw std::invalid_argument("this turning has no crossing");
  }
}

class Course {
 public:
  explicit Course(Random& random) : random_(random) {
    world_.name = "turning";
    world_.floor = {.kind = FloorCovering::Kind::kPlain, .brightness = 0.62, .contrast = 0.04};
    world_.ceiling_m = 3;
    world_.texture_seed = random.bits();
    const Vec2 corners[] = {
        {-kHalf_m, -kHalf_m}, {kHalf_m, -kHalf_m}, {kHalf_m, kHalf_m}, {-kHalf_m, kHalf_m}};
    for (std::size_t i = 0; i < 4; ++i)
      world_.walls.push_back({{corners[i], corners[(i + 1) % 4]}, world_.ceiling_m});
    for (const double x : {-2.5, 0.0, 2.5})
      for (const double y : {-2.5, 0.0, 2.5}) world_.lamps.push_back({.centre = {x, y}});
    world_.start = Pose2{0, -kEntry_m, kPi / 2};
  }

  void add_box(const Vec2& low, const Vec2& high) {
    world_.furniture.push_back({.centre = (low + high) / 2,
                                .size = high - low,
                                .height_m = random_.uniform(0.7, 1.6),
                                .brightness = random_.uniform(0.12, 0.28)});
  }

  World take(int number, std::vector<Vec2> path, const Vec2& at, double reach_m) {
    return take(std::move(path),
                {{.route = "bend", .number = number, .at = at, .before_m = reach_m, .after_m = reach_m}});
  }
  World take(std::vector<Vec2> path, std::vector<TaughtTurning> turnings) {
    world_.routes = {{.name = "bend", .parking = ParkingStrategy::kView, .path = std::move(path)}};
    world_.turnings = std::move(turnings);
    return std::move(world_);
  }

 private:
  Random& random_;
  World world_;
};

World with_crossing(int number, Course course) {
  constexpr double kTurning_m = 1.3;
  const double w = kAisle_m / 2, h = kHalf_m;
  const Crossing crossing = crossing_of(number);
  course.add_box({-h, -h}, {-w, -w});
  course.add_box({w, -h}, {h, -w});
  course.add_box({-h, w}, {-w, h});
  course.add_box({w, w}, {h, h});
  if (!crossing.ahead) course.add_box({-w, w}, {w, h});
  if (!crossing.left) course.add_box({-h, -w}, {-w, w});
  if (!crossing.right) course.add_box({w, -w}, {h, w});
  return course.take(number, {{0, -kEntry_m}, {0, 0}, kExit_m * crossing.towards}, {0, 0}, kTurning_m);
}

/// Around an island between two lanes.
/// @param side  1: to the right, -1: to the left
World turning_about(int number, double side, Course course) {
  constexpr double kTurning_m = kLaneApart_m / 2 + 1.3;
  const double w = kAisle_m / 2, h = kHalf_m;
  const auto box = [&](const Vec2& a, const Vec2& b) {
    const Vec2 p(side * a.x(), a.y()), q(side * b.x(), b.y());
    course.add_box(p.cwiseMin(q), p.cwiseMax(q));
  };
  box({-h, -h}, {-w, h});
  box({w, -h}, {kLaneApart_m - w, -w});
  box({kLaneApart_m + w, -h}, {h, h});
  box({-w, w}, {kLaneApart_m + w, h});
  return course.take(number,
                     {{0, -kEntry_m}, {0, 0}, {side * kLaneApart_m, 0}, {side * kLaneApart_m, -kExit_m}},
                     {side * kLaneApart_m / 2, 0}, kTurning_m);
}

/// @param side  1: to the right, -1: to the left
World with_close_turnings(int first, int second, double side, Course course) {
  constexpr double kFirst_m = 1.2, kSecond_m = 1.4, kApart_m = 1.4;  // widths of the aisles, between middles
  constexpr double kNearSide_m = 0.8, kFarSide_m = 2.2;  // sides of the aisle across, from the route
  constexpr double kBeyond_m = 2.3, kBefore_m = 2.3;     // the second turning, where the route turns back
  constexpr double kTurning_m = 1.3;
  const double h = kHalf_m;
  const auto box = [&](const Vec2& a, const Vec2& b) {
    const Vec2 p(side * a.x(), a.y()), q(side * b.x(), b.y());
    course.add_box(p.cwiseMin(q), p.cwiseMax(q));
  };
  box({-h, -h}, {-kFirst_m / 2, -kNearSide_m});
  box({kFirst_m / 2, -h}, {kApart_m - kSecond_m / 2, -kNearSide_m});
  box({kApart_m + kSecond_m / 2, -h}, {h, -kNearSide_m});
  box({-h, kFarSide_m}, {h, h});
  const double branch_m = 0.3;
  return course.take(
      {{0, -kEntry_m},
       {0, 0},
       {side * kBeyond_m, 0},
       {side * (kApart_m - kBefore_m), 0},
       {side * kApart_m, 0},
       {side * kApart_m, -kExit_m}},
      {{.route = "bend", .number = first, .at = {0, 0}, .before_m = kTurning_m, .after_m = kBeyond_m},
       {.route = "bend",
        .number = second,
        .at = {side * kApart_m, -branch_m},
        .before_m = kBefore_m + branch_m,
        .after_m = kTurning_m}});
}

}  // namespace

World close_turnings_course(int first, int second, Random& random) {
  if (first == 6 && second == 5) return with_close_turnings(first, second, 1, Course(random));
  if (first == 8 && second == 7) return with_close_turnings(first, second, -1, Course(random));
  throw std::invalid_argument("there is no course of these two turnings");
}

World turning_course(int number, Random& random) {
  constexpr int kAboutRight = 12, kAboutLeft = 13;
  if (number == kAboutRight) return turning_about(number, 1, Course(random));
  if (number == kAboutLeft) return turning_about(number, -1, Course(random));
  return with_crossing(number, Course(random));
}

}  // namespace aisle
