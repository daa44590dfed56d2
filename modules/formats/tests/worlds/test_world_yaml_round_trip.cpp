#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "worlds/world_fields.hpp"

namespace aisle {
namespace {

/// Draws random values that fields may have, on the writer's grid of thousandths.
class FieldDrawer {
 public:
  explicit FieldDrawer(Random& random) : random_(random) {}

  template <class Object>
  void draw(Object& object) {
    for (const ObjectField& field : fields_of(object)) {
      std::visit([&](const auto& target) { set(target, field); }, field.target);
    }
  }

  double thousandths(Range range) {
    const double low = std::ceil(std::max(range.min, -20.0) * 1000), high = std::min(range.max, 20.0) * 1000;
    return (low + static_cast<double>(random_.index(static_cast<std::uint64_t>(high - low) + 1))) / 1000;
  }
  Vec2 point(Range range = {-20, 20}) {
    const double x = thousandths(range), y = thousandths(range);
    return {x, y};
  }

 private:
  void set(double* target, const ObjectField& field) {
    *target = thousandths(field.range) * field.inner_unit;
  }
  void set(int* target, const ObjectField& field) {
    *target = static_cast<int>(std::floor(thousandths(field.range)));
  }
  void set(bool* target, const ObjectField&) { *target = random_.index(2) == 1; }
  void set(std::uint64_t* target, const ObjectField&) { *target = random_.bits(); }
  void set(const PointTarget& target, const ObjectField& field) {
    for (double* coordinate : target.coordinates) *coordinate = thousandths(field.range);
  }
  void set(std::vector<Vec2>* target, const ObjectField& field) {
    target->resize(2 + random_.index(9));
    for (Vec2& p : *target) p = point(field.range);
  }
  void set(std::string* target, const ObjectField&) {
    *target = "a \"name\": with {signs} # and \\ " + std::to_string(random_.bits());
  }
  void set(const WordTarget& target, const ObjectField&) {
    target.choose(random_.index(target.words.size()));
  }

  Random& random_;
};

/// Vehicles stand far from every possible obstacle.
constexpr double kLateral_m = 500;

/// A wall for the poster to hang on.
WallFace behind(Poster& poster, std::uint64_t quarter_turns) {
  poster.facing_rad = static_cast<double>(quarter_turns) * kPi / 2;
  const Vec2 along = quarter_turns % 2 == 0 ? Vec2(0, 1) : Vec2(1, 0);
  return {.floor_edge = {poster.centre - along, poster.centre + along}};
}

World draw_world(Random& random) {
  World world;
  FieldDrawer drawer(random);
  drawer.draw(world);
  drawer.draw(world.floor);
  if (random.index(2) == 0) drawer.draw(world.start.emplace());
  for_each_list(world, [&](const char*, auto& objects, std::size_t) {
    objects.resize(random.index(4));
    for (auto& object : objects) drawer.draw(object);
  });
  world.ceiling_m = 40;
  for (std::uint64_t i = random.index(30); i > 0; --i) {
    WallLine line;
    drawer.draw(line);
    const bool goes_on = !world.walls.empty() && random.index(2) == 0;
    world.walls.push_back({{goes_on ? world.walls.back().floor_edge.end : line.line[0], line.line[1]},
                           random.index(2) == 0 ? world.ceiling_m : line.height_m,
                           random.index(2) == 0 ? WallFace{}.brightness : line.brightness});
  }
  for (Poster& poster : world.posters) world.walls.push_back(behind(poster, random.index(4)));
  if (world.start) world.start->x += kLateral_m;
  for (Vec2& p : world.tour) p.x() += kLateral_m;
  for (NamedPlace& place : world.places) place.T_world_place.x += kLateral_m;
  return world;
}

bool same(double a, double b) {
  return std::abs(a - b) < 1e-9;
}
bool same(const Vec2& a, const Vec2& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y());
}
bool same(const WallFace& a, const WallFace& b) {
  return same(a.floor_edge.start, b.floor_edge.start) && same(a.floor_edge.end, b.floor_edge.end) &&
         same(a.height_m, b.height_m) && same(a.brightness, b.brightness);
}

bool same_value(double* a, double* b) {
  return same(*a, *b);
}
bool same_value(const PointTarget& a, const PointTarget& b) {
  return std::equal(a.coordinates.begin(), a.coordinates.end(), b.coordinates.begin(),
                    [](const double* x, const double* y) { return same(*x, *y); });
}
bool same_value(std::vector<Vec2>* a, std::vector<Vec2>* b) {
  return std::equal(a->begin(), a->end(), b->begin(), b->end(),
                    [](const Vec2& p, const Vec2& q) { return same(p, q); });
}
bool same_value(const WordTarget& a, const WordTarget& b) {
  return a.index() == b.index();
}
template <class Value>
bool same_value(Value* a, Value* b) {
  return *a == *b;
}

template <class Object>
bool same_object(Object a, Object b) {
  const ObjectFields fields_a = fields_of(a), fields_b = fields_of(b);
  return std::equal(fields_a.begin(), fields_a.end(), fields_b.begin(),
                    [](const ObjectField& f, const ObjectField& g) {
                      return std::visit(
                          [&](const auto& target) {
                            return same_value(target, std::get<std::decay_t<decltype(target)>>(g.target));
                          },
                          f.target);
                    });
}

template <class Object>
bool same_objects(const std::vector<Object>& a, const std::vector<Object>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Object& one, const Object& other) { return same_object(one, other); });
}

RC_GTEST_PROP(WorldYaml, WhatIsWrittenIsReadAgain, (std::uint64_t seed)) {
  Random random(seed);
  const World written = draw_world(random);
  const Result<World> read = parse_world(world_yaml(written), "w.yaml");
  if (!read.ok()) RC_FAIL(to_string(read.problems()) + "\n" + world_yaml(written));
  RC_ASSERT(same_object(*read, written));
  RC_ASSERT(same_object(read->floor, written.floor));
  RC_ASSERT(read->start.has_value() == written.start.has_value());
  if (read->start) RC_ASSERT(same_object(*read->start, *written.start));
  RC_ASSERT(std::equal(read->walls.begin(), read->walls.end(), written.walls.begin(), written.walls.end(),
                       [](const WallFace& a, const WallFace& b) { return same(a, b); }));
  RC_ASSERT(same_objects(read->doors, written.doors));
  RC_ASSERT(same_objects(read->posters, written.posters));
  RC_ASSERT(same_objects(read->lamps, written.lamps));
  RC_ASSERT(same_objects(read->papers, written.papers));
  RC_ASSERT(same_objects(read->furniture, written.furniture));
  RC_ASSERT(same_objects(read->parking_frames, written.parking_frames));
  RC_ASSERT(same_objects(read->boards, written.boards));
  RC_ASSERT(same_objects(read->people, written.people));
  RC_ASSERT(same_objects(read->places, written.places));
  RC_ASSERT(world_yaml(*read) == world_yaml(written));
}

}  // namespace
}  // namespace aisle
