#include "aisle/simulation/plans/plan_symbols.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr int kWallCellsMax = 12;  ///< thicker walls count as so thick
constexpr int kDoorCellsMin = 8, kDoorCellsMax = 200;
constexpr int kMarkShareOfPlan = 25;  ///< a mark is at most this part of the plan, or so many cells:
constexpr int kMarkCellsMax = 12;
constexpr double kStroke = 1.5;        ///< cells off the line that is drawn
constexpr double kExplainedMin = 0.9;  ///< of a door's cells
constexpr std::size_t kSectors = 9;    ///< of the arc, and sections of the leaf
constexpr std::size_t kSectorsMin = 8;
constexpr int kComponentsMax = 5000;  ///< more is not a drawing

/// What squares of this side fit into. OpenCV's own opening shifts the cells if the side is even.
cv::Mat opened(const cv::Mat& solid, int side) {
  cv::Mat result;
  const cv::Mat square = cv::Mat::ones(side, side, CV_8U);
  cv::erode(solid, result, square, {0, 0});
  cv::dilate(result, result, square, {side - 1, side - 1});
  return result;
}

/// The thickness that half of all solid cells have at least.
int wall_thickness(const cv::Mat& solid) {
  const int all = cv::countNonZero(solid);
  int thickness = 1;
  while (thickness < kWallCellsMax && 2 * cv::countNonZero(opened(solid, thickness + 1)) >= all) ++thickness;
  return thickness;
}

struct Component {
  CellBox box;
  std::vector<cv::Point> cells;
};

std::vector<Component> components_of(const cv::Mat& marked) {
  cv::Mat labels, figures, centres;
  const int count = cv::connectedComponentsWithStats(marked, labels, figures, centres, 8, CV_32S);
  if (count > kComponentsMax) return {};
  std::vector<Component> components(static_cast<std::size_t>(count - 1));
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (const int label = labels.at<int>(y, x); label > 0)
        components[static_cast<std::size_t>(label - 1)].cells.emplace_back(x, y);
    }
  }
  for (int i = 1; i < count; ++i) {
    const auto figure = [&](int column) { return figures.at<int>(i, column); };
    components[static_cast<std::size_t>(i - 1)].box = {figure(cv::CC_STAT_LEFT), figure(cv::CC_STAT_TOP),
                                                       figure(cv::CC_STAT_WIDTH), figure(cv::CC_STAT_HEIGHT)};
  }
  return components;
}

/// A door that turns about a hinge; the signs say in which quadrant it is drawn.
struct DoorSwing {
  double hinge_x, hinge_y, sign_x, sign_y, width;
};

bool explains(const DoorSwing& door, const Component& component) {
  std::bitset<kSectors> arc, leaf_x, leaf_y;
  std::size_t explained = 0;
  const auto section = [](double share) {
    return std::min(kSectors - 1, static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * kSectors));
  };
  for (const cv::Point& cell : component.cells) {
    const double x = door.sign_x * (cell.x - door.hinge_x), y = door.sign_y * (cell.y - door.hinge_y);
    const double reach = std::hypot(x, y);
    const bool on_arc = std::abs(reach - door.width) <= kStroke && x > -kStroke && y > -kStroke;
    const bool on_x = std::abs(y) <= kStroke && reach <= door.width + kStroke;
    const bool on_y = std::abs(x) <= kStroke && reach <= door.width + kStroke;
    explained += on_arc || on_x || on_y;
    if (on_arc) arc.set(section(std::atan2(y, x) / (kPi / 2)));
    if (on_x) leaf_x.set(section(reach / door.width));
    if (on_y) leaf_y.set(section(reach / door.width));
  }
  const bool has_one_leaf = std::max(leaf_x.count(), leaf_y.count()) >= kSectorsMin - 2 &&
                            std::min(leaf_x.count(), leaf_y.count()) < kSectors / 2 + 1;
  return has_one_leaf && arc.count() >= kSectorsMin &&
         static_cast<double>(explained) >= kExplainedMin * static_cast<double>(component.cells.size());
}

/// The hinge lies at a corner of the box or, hidden by the wall, up to the wall's thickness outside.
bool is_door(const Component& component, int wall) {
  const CellBox& box = component.box;
  const int larger = std::max(box.width, box.height), smaller = std::min(box.width, box.height);
  if (smaller < kDoorCellsMin || larger > kDoorCellsMax || larger - smaller > wall + 2) return false;
  for (int corner = 0; corner < 4; ++corner) {
    const double sign_x = corner % 2 == 0 ? 1 : -1, sign_y = corner / 2 == 0 ? 1 : -1;
    const double corner_x = sign_x > 0 ? box.x : box.x + box.width - 1;
    const double corner_y = sign_y > 0 ? box.y : box.y + box.height - 1;
    for (int out_x = 0; out_x <= wall; ++out_x) {
      for (int out_y = 0; out_y <= wall; ++out_y) {
        for (int width = larger - 1; width <= larger + wall; ++width) {
          const DoorSwing door{corner_x - sign_x * out_x, corner_y - sign_y * out_y, sign_x, sign_y,
                               static_cast<double>(width)};
          if (explains(door, component)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

PlanSymbols open_drawn_doors(FloorPlan& plan) {
  const cv::Mat solid = cv::Mat(plan.height, plan.width, CV_8U, plan.solid.data()) != 0;
  const int wall = wall_thickness(solid);
  if (wall < 2) return {};
  const cv::Mat walls = opened(solid, wall / 2 + 1);
  cv::Mat near_walls;
  cv::dilate(walls, near_walls, cv::Mat::ones(3, 3, CV_8U));
  const int mark_max = std::max(kMarkCellsMax, std::max(plan.width, plan.height) / kMarkShareOfPlan);
  PlanSymbols symbols;
  for (const Component& stroke : components_of(solid & ~walls)) {
    const int side = std::max(stroke.box.width, stroke.box.height);
    const bool stands_free =
        std::none_of(stroke.cells.begin(), stroke.cells.end(),
                     [&](const cv::Point& cell) { return near_walls.at<std::uint8_t>(cell) != 0; });
    if (is_door(stroke, wall)) {
      symbols.doors.push_back(stroke.box);
      for (const cv::Point& cell : stroke.cells) plan.solid[plan.index(cell.x, cell.y)] = 0;
    } else if (stands_free && side > wall && side <= mark_max) {
      symbols.marks.push_back(stroke.box);
    }
  }
  return symbols;
}

}  // namespace aisle
