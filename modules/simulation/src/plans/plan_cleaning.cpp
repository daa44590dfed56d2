#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "aisle/simulation/plans/plan_tracing.hpp"

namespace aisle {
namespace {

/// Connected cells; each area has a label from 0.
class CellAreas {
 public:
  /// @param value  which cells: solid or free ones
  CellAreas(const FloorPlan& plan, std::uint8_t value) : plan_(plan) {
    const cv::Mat cells =
        cv::Mat(plan.height, plan.width, CV_8U, const_cast<std::uint8_t*>(plan.solid.data())) == value;
    const int solid_joins_at_corners = 8, free_does_not = 4;
    cv::Mat centres;
    count_ = cv::connectedComponentsWithStats(cells, labels_, figures_, centres,
                                              value != 0 ? solid_joins_at_corners : free_does_not, CV_32S);
  }

  int count() const { return count_; }
  /// 0: not one of these cells.
  int label(int x, int y) const { return labels_.at<int>(y, x); }
  int cells(int label) const { return figures_.at<int>(label, cv::CC_STAT_AREA); }
  int side(int label) const {
    return std::max(figures_.at<int>(label, cv::CC_STAT_WIDTH), figures_.at<int>(label, cv::CC_STAT_HEIGHT));
  }
  bool reaches_border(int label) const {
    const int left = figures_.at<int>(label, cv::CC_STAT_LEFT),
              bottom = figures_.at<int>(label, cv::CC_STAT_TOP);
    return left == 0 || bottom == 0 || left + figures_.at<int>(label, cv::CC_STAT_WIDTH) == plan_.width ||
           bottom + figures_.at<int>(label, cv::CC_STAT_HEIGHT) == plan_.height;
  }

 private:
  const FloorPlan& plan_;
  cv::Mat labels_;
  cv::Mat figures_;
  int count_ = 0;
};

/// Gives the cells of the chosen areas another value.
void fill(FloorPlan& plan, const CellAreas& areas, const std::vector<bool>& chosen, std::uint8_t value) {
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) {
      if (chosen[static_cast<std::size_t>(areas.label(x, y))]) plan.solid[plan.index(x, y)] = value;
    }
  }
}

int remove_solid_specks(FloorPlan& plan, int side_max) {
  const CellAreas areas(plan, 1);
  std::vector<bool> specks(static_cast<std::size_t>(areas.count()), false);
  for (int label = 1; label < areas.count(); ++label) {
    specks[static_cast<std::size_t>(label)] = areas.side(label) <= side_max && !areas.reaches_border(label);
  }
  fill(plan, areas, specks, 0);
  return static_cast<int>(std::count(specks.begin(), specks.end(), true));
}

/// Free areas that no square larger than the limit fits into: slits between the lines of a double wall.
void remove_free_slits(FloorPlan& plan, int side_max) {
  const CellAreas areas(plan, 0);
  std::vector<bool> slits(static_cast<std::size_t>(areas.count()), true);
  slits[0] = false;
  const int side = side_max + 1;
  for (int y = 0; y + side <= plan.height; ++y) {
    int free_columns = 0;
    for (int x = 0; x < plan.width; ++x) {
      bool is_free = true;
      for (int up = 0; up < side; ++up) is_free = is_free && !plan.is_solid(x, y + up);
      free_columns = is_free ? free_columns + 1 : 0;
      if (free_columns >= side) slits[static_cast<std::size_t>(areas.label(x, y))] = false;
    }
  }
  fill(plan, areas, slits, 1);
}

double free_share_of_border(const FloorPlan& plan) {
  int border = 0, free = 0;
  for (int y = 0; y < plan.height; ++y) {
    const bool whole_row = y == 0 || y == plan.height - 1;
    for (int x = 0; x < plan.width; x += whole_row ? 1 : std::max(1, plan.width - 1)) {
      ++border;
      free += !plan.is_solid(x, y);
    }
  }
  return static_cast<double>(free) / border;
}

void remove_outside(FloorPlan& plan) {
  const CellAreas areas(plan, 0);
  std::vector<bool> outside(static_cast<std::size_t>(areas.count()), false);
  long outside_cells = 0;
  int largest_enclosed = 0;
  for (int label = 1; label < areas.count(); ++label) {
    if (areas.reaches_border(label)) {
      outside[static_cast<std::size_t>(label)] = true;
      outside_cells += areas.cells(label);
    } else {
      largest_enclosed = std::max(largest_enclosed, areas.cells(label));
    }
  }
  const bool goes_round = largest_enclosed > 0 && free_share_of_border(plan) > 0.5;
  if (goes_round || largest_enclosed > outside_cells) fill(plan, areas, outside, 1);
}

}  // namespace

int clean_plan(FloorPlan& plan, const PlanCleaningParams& params) {
  const auto cells = [&](double side_m) { return static_cast<int>(std::floor(side_m / plan.cell_m + 1e-9)); };
  const int specks = remove_solid_specks(plan, cells(params.speck_m));
  remove_free_slits(plan, cells(params.slit_m));
  remove_outside(plan);
  return specks;
}

}  // namespace aisle
