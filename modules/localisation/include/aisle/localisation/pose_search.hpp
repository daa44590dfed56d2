#pragma once
/// Branch and bound over all poses of a building: the best ones first, none left out.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "aisle/localisation/surface_field.hpp"

namespace aisle {

/// How likely hits are in each cell of 10 cm, with the maximum over square windows of several widths.
class LikelihoodPyramid {
 public:
  static constexpr double kCell_m = 0.1;
  /// Cells along a window, by level. The finer the steps between them, the closer the bounds.
  static constexpr std::array kWidths{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
  static constexpr int kLevels = static_cast<int>(kWidths.size());
  static constexpr int kLikely = 250;  ///< right at a surface; falls to 0 at 25 cm

  explicit LikelihoodPyramid(const SurfaceField& field);

  /// The least level whose windows are so wide; nullopt: none is.
  static std::optional<int> level_of(int width);

  /// The maximum over cells x .. x + kWidths[level] - 1, and y likewise.
  int likelihood(int level, int x, int y) const { return at(likelihoods_, level, x, y); }
  /// Whether a vehicle can stand in any of these cells.
  bool can_stand(int level, int x, int y) const { return at(can_stand_, level, x, y) != 0; }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  Vec2 centre(int x, int y) const { return p_map_corner_ + kCell_m * Vec2(x + 0.5, y + 0.5); }

 private:
  using Levels = std::vector<std::vector<std::uint8_t>>;
  static constexpr int kPadding = kWidths.back();

  int at(const Levels& levels, int level, int x, int y) const {
    if (x < -kPadding || y < -kPadding || x >= columns_ || y >= rows_) return 0;
    return levels[static_cast<std::size_t>(level)][index(x, y)];
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y + kPadding) * static_cast<std::size_t>(columns_ + kPadding) +
           static_cast<std::size_t>(x + kPadding);
  }
  void grow(Levels& levels) const;

  Vec2 p_map_corner_ = Vec2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  Levels likelihoods_;
  Levels can_stand_;
};

/// A pose on the search's grid, and how likely the view is there.
struct ScoredPose {
  Pose2 T_map_vehicle;
  double score = 0;  ///< mean likelihood of the hits, 0 .. 1
};

/// One search for the poses at which a view is likely.
class PoseSearch {
 public:
  static constexpr double kHeadingStep_rad = 1 * kDegree;
  static constexpr int kHeadings = 360;

  /// @param hits       in the vehicle's frame; not empty. Cost grows with their number
  /// @param score_min  poses with less are never returned
  PoseSearch(const LikelihoodPyramid& map, std::span<const Vec2> hits, double score_min);

  /// The best pose that has not been returned yet. No pose of the grid is left out: where nothing is
  /// returned, none is left with this score, unless `is_cut_short()`.
  /// @param score_min  from now on
  /// @param nodes_max  of the whole search
  std::optional<ScoredPose> next(double score_min, std::size_t nodes_max);

  /// Poses may be left: the last call ended by its number of nodes.
  bool is_cut_short() const { return !queue_.empty(); }
  /// Nodes whose bound was computed so far.
  std::size_t nodes() const { return nodes_; }
  /// Score of one pose of the grid, as the search defines it; 0 where it is below `score_min`.
  double score(int x, int y, int heading) const;

 private:
  struct Hit {
    std::int16_t x = 0, y = 0;  ///< cells from the vehicle's
  };
  /// Poses: a square of 2^level cells, and headings of which there are fewer where the square is small.
  struct Node {
    float score = 0;  ///< no pose in it has a greater one
    int x = 0, y = 0;
    int heading = 0;  ///< the first
    int level = 0;

    bool operator<(const Node& other) const { return score < other.score; }
  };

  /// Where the windows for a hit begin, and how wide they are.
  struct Reach {
    int spread = 0;  ///< cells that the node's headings move the hit to either side
    std::optional<int> level;
  };

  void turn_hits(std::span<const Vec2> hits);
  void add(Node node);
  void divide(const Node& node);
  double bound(const Node& node) const;

  const LikelihoodPyramid& map_;
  std::size_t hits_ = 0;          ///< per heading
  std::vector<Hit> hits_turned_;  ///< by half a heading step after the other
  std::vector<Reach> reaches_;    ///< of each hit, node level after node level
  std::vector<Node> queue_;       ///< a heap
  double score_min_ = 0;
  std::size_t nodes_ = 0;
};

}  // namespace aisle
