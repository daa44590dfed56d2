#include "worlds/world_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "aisle/simulation/cross_section.hpp"

namespace aisle {
namespace {

/// Radius of the smallest vehicle; a larger one checks its own clearance.
constexpr double kVehicleRadius_m = 0.1;
constexpr double kVehicleHeight_m = 0.5;
constexpr double kOnTheWall_m = 0.03;

/// A point of the file and its key.
struct Spot {
  std::string key;
  Vec2 p_world = Vec2::Zero();
};

bool is_inside(const Vec2& p_world, const Furniture& piece) {
  const Pose2 T_world_piece{piece.centre.x(), piece.centre.y(), piece.heading_rad};
  const Vec2 p_piece = T_world_piece.inverse() * p_world;
  switch (piece.kind) {
    case Furniture::Kind::kBox:
      return (p_piece.cwiseAbs() - piece.size / 2).maxCoeff() < 0;
    case Furniture::Kind::kPillar:
      return p_piece.norm() < piece.size.x() / 2;
    case Furniture::Kind::kTable:
    case Furniture::Kind::kChair:
      return false;  // has free space between its legs
  }
  return false;
}

/// Spots sorted by x, so that a wall looks only at those near it.
class Spots {
 public:
  explicit Spots(std::vector<Spot> spots) : spots_(std::move(spots)) {
    std::sort(spots_.begin(), spots_.end(),
              [](const Spot& a, const Spot& b) { return a.p_world.x() < b.p_world.x(); });
  }

  /// Calls visit(spot) for those whose x is in the range.
  template <class Visit>
  void for_each_between(double low_m, double high_m, const Visit& visit) const {
    auto spot = std::lower_bound(spots_.begin(), spots_.end(), low_m,
                                 [](const Spot& s, double x_m) { return s.p_world.x() < x_m; });
    for (; spot != spots_.end() && spot->p_world.x() <= high_m; ++spot) visit(*spot);
  }

  /// Calls visit(spot) for those within a distance of the segment.
  template <class Visit>
  void for_each_near(const Segment2& segment, double reach_m, const Visit& visit) const {
    const auto [low_m, high_m] = std::minmax(segment.start.x(), segment.end.x());
    for_each_between(low_m - reach_m, high_m + reach_m, [&](const Spot& spot) {
      if (segment.distance(spot.p_world) <= reach_m) visit(spot);
    });
  }

 private:
  std::vector<Spot> spots_;
};

class Checks {
 public:
  explicit Checks(const World& world) : world_(world) {}

  Problems problems() && {
    check_names();
    check_heights();
    check_paths();
    check_room_to_stand();
    check_posters();
    return std::move(problems_);
  }

 private:
  void add(std::string key, std::string what) {
    problems_.push_back({{.key = std::move(key)}, std::move(what)});
  }

  /// A vehicle can be sent by name to a place or a parking frame, so their names must differ.
  void check_names() {
    std::map<std::string, std::string> first_with;
    const auto check = [&](const char* list, const auto& objects) {
      for (std::size_t i = 0; i < objects.size(); ++i) {
        const std::string key = fmt::format("{}[{}]", list, i);
        const auto [first, is_new] = first_with.emplace(objects[i].name, key);
        if (!is_new) add(key + ".name", fmt::format("is the name of {} too", first->second));
      }
    };
    check("places", world_.places);
    check("parking_frames", world_.parking_frames);
  }

  void check_heights() {
    const auto check = [&](const std::string& key, double top_m) {
      constexpr double kRounding_m = 0.001;
      if (top_m <= world_.ceiling_m + kRounding_m) return;
      add(key, fmt::format("ends at {:g} m, above the ceiling at {:g} m", top_m, world_.ceiling_m));
    };
    double walls_m = 0;
    for (const WallFace& wall : world_.walls) walls_m = std::max(walls_m, wall.height_m);
    check("walls", walls_m);
    for (std::size_t i = 0; i < world_.doors.size(); ++i) {
      check(fmt::format("doors[{}].height_m", i), world_.doors[i].height_m);
    }
    for (std::size_t i = 0; i < world_.posters.size(); ++i) {
      check(fmt::format("posters[{}]", i), world_.posters[i].bottom_m + world_.posters[i].height_m);
    }
  }

  void check_paths() {
    const auto check = [&](const std::string& key, const std::vector<Vec2>& polyline) {
      const bool leads_somewhere =
          std::any_of(polyline.begin(), polyline.end(), [&](const Vec2& p) { return p != polyline.front(); });
      if (!leads_somewhere) add(key, "needs at least two different points");
    };
    if (!world_.tour.empty()) check("tour", world_.tour);
    for (std::size_t i = 0; i < world_.routes.size(); ++i) {
      check(fmt::format("routes[{}].path", i), world_.routes[i].path);
    }
    for (std::size_t i = 0; i < world_.people.size(); ++i) {
      check(fmt::format("people[{}].path", i), world_.people[i].path);
    }
  }

  std::vector<Spot> spots_to_stand() const {
    std::vector<Spot> spots;
    if (world_.start) spots.push_back({"start.at", world_.start->position()});
    for (std::size_t i = 0; i < world_.tour.size(); ++i) {
      spots.push_back({fmt::format("tour[{}]", i), world_.tour[i]});
    }
    for (std::size_t i = 0; i < world_.places.size(); ++i) {
      spots.push_back({fmt::format("places[{}].at", i), world_.places[i].T_world_place.position()});
    }
    return spots;
  }

  void check_room_to_stand() {
    const Spots spots(spots_to_stand());
    std::map<std::string, std::string> why;
    for (const Segment2& obstacle : obstacles_below(world_, kVehicleHeight_m)) {
      spots.for_each_near(obstacle, kVehicleRadius_m, [&](const Spot& spot) {
        why.emplace(spot.key, fmt::format("is closer than {:g} m to an obstacle", kVehicleRadius_m));
      });
    }
    for (const Furniture& piece : world_.furniture) {
      const double reach_m = piece.size.norm() / 2;
      spots.for_each_between(piece.centre.x() - reach_m, piece.centre.x() + reach_m, [&](const Spot& spot) {
        if (is_inside(spot.p_world, piece)) why[spot.key] = "is inside a piece of furniture";
      });
    }
    for (const auto& [key, what] : why) add(key, what);
  }

  void check_posters() {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < world_.posters.size(); ++i) {
      spots.push_back({fmt::format("posters[{}]", i), world_.posters[i].centre});
    }
    std::map<std::string, const Poster*> hanging_free;
    for (std::size_t i = 0; i < spots.size(); ++i) hanging_free[spots[i].key] = &world_.posters[i];
    const Spots by_x(std::move(spots));
    for (const WallFace& wall : world_.walls) {
      by_x.for_each_near(wall.floor_edge, kOnTheWall_m, [&](const Spot& spot) {
        const auto poster = hanging_free.find(spot.key);
        if (poster == hanging_free.end()) return;
        const double across = std::abs(unit(poster->second->facing_rad).dot(unit(wall.floor_edge.heading())));
        constexpr double kOblique = 0.1;
        if (across < kOblique) hanging_free.erase(poster);
      });
    }
    for (const auto& [key, poster] : hanging_free) add(key, "does not hang on a wall");
  }

  const World& world_;
  Problems problems_;
};

}  // namespace

Problems contradictions(const World& world) {
  return Checks(world).problems();
}

}  // namespace aisle
