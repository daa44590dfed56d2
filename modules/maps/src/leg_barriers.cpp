#include "aisle/maps/leg_barriers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/principal_direction.hpp"

namespace aisle {
namespace {

constexpr double kRing_m = 0.25;               // ring around a leg: nothing else stands there
constexpr double kWallAround_m = 0.1;          // beyond the ring, to see how a wall there goes on
constexpr double kRingFreeShare = 0.5;         // free share of the ring; the rest may be hidden ...
constexpr double kHidden_rad = 158 * kDegree;  // ... in one piece: a wall hides half of the ring
constexpr double kFreeAtWallShare = 0.4;       // free share where a wall takes up the other side
constexpr double kBehindBeside_m = 0.09;       // a wall behind a leg goes on this far to both sides
constexpr double kBlurAtWall_m = 0.1;   // blur of a leg at a wall, which is distinguished from the wall
constexpr double kAcrossMin = 0.8;      // cosine: a wall lies behind two legs, not beside them
constexpr double kWallGoesOn_m = 0.15;  // to both sides of its nearest point: not a corner or an end
constexpr double kWallPiece_m = 0.3;    // of the wall, to both sides, gives its direction
constexpr double kStraightMin = 0.94;   // cosine: the nearest point lies straight across the wall
constexpr double kPieceMin_m = 0.3;  // legs nearer to each other carry two pieces of furniture, side by side
constexpr double kBesideOut_m = 0.15;  // floor this far beside what stands out of a wall is free
constexpr double kLegDeepCells = 1.5;  // the wall that a leg stands before lies this far behind its front
constexpr double kLineStepCells = 0.5;
constexpr std::size_t kRowMin = 8;     // small obstacles: a wall in pieces, if there are this many ...
constexpr double kRow_m = 2;           // ... in a segment this long ...
constexpr double kRowBeside_m = 0.06;  // ... this near to a line ...
constexpr double kInLine_m = 4;        // ... and on it, within this distance, a wall ...
constexpr double kLongWall_m = 1;      // ... as long as this

template <class Visit>
void for_cells_around(FloorCell middle, int reach, Visit visit) {
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) visit(FloorCell{x, y});
  }
}

/// From one point straight to another, both included.
template <class Visit>
void for_cells_on_line(const FloorGrid& floor, const Vec2& from, const Vec2& to, Visit visit) {
  const int steps =
      std::max(1, static_cast<int>(std::ceil((to - from).norm() / (kLineStepCells * floor.cell_m()))));
  for (int i = 0; i <= steps; ++i) visit(floor.cell_at(Vec2(from + (to - from) * i / steps)));
}

/// Whether anything stands within a square around a point.
bool stands_about(const FloorGrid& floor, const Vec2& p_map, double within_m) {
  bool stands = false;
  for_cells_around(floor.cell_at(p_map), static_cast<int>(within_m / floor.cell_m()),
                   [&](FloorCell cell) { stands = stands || floor.at(cell) == Floor::kOccupied; });
  return stands;
}

Vec2 mean_direction(std::span<const Vec2> away) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& one : away) sum += one;
  return sum.normalized();
}

/// Whether the wall lies all on one side, and wide: it goes on behind the leg and does not end here.
bool lies_behind(const Vec2& behind, std::span<const Vec2> to_wall) {
  const Vec2 lateral = left_normal(behind);
  double left_m = 0, right_m = 0;
  for (const Vec2& away : to_wall) {
    if (behind.dot(away) <= 0) return false;
    left_m = std::max(left_m, lateral.dot(away));
    right_m = std::max(right_m, -lateral.dot(away));
  }
  return std::min(left_m, right_m) >= kBehindBeside_m;
}

/// The widest angular gap between directions.
double widest_gap_rad(std::vector<double>& headings_rad) {
  if (headings_rad.empty()) return 2 * kPi;
  std::sort(headings_rad.begin(), headings_rad.end());
  double widest_rad = headings_rad.front() + 2 * kPi - headings_rad.back();
  for (std::size_t i = 1; i < headings_rad.size(); ++i)
    widest_rad = std::max(widest_rad, headings_rad[i] - headings_rad[i - 1]);
  return widest_rad;
}

/// Whether a segment that contains the origin holds kRowMin of these.
bool is_crowded(std::vector<double>& along_m) {
  std::sort(along_m.begin(), along_m.end());
  for (std::size_t i = 0; i + kRowMin <= along_m.size() && along_m[i] <= 0; ++i) {
    const double end_m = along_m[i + kRowMin - 1];
    if (end_m >= 0 && end_m - along_m[i] <= kRow_m) return true;
  }
  return false;
}

/// Whether the cell is in a straight row of more than `wide` cells along the rows, the columns or the
/// diagonals: most walls are.
bool is_in_long_row(const FloorGrid& floor, FloorCell cell, int wide) {
  constexpr FloorCell kAlong[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  return std::any_of(std::begin(kAlong), std::end(kAlong), [&](FloorCell along) {
    const auto stands = [&](int i) {
      return floor.at(FloorCell{cell.x + i * along.x, cell.y + i * along.y}) == Floor::kOccupied;
    };
    int low = 0, end = 1;
    while (end - low <= wide && stands(low - 1)) --low;
    while (end - low <= wide && stands(end)) ++end;
    return end - low > wide;
  });
}

/// Whether a long wall stands on the line along an axis through a point.
bool wall_stands_in_line(const FloorGrid& floor, const Vec2& p_map, FloorCell axis) {
  const FloorCell middle = floor.cell_at(p_map);
  const int reach = static_cast<int>(kInLine_m / floor.cell_m());
  const int long_cells = static_cast<int>(kLongWall_m / floor.cell_m());
  int run = 0;
  for (int i = -reach; i <= reach; ++i) {
    bool stands = false;
    for (int lateral = -1; lateral <= 1; ++lateral) {
      const FloorCell cell{middle.x + i * axis.x + lateral * axis.y,
                           middle.y + i * axis.y + lateral * axis.x};
      stands = stands || floor.at(cell) == Floor::kOccupied;
    }
    run = stands ? run + 1 : 0;
    if (run >= long_cells) return true;
  }
  return false;
}

}  // namespace

void LegParams::describe(FieldList& fields) {
  fields.real("leg_max_m", leg_max_m, {0.05, 0.5}, "greatest apparent width of a furniture leg");
  fields.real("apart_max_m", apart_max_m, {0, 5},
              "the vehicle never drives between legs within this of each other");
  fields.real("plate_min_m", plate_min_m, {0.1, 2},
              "legs farther apart carry a table that one may drive under");
  fields.real("wall_max_m", wall_max_m, {0, 2},
              "a table's legs this near to the wall behind it close the floor in between");
}

FloorBox LegBarriers::update(const FloorGrid& floor, const FloorBox& changed) {
  if (changed.empty()) return {};
  const auto cells = [&](double m) { return static_cast<int>(std::ceil(m / floor.cell_m())) + 1; };
  const FloorBox within = changed.widened(cells(params_.leg_max_m + kRing_m + kWallAround_m));
  std::vector<FloorCell> opened = find_obstacles(floor, within);
  const FloorBox about = within.widened(cells(params_.wall_max_m + 2 * params_.leg_max_m + kRow_m));
  std::vector<FloorBox> to_update = {about};
  for (Obstacle& obstacle : obstacles_) {
    const bool was_of_wall = std::exchange(obstacle.is_of_wall, is_piece_of_wall(floor, obstacle));
    if (obstacle.is_of_wall != was_of_wall) to_update.emplace_back().include(obstacle.first);
  }
  for (Obstacle& obstacle : obstacles_) {
    if (about.contains(obstacle.first)) find_walls(floor, obstacle);
  }
  for (FloorBox& box : to_update)
    box = box.widened(cells(params_.apart_max_m + params_.wall_max_m + 3 * params_.leg_max_m));
  return close_again(floor, to_update, std::move(opened));
}

/// Closes again what the obstacles in these boxes close; what the others close does not depend on the change.
/// @param opened  what obstacles closed that are gone
FloorBox LegBarriers::close_again(const FloorGrid& floor, std::span<const FloorBox> boxes,
                                  std::vector<FloorCell> opened) {
  std::vector<FloorCell> closed;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    Obstacle& obstacle = obstacles_[i];
    const auto holds = [&](const FloorBox& box) { return box.contains(obstacle.first); };
    if (std::none_of(boxes.begin(), boxes.end(), holds)) continue;
    opened.insert(opened.end(), obstacle.closes.begin(), obstacle.closes.end());
    obstacle.closes = cells_closed_by(floor, i);
    closed.insert(closed.end(), obstacle.closes.begin(), obstacle.closes.end());
  }
  std::sort(opened.begin(), opened.end());
  std::sort(closed.begin(), closed.end());
  std::vector<FloorCell> left, now;
  std::set_difference(closed_.begin(), closed_.end(), opened.begin(), opened.end(), std::back_inserter(left));
  std::merge(left.begin(), left.end(), closed.begin(), closed.end(), std::back_inserter(now));
  const std::vector<FloorCell> before = std::exchange(closed_, std::move(now));
  FloorBox box;
  for (const std::vector<FloorCell>* cells : {&opened, &closed}) {
    for (const FloorCell cell : *cells) {
      if (is_closed(cell) != std::binary_search(before.begin(), before.end(), cell)) box.include(cell);
    }
  }
  return box;
}

bool LegBarriers::is_closed(FloorCell cell) const {
  return std::binary_search(closed_.begin(), closed_.end(), cell);
}

std::size_t LegBarriers::legs() const {
  return static_cast<std::size_t>(std::count_if(obstacles_.begin(), obstacles_.end(),
                                                [](const Obstacle& obstacle) { return obstacle.is_leg(); }));
}

/// @return what the previous obstacles there closed
std::vector<FloorCell> LegBarriers::find_obstacles(const FloorGrid& floor, const FloorBox& within) {
  const auto looked_for_again =
      std::partition(obstacles_.begin(), obstacles_.end(),
                     [&](const Obstacle& obstacle) { return !within.contains(obstacle.first); });
  std::vector<FloorCell> opened;
  for (auto obstacle = looked_for_again; obstacle != obstacles_.end(); ++obstacle)
    opened.insert(opened.end(), obstacle->closes.begin(), obstacle->closes.end());
  obstacles_.erase(looked_for_again, obstacles_.end());
  for (int y = within.low.y; y < within.end.y; ++y) {
    for (int x = within.low.x; x < within.end.x; ++x) {
      const FloorCell first{x, y};
      if (floor.at(first) != Floor::kOccupied) continue;
      const std::vector<FloorCell> cells = small_obstacle(floor, first);
      if (cells.empty()) {
        if (auto leg = leg_of_wall(floor, first)) obstacles_.push_back(std::move(*leg));
        continue;
      }
      const bool begins_here =
          std::none_of(cells.begin(), cells.end(), [&](FloorCell cell) { return cell < first; });
      if (!begins_here) continue;
      Vec2 p_map = Vec2::Zero();
      for (const FloorCell cell : cells) p_map += floor.centre(cell) / static_cast<double>(cells.size());
      Obstacle obstacle{.p_map = p_map, .walls = {}, .closes = {}, .first = first};
      look_about(floor, obstacle);
      obstacles_.push_back(std::move(obstacle));
    }
  }
  std::sort(obstacles_.begin(), obstacles_.end(),
            [](const Obstacle& a, const Obstacle& b) { return a.first < b.first; });
  return opened;
}

bool LegBarriers::is_piece_of_wall(const FloorGrid& floor, const Obstacle& obstacle) const {
  std::vector<double> along_x_m, along_y_m;
  for (const Obstacle& other : obstacles_around(floor, obstacle.p_map, kRow_m)) {
    const Vec2 away = other.p_map - obstacle.p_map;
    if (std::abs(away.y()) <= kRowBeside_m && std::abs(away.x()) <= kRow_m) along_x_m.push_back(away.x());
    if (std::abs(away.x()) <= kRowBeside_m && std::abs(away.y()) <= kRow_m) along_y_m.push_back(away.y());
  }
  return (is_crowded(along_x_m) && wall_stands_in_line(floor, obstacle.p_map, {1, 0})) ||
         (is_crowded(along_y_m) && wall_stands_in_line(floor, obstacle.p_map, {0, 1}));
}

void LegBarriers::find_walls(const FloorGrid& floor, Obstacle& obstacle) const {
  obstacle.walls.clear();
  const int reach = static_cast<int>(std::ceil(params_.wall_max_m / floor.cell_m()));
  for_cells_around(floor.cell_at(obstacle.p_map), reach, [&](FloorCell cell) {
    if (floor.at(cell) != Floor::kOccupied) return;
    const Vec2 p_map = floor.centre(cell);
    const double away_m = (p_map - obstacle.p_map).norm();
    if (away_m <= params_.leg_max_m || away_m >= params_.wall_max_m || is_leg(floor, p_map)) return;
    obstacle.walls.push_back(p_map);
  });
}

int LegBarriers::leg_cells(const FloorGrid& floor) const {
  return std::max(1, static_cast<int>(std::lround(params_.leg_max_m / floor.cell_m())));
}

/// The cells connected to one cell; none if they are too many for a leg.
std::vector<FloorCell> LegBarriers::small_obstacle(const FloorGrid& floor, FloorCell start) const {
  const int wide = leg_cells(floor);
  if (is_in_long_row(floor, start, wide)) return {};
  std::vector<FloorCell> cells = {start};
  FloorBox box;
  box.include(start);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    bool fits = true;
    for_cells_around(FloorCell(cells[i]), 1, [&](FloorCell next) {
      if (!fits || floor.at(next) != Floor::kOccupied) return;
      if (std::find(cells.begin(), cells.end(), next) != cells.end()) return;
      box.include(next);
      fits = box.end.x - box.low.x <= wide && box.end.y - box.low.y <= wide;
      cells.push_back(next);
    });
    if (!fits) return {};
  }
  return cells;
}

/// A leg so near to an axis-parallel wall that their cells are connected: a few cells stand out of the wall.
/// @param first  the first of the outermost cells
std::optional<LegBarriers::Obstacle> LegBarriers::leg_of_wall(const FloorGrid& floor, FloorCell first) const {
  const int wide = leg_cells(floor);
  const int beside = static_cast<int>(std::lround(kBesideOut_m / floor.cell_m()));
  for (const FloorCell out : {FloorCell{1, 0}, FloorCell{-1, 0}, FloorCell{0, 1}, FloorCell{0, -1}}) {
    const FloorCell lateral{std::abs(out.y), std::abs(out.x)};
    const auto cell = [&](int along, int deep) {
      return FloorCell{first.x + along * lateral.x - deep * out.x,
                       first.y + along * lateral.y - deep * out.y};
    };
    const auto are_all = [&](Floor kind, int from, int end, int deep) {
      for (int along = from; along < end; ++along) {
        if (floor.at(cell(along, deep)) != kind) return false;
      }
      return true;
    };
    const auto lies_beside = [&](Floor kind, int width, int deep) {
      return are_all(kind, -beside, -1, deep) && are_all(kind, width + 1, width + beside, deep);
    };
    int width = 1;
    while (width <= wide && floor.at(cell(width, 0)) == Floor::kOccupied) ++width;
    const bool is_tip = width <= wide && are_all(Floor::kFree, -beside, width + beside, -1);
    if (!is_tip || !lies_beside(Floor::kFree, width, 0) || !lies_beside(Floor::kFree, width, 1)) continue;
    for (int deep = 2; deep <= wide; ++deep) {
      if (!lies_beside(Floor::kOccupied, width, deep)) continue;
      const Vec2 p_map = (floor.centre(first) + floor.centre(cell(width - 1, 0))) / 2;
      return Obstacle{.p_map = p_map,
                      .behind = -Vec2(out.x, out.y),
                      .walls = {},
                      .closes = {},
                      .first = first,
                      .stand = Stand::kBeforeWall};
    }
  }
  return std::nullopt;
}

void LegBarriers::look_about(const FloorGrid& floor, Obstacle& obstacle) const {
  const int reach = static_cast<int>(std::ceil((kRing_m + kWallAround_m) / floor.cell_m())) + 1;
  bool at_wall = false;
  double ring = 0;
  std::vector<double> free_rad;
  std::vector<Vec2> to_wall;
  for_cells_around(floor.cell_at(obstacle.p_map), reach, [&](FloorCell cell) {
    const Vec2 away = floor.centre(cell) - obstacle.p_map;
    const double beyond_m = away.norm() - kRing_m;
    if (beyond_m > kWallAround_m) return;
    if (floor.at(cell) == Floor::kOccupied && small_obstacle(floor, cell).empty()) {
      to_wall.push_back(away);
      at_wall = at_wall || beyond_m <= floor.cell_m() / 2;
    }
    if (std::abs(beyond_m) > floor.cell_m() / 2) return;
    ++ring;
    if (floor.at(cell) == Floor::kFree) free_rad.push_back(heading_of(away));
  });
  const double free_share = static_cast<double>(free_rad.size()) / ring;
  if (!at_wall) {
    const bool is_free = free_share >= kRingFreeShare && widest_gap_rad(free_rad) <= kHidden_rad;
    obstacle.stand = is_free ? Stand::kFree : Stand::kUnclear;
    return;
  }
  obstacle.behind = mean_direction(to_wall);
  const bool is_before_wall = free_share >= kFreeAtWallShare && lies_behind(obstacle.behind, to_wall);
  obstacle.stand = is_before_wall ? Stand::kBeforeWall : Stand::kUnclear;
}

/// All obstacles within a distance of a point, and others in the same rows: O(log of all).
std::span<const LegBarriers::Obstacle> LegBarriers::obstacles_around(const FloorGrid& floor,
                                                                     const Vec2& p_map,
                                                                     double within_m) const {
  const int row = floor.cell_at(p_map).y;
  const int reach = static_cast<int>(std::ceil(within_m / floor.cell_m())) + leg_cells(floor) + 1;
  const auto begin = std::lower_bound(obstacles_.begin(), obstacles_.end(), row - reach,
                                      [](const Obstacle& obstacle, int y) { return obstacle.first.y < y; });
  const auto end = std::upper_bound(begin, obstacles_.end(), row + reach,
                                    [](int y, const Obstacle& obstacle) { return y < obstacle.first.y; });
  return {begin, end};
}

/// Whether the occupied point belongs to a leg, not to the wall behind it.
bool LegBarriers::is_leg(const FloorGrid& floor, const Vec2& p_map) const {
  const double deep_m = kLegDeepCells * floor.cell_m();
  const std::span<const Obstacle> about = obstacles_around(floor, p_map, params_.leg_max_m);
  return std::any_of(about.begin(), about.end(), [&](const Obstacle& obstacle) {
    const Vec2 away = p_map - obstacle.p_map;
    return obstacle.is_leg() && away.norm() <= params_.leg_max_m && obstacle.behind.dot(away) < deep_m;
  });
}

/// Whether the occupied point belongs to a small obstacle, a leg or not.
bool LegBarriers::is_small_obstacle(const FloorGrid& floor, const Vec2& p_map) const {
  const std::span<const Obstacle> about = obstacles_around(floor, p_map, params_.leg_max_m);
  return std::any_of(about.begin(), about.end(), [&](const Obstacle& obstacle) {
    return (obstacle.p_map - p_map).norm() <= params_.leg_max_m / 2;
  });
}

/// The cells closed by pairs of which it is the first.
std::vector<FloorCell> LegBarriers::cells_closed_by(const FloorGrid& floor, std::size_t first) const {
  std::vector<FloorCell> cells;
  const auto close = [&](const Vec2& from, const Vec2& to) {
    const std::size_t before = cells.size();
    bool was_stood_on = false;
    for_cells_on_line(floor, from, to, [&](FloorCell cell) {
      cells.push_back(cell);
      was_stood_on = was_stood_on || floor.was_stood_on(cell);
    });
    if (was_stood_on) cells.resize(before);
  };
  const Obstacle& obstacle = obstacles_[first];
  const int apart_max = static_cast<int>((params_.apart_max_m + params_.leg_max_m) / floor.cell_m());
  for (const Vec2& p_map : hidden_partners(floor, obstacle)) close(obstacle.p_map, p_map);
  for (std::size_t i = first + 1; i < obstacles_.size(); ++i) {
    const Obstacle& other = obstacles_[i];
    if (other.first.y - obstacle.first.y > apart_max) break;
    const Vec2 &a = obstacle.p_map, &b = other.p_map;
    const double apart_m = (b - a).norm();
    if (apart_m > params_.apart_max_m || !may_carry_one_plate(floor, obstacle, other)) continue;
    close(a, b);
    if (apart_m < params_.plate_min_m) continue;
    const auto behind_a = wall_behind(obstacle, b - a), behind_b = wall_behind(other, b - a);
    if (!behind_a || !behind_b) continue;
    close(a, *behind_a);
    close(b, *behind_b);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// Whether both are right before opposite walls, with something that is no leg behind the middle between
/// them: a table fills a recess.
bool LegBarriers::fill_recess(const FloorGrid& floor, const Obstacle& a, const Obstacle& b) const {
  if (!a.is_leg() || !b.is_leg()) return false;
  const Vec2 along = (b.p_map - a.p_map).normalized(), middle = (a.p_map + b.p_map) / 2;
  if (a.behind.dot(along) > -kAcrossMin || b.behind.dot(along) < kAcrossMin) return false;
  bool ends = false;
  const Vec2 across = params_.wall_max_m * left_normal(along);
  for_cells_on_line(floor, Vec2(middle - across), Vec2(middle + across), [&](FloorCell cell) {
    ends = ends || (floor.at(cell) == Floor::kOccupied && !is_leg(floor, floor.centre(cell)));
  });
  return ends;
}

/// Whether one of them is free-standing or they fill a recess, with nothing between them but legs and blur: a
/// chair may stand in front of a table.
bool LegBarriers::may_carry_one_plate(const FloorGrid& floor, const Obstacle& a, const Obstacle& b) const {
  const auto goes_with = [&](const Obstacle& leg, const Obstacle& obstacle) {
    return leg.is_free_leg() && (obstacle.is_leg() || stands_along_wall(floor, leg, obstacle));
  };
  if (!goes_with(a, b) && !goes_with(b, a) && !fill_recess(floor, a, b)) return false;
  const auto blur_m = [&](const Obstacle& obstacle) {
    return obstacle.stand == Stand::kFree ? params_.leg_max_m : kBlurAtWall_m;
  };
  bool in_sight = true;
  for_cells_on_line(floor, a.p_map, b.p_map, [&](FloorCell cell) {
    const Vec2 p_map = floor.centre(cell);
    const bool is_between = (p_map - a.p_map).norm() > blur_m(a) && (p_map - b.p_map).norm() > blur_m(b);
    if (is_between && floor.at(cell) == Floor::kOccupied && !is_leg(floor, p_map)) in_sight = false;
  });
  return in_sight;
}

/// Whether the obstacle may be a leg, too: the wall behind the leg goes on behind it.
bool LegBarriers::stands_along_wall(const FloorGrid& floor, const Obstacle& leg,
                                    const Obstacle& obstacle) const {
  const auto behind = wall_behind(leg, obstacle.p_map - leg.p_map);
  return behind && stands_about(floor, Vec2(*behind + obstacle.p_map - leg.p_map), params_.leg_max_m / 2);
}

/// The nearest point, perpendicular to a line of legs, of something that is no leg.
std::optional<Vec2> LegBarriers::wall_behind(const Obstacle& leg, const Vec2& along) const {
  const Vec2 across = left_normal(along.normalized());
  return nearest_wall(
      leg, [&](const Vec2& away) { return std::abs(across.dot(away)) >= kAcrossMin * away.norm(); });
}

/// Unit vector perpendicular to a wall, towards its nearest point. If that point is far from perpendicular,
/// it is a speck that stands out of the wall.
Vec2 LegBarriers::across_wall(const Obstacle& leg, const Vec2& p_map_nearest) const {
  Mat2 spread = Mat2::Zero();
  for (const Vec2& p_map : leg.walls) {
    const Vec2 away = p_map - p_map_nearest;
    if (away.norm() <= kWallPiece_m) spread += away * away.transpose();
  }
  Vec2 towards = (p_map_nearest - leg.p_map).normalized();
  const Vec2 across = left_normal(principal_direction(spread));
  const double off = across.dot(towards);
  if (std::abs(off) >= kStraightMin) return towards;
  return off < 0 ? Vec2(-across) : across;
}

/// Whether more than a small obstacle extends to both sides of the point met in this direction.
bool LegBarriers::wall_goes_on(const FloorGrid& floor, const Vec2& p_map_leg, const Vec2& away) const {
  const Vec2 p_map = p_map_leg + away, lateral = kWallGoesOn_m * left_normal(away.normalized());
  return small_obstacle(floor, floor.cell_at(p_map)).empty() &&
         stands_about(floor, Vec2(p_map + lateral), floor.cell_m()) &&
         stands_about(floor, Vec2(p_map - lateral), floor.cell_m());
}

template <class Matters>
std::optional<Vec2> LegBarriers::nearest_wall(const Obstacle& leg, Matters matters) const {
  std::optional<Vec2> nearest;
  double nearest_m = params_.wall_max_m;
  for (const Vec2& p_map : leg.walls) {
    const Vec2 away = p_map - leg.p_map;
    const double away_m = away.norm();
    if (away_m >= nearest_m || !matters(away)) continue;
    nearest_m = away_m;
    nearest = p_map;
  }
  return nearest;
}

/// For a leg before a wall: where its partner may be that carries the table along that wall, hidden by unseen
/// floor. If such a partner is known on either side, none is assumed. In a corner the table extends away from
/// the wall that the leg is right in front of.
std::vector<Vec2> LegBarriers::hidden_partners(const FloorGrid& floor, const Obstacle& leg) const {
  std::vector<Vec2> hidden;
  const auto look = [&](const Vec2& along) {
    if (const auto place = partner_place(floor, leg.p_map, along)) hidden.push_back(*place);
  };
  const auto may_hide_one = [&](const Vec2& along) {
    return wall_behind(leg, along) && !has_partner(floor, leg, along);
  };
  if (leg.is_of_wall) return hidden;
  if (leg.stand == Stand::kBeforeWall && may_hide_one(leg.behind)) look(-leg.behind);
  if (leg.stand != Stand::kFree) return hidden;
  const auto wall = nearest_wall(leg, [&](const Vec2& away) { return wall_goes_on(floor, leg.p_map, away); });
  if (!wall) return hidden;
  const Vec2 across = across_wall(leg, *wall);
  for (const Vec2& along : {left_normal(across), across}) {
    if (!may_hide_one(along)) continue;
    look(along);
    look(-along);
  }
  return hidden;
}

bool LegBarriers::has_partner(const FloorGrid& floor, const Obstacle& leg, const Vec2& along) const {
  const std::span<const Obstacle> about = obstacles_around(floor, leg.p_map, params_.apart_max_m);
  return std::any_of(about.begin(), about.end(), [&](const Obstacle& other) {
    const Vec2 away = other.p_map - leg.p_map;
    return other.is_leg() && away.norm() > kPieceMin_m && away.norm() <= params_.apart_max_m &&
           std::abs(left_normal(along).dot(away)) <= params_.leg_max_m;
  });
}

/// The first unseen floor or small obstacle within a table's length; nullopt if a wall comes first.
std::optional<Vec2> LegBarriers::partner_place(const FloorGrid& floor, const Vec2& p_map_leg,
                                               const Vec2& along) const {
  const double step_m = kLineStepCells * floor.cell_m();
  const int steps = static_cast<int>((params_.apart_max_m - params_.leg_max_m) / step_m);
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p_map = p_map_leg + (params_.leg_max_m + i * step_m) * along;
    if (floor.at(p_map) == Floor::kFree) continue;
    const bool may_be_leg = floor.at(p_map) == Floor::kUnknown || is_small_obstacle(floor, p_map);
    return may_be_leg ? std::optional(p_map) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace aisle
