#include <algorithm>
#include <cmath>

#include "buildings/building_layout.hpp"

namespace aisle {
namespace {

constexpr double kWidthMin_m = 1.2;
constexpr double kWidthMax_m = 3;
constexpr double kTurningRoom_m = 1;  ///< from the end of a corridor to where the tour turns back
constexpr double kMouthMin_m = 2;     ///< least length of a wall between two corridors on one side

class CorridorPlanner {
 public:
  CorridorPlanner(const RandomBuildingRecipe& recipe, Random& random)
      : recipe_(recipe), random_(random), size_m_(recipe.size_m.value_or(between(20, 60))) {
    layout_.wall_thickness_m = between(0.1, 0.3);
  }

  BuildingLayout plan() {
    switch (recipe_.kind) {
      case BuildingKind::kOffice:
        plan_office();
        break;
      case BuildingKind::kRing:
        plan_ring();
        break;
      case BuildingKind::kComb:
        plan_comb();
        break;
      case BuildingKind::kHall:
        plan_hall();
        break;
    }
    return std::move(layout_);
  }

 private:
  /// A dead-end corridor that leaves the main one; up: towards larger y.
  struct Branch {
    double x_m = 0;
    double width_m = 2;
    double length_m = 10;
    bool up = true;
  };

  double between(double min_m, double max_m) { return random_centimetres(random_, min_m, max_m); }
  double share_of_size(double min, double max) {
    return std::round(random_.uniform(min, max) * size_m_ * 100) / 100;
  }
  double width() { return recipe_.corridor_width_m.value_or(between(kWidthMin_m, kWidthMax_m)); }

  void plan_office() {
    const double main_width_m = width();
    std::vector<Branch> branches;
    const auto add = [&](double x_m, bool up) {
      branches.push_back({x_m, width(), share_of_size(0.3, 0.9), up});
    };
    const bool up = with_probability(random_, 0.5);
    const double middle_m = share_of_size(0.35, 0.65);
    switch (random_.index(4)) {
      case 0:  // L
        add(0, up);
        branches.back().x_m = size_m_ - branches.back().width_m / 2;
        break;
      case 1:  // T
        add(middle_m, up);
        break;
      case 2:  // cross
        add(middle_m, true);
        add(middle_m, false);
        break;
      default:  // two T on different sides
        add(share_of_size(0.15, 0.3), up);
        add(share_of_size(0.65, 0.85), !up);
    }
    add_main_with_branches(main_width_m, branches);
  }

  void plan_comb() {
    const double main_width_m = width();
    const bool up = with_probability(random_, 0.5);
    std::vector<Branch> branches;
    const double pitch_m =
        std::max(between(5, 12), recipe_.corridor_width_m.value_or(kWidthMax_m) + kMouthMin_m);
    for (double x = between(2, 3) + kWidthMax_m / 2; x + kWidthMax_m < size_m_; x += pitch_m) {
      branches.push_back({std::round(x * 100) / 100, width(), share_of_size(0.15, 0.5), up});
    }
    add_main_with_branches(main_width_m, branches);
  }

  /// The main corridor lies along x from the origin; the tour visits each branch on the way out.
  void add_main_with_branches(double width_m, const std::vector<Branch>& branches) {
    add_corridor({0, -width_m / 2}, {size_m_, width_m / 2});
    const Vec2 start(kTurningRoom_m, 0);
    std::vector<Vec2>& tour = layout_.tour;
    tour.push_back(start);
    for (const Branch& branch : branches) {
      const double end_m = width_m / 2 + branch.length_m, side = branch.up ? 1 : -1;
      const double low_m = branch.up ? -width_m / 2 : -end_m, high_m = branch.up ? end_m : width_m / 2;
      add_corridor({branch.x_m - branch.width_m / 2, low_m}, {branch.x_m + branch.width_m / 2, high_m});
      const Vec2 junction(branch.x_m, 0), end(branch.x_m, side * (end_m - kTurningRoom_m));
      if (tour.back() != junction) tour.push_back(junction);
      tour.push_back(end);
      tour.push_back(junction);
      add_end(end, side * kPi / 2);
    }
    const Vec2 far(size_m_ - kTurningRoom_m, 0);
    if (far.x() > tour.back().x() + 2) {
      tour.push_back(far);
      add_end(far, 0);
    }
    tour.push_back(start);
    add_end(start, kPi);
  }

  void plan_ring() {
    const double length_m = size_m_;
    const double depth_m = std::max(12.0, share_of_size(0.45, 0.9));
    const double bottom = width(), top = width(), left = width(), right = width();
    add_corridor({0, 0}, {length_m, bottom});
    add_corridor({0, depth_m - top}, {length_m, depth_m});
    add_corridor({0, 0}, {left, depth_m});
    add_corridor({length_m - right, 0}, {length_m, depth_m});
    const Vec2 start(length_m / 2, bottom / 2);
    const std::vector<Vec2> corners = {{length_m - right / 2, bottom / 2},
                                       {length_m - right / 2, depth_m - top / 2},
                                       {left / 2, depth_m - top / 2},
                                       {left / 2, bottom / 2}};
    layout_.tour = {start};
    if (with_probability(random_, 0.5)) add_stub(length_m, depth_m, right);
    layout_.tour.insert(layout_.tour.end(), corners.begin(), corners.end());
    layout_.tour.push_back(start);
    layout_.tour.push_back(corners[0]);  // a part of the second round: the loop is seen to close
    add_place("south", start, 0);
    add_place("north", {length_m / 2, depth_m - top / 2}, kPi);
    add_place("east", {length_m - right / 2, depth_m / 2}, kPi / 2);
    add_place("west", {left / 2, depth_m / 2}, -kPi / 2);
  }

  /// A dead end to the right of the ring; the tour enters it when it comes by.
  void add_stub(double length_m, double depth_m, double right_width_m) {
    const double stub_m = width(), y = std::round(between(0.4, 0.6) * depth_m),
                 x = length_m - right_width_m / 2;
    const double end_m = length_m + between(5, 12);
    add_corridor({length_m - right_width_m, y - stub_m / 2}, {end_m, y + stub_m / 2});
    const Vec2 end(end_m - kTurningRoom_m, y);
    for (const Vec2& p : {Vec2(x, layout_.tour.back().y()), Vec2(x, y), end, Vec2(x, y)})
      layout_.tour.push_back(p);
    add_end(end, 0);
  }

  void plan_hall() {
    const Vec2 hall(between(8, 16), between(7, 12));
    add_corridor({0, 0}, hall);
    const Vec2 middle = hall / 2;
    layout_.tour = {middle};
    add_place("hall", middle, 0);
    const std::size_t corridors = 2 + random_.index(3);
    const std::size_t first = random_.index(4);
    for (std::size_t i = 0; i < corridors; ++i) add_hall_corridor(hall, (first + i) % 4);
  }

  /// Sides of the hall: right, top, left, bottom.
  void add_hall_corridor(const Vec2& hall, std::size_t side) {
    const double width_m = width(), length_m = share_of_size(0.3, 1);
    const bool along_x = side % 2 == 0;
    const double across_m = along_x ? hall.y() : hall.x();
    const double at_m = between(width_m / 2 + 0.5, across_m - width_m / 2 - 0.5);
    const double mouth_m = side == 0 ? hall.x() : side == 1 ? hall.y() : 0;
    const double outwards = side < 2 ? 1 : -1;
    const auto point = [&](double along_m, double offset_m) {
      const double a = mouth_m + outwards * along_m, b = at_m + offset_m;
      return along_x ? Vec2(a, b) : Vec2(b, a);
    };
    const Vec2 a = point(0, -width_m / 2), b = point(length_m, width_m / 2);
    add_corridor(a.cwiseMin(b), a.cwiseMax(b));
    const Vec2 middle = layout_.tour.front(), inside = point(-2, 0),
               end = point(length_m - kTurningRoom_m, 0);
    for (const Vec2& p : {inside, end, inside, middle}) layout_.tour.push_back(p);
    add_end(end, Segment2{inside, end}.heading());
  }

  void add_corridor(const Vec2& min, const Vec2& max) { layout_.corridors.push_back({min, max}); }

  void add_place(const std::string& name, const Vec2& p, double heading_rad) {
    layout_.places.push_back({name, {p.x(), p.y(), heading_rad}});
  }
  void add_end(const Vec2& p, double heading_rad) {
    add_place("end " + std::to_string(++ends_), p, heading_rad);
  }

  const RandomBuildingRecipe& recipe_;
  Random& random_;
  double size_m_;
  BuildingLayout layout_;
  int ends_ = 0;
};

}  // namespace

double random_centimetres(Random& random, double min_m, double max_m) {
  return std::round(random.uniform(min_m, max_m) * 100) / 100;
}

bool with_probability(Random& random, double probability) {
  return random.uniform() < probability;
}

BuildingLayout random_corridors(const RandomBuildingRecipe& recipe, Random& random) {
  return CorridorPlanner(recipe, random).plan();
}

}  // namespace aisle
