#include "aisle/exploration/frontiers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "frontier_cells.hpp"

namespace aisle {
namespace {

constexpr double kCountedBehind_m2 = 2;  // larger areas behind a frontier are not distinguished
constexpr std::size_t kEdgeMax = 24;     // points that represent an edge
constexpr double kBesideCells = 1.5;     // the distances of two adjacent cells differ by less

class FrontierFinder {
 public:
  FrontierFinder(const KnownFloor& floor, const FloorDistances& reached, const FrontierParams& params,
                 CellMarks& marks)
      : floor_(floor.grid()),
        clearance_(floor.clearance()),
        reached_(reached),
        params_(params),
        marks_(marks) {
    marks_.assign(clearance_.size(), kNothing);
  }

  std::vector<Frontier> find() {
    std::vector<FloorCell> frontier_cells = mark_frontier_cells();
    std::vector<Frontier> frontiers;
    for (const FloorCell cell : frontier_cells) {
      if (marks_[clearance_.index(cell)] != kFrontierCell) continue;
      Frontier frontier = gather(cell);
      measure_behind(frontier);
      if (frontier.behind_m2 >= params_.area_min_m2 && !frontier.edge.empty())
        frontiers.push_back(std::move(frontier));
    }
    return frontiers;
  }

 private:
  enum Mark : std::uint8_t { kNothing, kFrontierCell, kTaken, kCounted };

  bool is_sure(FloorCell cell) const { return clearance_.to_doubtful_m(cell) >= params_.clearance_m; }
  bool may_be_floor(FloorCell cell) const {
    return clearance_.to_occupied_m(cell) >= params_.clearance_m + params_.uncertain_m;
  }
  bool is_doubtful(FloorCell cell) const {
    return clearance_.room().contains(cell) && may_be_floor(cell) && !is_sure(cell);
  }

  template <class Visit>
  static void for_neighbours(FloorCell cell, int reach, Visit visit) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        if (x != 0 || y != 0) visit(FloorCell{cell.x + x, cell.y + y});
      }
    }
  }

  std::vector<FloorCell> mark_frontier_cells() {
    std::vector<FloorCell> cells;
    const double sure_m = params_.clearance_m, beside_uncertain_m = sure_m + kBesideCells * floor_.cell_m();
    clearance_.for_cells(floor_.known(), [&](FloorCell cell, std::size_t index) {
      const double clearance_m = clearance_.to_doubtful_m(index);
      if (clearance_m < sure_m || clearance_m >= beside_uncertain_m) return;
      if (!may_be_floor(cell) || reached_.to(cell) == FloorDistances::kUnreached) return;
      bool borders = false;
      for_neighbours(cell, 1, [&](FloorCell next) { borders = borders || is_doubtful(next); });
      if (!borders) return;
      marks_[index] = kFrontierCell;
      cells.push_back(cell);
    });
    return cells;
  }

  Frontier gather(FloorCell first) {
    const int gap = static_cast<int>(params_.cluster_gap_m / floor_.cell_m());
    const int half = static_cast<int>(params_.length_max_m / 2 / floor_.cell_m());
    const auto is_near = [&](FloorCell cell) {
      return std::abs(cell.x - first.x) <= half && std::abs(cell.y - first.y) <= half;
    };
    Frontier frontier;
    frontier.cells.push_back(first);
    marks_[clearance_.index(first)] = kTaken;
    for (std::size_t i = 0; i < frontier.cells.size(); ++i) {
      for_neighbours(FloorCell(frontier.cells[i]), gap, [&](FloorCell next) {
        if (!clearance_.room().contains(next) || marks_[clearance_.index(next)] != kFrontierCell) return;
        if (!is_near(next)) return;
        marks_[clearance_.index(next)] = kTaken;
        frontier.cells.push_back(next);
      });
    }
    measure_frontier_cells(floor_, frontier);
    frontier.path_m = FloorDistances::kUnreached;
    for (const FloorCell cell : frontier.cells)
      frontier.path_m = std::min<double>(frontier.path_m, reached_.to(cell));
    return frontier;
  }

  /// Walks over the uncertain floor behind the frontier cells, nearest first, to find its area and where the
  /// free floor ends.
  void measure_behind(Frontier& frontier) {
    std::vector<FloorCell> behind;
    const auto count = [&](FloorCell cell) {
      if (!is_doubtful(cell) || marks_[clearance_.index(cell)] == kCounted) return;
      marks_[clearance_.index(cell)] = kCounted;
      behind.push_back(cell);
    };
    for (const FloorCell cell : frontier.cells) for_neighbours(cell, 1, count);
    const double cell_m2 = floor_.cell_m() * floor_.cell_m();
    const auto enough = static_cast<std::size_t>(kCountedBehind_m2 / cell_m2);
    for (std::size_t i = 0; i < behind.size() && behind.size() < enough; ++i)
      for_neighbours(FloorCell(behind[i]), 1, count);
    frontier.behind_m2 = static_cast<double>(behind.size()) * cell_m2;
    collect_rim(frontier, behind);
    for (const FloorCell cell : behind) marks_[clearance_.index(cell)] = kNothing;
  }

  void collect_rim(Frontier& frontier, const std::vector<FloorCell>& behind) {
    std::vector<FloorCell> edge;
    const int reach = static_cast<int>(std::ceil(params_.clearance_m / floor_.cell_m()));
    for (const FloorCell cell : behind) {
      if (floor_.at(cell) == Floor::kUnknown) add_edge(cell, edge);
    }
    if (!edge.empty()) return thin_out(edge, frontier);
    // uncertain floor borders on free floor: the unknown is within the vehicle's width of it
    for (const FloorCell cell : behind) {
      for_neighbours(cell, reach, [&](FloorCell next) {
        if (floor_.at(next) == Floor::kUnknown) add_edge(next, edge);
      });
    }
    thin_out(edge, frontier);
  }

  /// An unknown cell beside a free one lies on the edge.
  void add_edge(FloorCell cell, std::vector<FloorCell>& edge) const {
    bool borders = false;
    for_neighbours(cell, 1, [&](FloorCell next) { borders = borders || floor_.at(next) == Floor::kFree; });
    if (borders) edge.push_back(cell);
  }

  void thin_out(const std::vector<FloorCell>& edge, Frontier& frontier) const {
    const std::size_t every = edge.size() / kEdgeMax + 1;
    for (std::size_t i = every / 2; i < edge.size(); i += every)
      frontier.edge.push_back(floor_.centre(edge[i]));
    if (frontier.edge.empty() && !edge.empty()) frontier.edge.push_back(floor_.centre(edge.front()));
  }

  const FloorGrid& floor_;
  const FloorClearance& clearance_;
  const FloorDistances& reached_;
  const FrontierParams& params_;
  CellMarks& marks_;
};

}  // namespace

void FrontierParams::describe(FieldList& fields) {
  fields.real("clearance_m", clearance_m, {0.05, 2},
              "clearance from the vehicle's centre line to anything that is not free floor");
  fields.real("uncertain_m", uncertain_m, {0.02, 0.5},
              "beyond this extra clearance from obstacles there may be floor");
  fields.real("area_min_m2", area_min_m2, {0.01, 5}, "least floor behind a frontier");
  fields.real("cluster_gap_m", cluster_gap_m, {0.05, 1},
              "pieces of a frontier within this of each other are one");
  fields.real("length_max_m", length_max_m, {1, 100}, "longer frontiers are cut into several");
}

Frontier with_cells_halved(Frontier frontier) {
  const auto halved = [](FloorCell cell) { return FloorCell{2 * cell.x, 2 * cell.y}; };
  for (FloorCell& cell : frontier.cells) cell = halved(cell);
  frontier.box = {halved(frontier.box.low), halved(frontier.box.end)};
  frontier.viewpoint = halved(frontier.viewpoint);
  return frontier;
}

std::vector<Frontier> find_frontiers(const KnownFloor& floor, const FloorDistances& reached,
                                     const FrontierParams& params, CellMarks& marks) {
  return FrontierFinder(floor, reached, params, marks).find();
}

}  // namespace aisle
