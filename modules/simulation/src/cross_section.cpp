#include "aisle/simulation/cross_section.hpp"

#include "prism.hpp"

namespace aisle {
namespace {

/// Range of heights [m].
struct Layer {
  double bottom_m = 0;
  double top_m = 0;

  bool overlaps(double bottom, double top) const { return bottom <= top_m && top >= bottom_m; }
};

class Outlines {
 public:
  explicit Outlines(Layer layer) : layer_(layer) {}

  void add(const WallFace& wall) {
    if (layer_.overlaps(0, wall.height_m)) segments_.push_back(wall.floor_edge);
  }

  void add(const Prism& prism) {
    if (!layer_.overlaps(prism.bottom_m, prism.top_m)) return;
    for (std::size_t i = 0; i < prism.outline.size(); ++i) {
      segments_.push_back({prism.outline[i], prism.outline[(i + 1) % prism.outline.size()]});
    }
  }

  std::vector<Segment2> take() && { return std::move(segments_); }

 private:
  Layer layer_;
  std::vector<Segment2> segments_;
};

std::vector<Segment2> outlines(const World& world, Layer layer) {
  Outlines outlines(layer);
  for (const WallFace& wall : world.walls) outlines.add(wall);
  for (const Door& door : world.doors) outlines.add(leaf_of(door));
  for (const Furniture& piece : world.furniture) {
    for (const Prism& part : parts_of(piece)) outlines.add(part);
  }
  return std::move(outlines).take();
}

}  // namespace

std::vector<Segment2> cross_section(const World& world, double height_m) {
  return outlines(world, {height_m, height_m});
}

SeenOutlines seen_outlines(const World& world, double height_m) {
  SeenOutlines seen;
  const Layer layer{height_m, height_m};
  World clear = world;
  std::erase_if(clear.walls, [](const WallFace& wall) { return wall.is_glass(); });
  std::erase_if(clear.furniture, [](const Furniture& piece) { return piece.returns < 1; });
  seen.clear = outlines(clear, layer);
  for (const WallFace& wall : world.walls) {
    if (!wall.is_glass()) continue;
    Outlines pane(layer);
    pane.add(wall);
    for (const Segment2& segment : std::move(pane).take())
      seen.faint.push_back({segment, wall.returns, true});
  }
  for (const Furniture& piece : world.furniture) {
    if (piece.returns >= 1) continue;
    Outlines faces(layer);
    for (const Prism& part : parts_of(piece)) faces.add(part);
    for (const Segment2& segment : std::move(faces).take())
      seen.faint.push_back({segment, piece.returns, false});
  }
  return seen;
}

std::vector<Segment2> obstacles_below(const World& world, double height_m) {
  return outlines(world, {0, height_m});
}

}  // namespace aisle
