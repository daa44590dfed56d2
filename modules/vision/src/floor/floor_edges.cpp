#include "aisle/vision/floor/floor_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "floor/floor_boundary.hpp"
#include "floor/floor_lines.hpp"
#include "floor/level_view.hpp"
#include "floor/line_settling.hpp"
#include "floor/skirting_board.hpp"

namespace aisle {

void FloorEdgeParams::describe(FieldList& fields) {
  fields.count("columns", columns, {16, 2000}, "directions in which the end of the floor is searched");
  fields.real("contrast_min", contrast_min, {0.5, 100}, "grey levels of the faintest edge");
  fields.real("distance_max_m", distance_max_m, {1, 100}, "farthest edge ahead of the camera");
  fields.real("length_min_m", length_min_m, {0, 10}, "of the shortest edge");
  fields.count("looks_past", looks_past, {0, 20},
               "times that it looks beyond what is no edge of the floor, such as joints and texture");
  fields.real("board_height_m", board_height_m, {0, 0.3},
              "highest skirting board whose floor point is looked for beneath its upper edge; 0: none is");
  fields.group("noise", noise);
}

namespace {

constexpr double kClear = 4;        // times the least contrast: an edge even if no other continues it
constexpr double kJoinColumns = 4;  // between edges that lead to each other
constexpr double kJoinRows = 8;
constexpr double kBesideLens_m = 0.25;  // a line that leads so close past the lens is a joint, not a wall
constexpr double kPaper_m = 0.6;        // longest edge of what may lie on the floor ...
constexpr double kBeyondPaper_m[] = {0.3, 0.4, 0.5};  // ... and where the floor goes on beyond it
constexpr double kBoardNear = 0.05;  // of the depth, beyond an edge: there a skirting board is still seen ...
constexpr double kBoardFar = 0.09;   // ... but no more the joint between two tiles
constexpr double kAlike = 0.5;       // of how much brighter something is than the floor: more like the floor
constexpr int kFloorRows = 6;        // before an edge, whose brightness is the floor's
constexpr int kBlurRows = 2;         // of an edge
constexpr int kBesideColumns = 24;   // beside an edge
constexpr std::size_t kBesideMin = 8;

}  // namespace

class FloorEdgeDetector::Work {
 public:
  Work(const FloorEdgeParams& params, const CameraIntrinsics& intrinsics, const CameraMount& mount)
      : params_(params),
        camera_(intrinsics),
        mount_(mount),
        view_(camera_, mount, params.columns, params.distance_max_m),
        boundary_(params.contrast_min),
        board_{.camera_height_m = mount.p_vehicle_camera.z(),
               .contrast_min = params.contrast_min,
               .height_max_m = params.board_height_m},
        tilted_floor_(camera_, tilted(mount, params.noise.tilt_rad), 0),
        rolled_floor_(camera_, rolled(mount, params.noise.tilt_rad), 0) {}

  const std::vector<FloorEdge>& detect(const Image& grey) {
    view_.look_at(grey);
    const std::vector<BoundaryPoint>* points = &boundary_.find(view_);
    find_ends(*points);
    for (int look = 0; look < params_.looks_past && exclude_others(*points); ++look) {
      points = &boundary_.find_again(view_);
      find_ends(*points);
    }
    edges_.clear();
    for (const FloorLine& line : ends_) add_edge(line);
    return edges_;
  }

 private:
  static CameraMount tilted(CameraMount mount, double tilt_rad) {
    mount.tilt_rad += tilt_rad;
    return mount;
  }

  static CameraMount rolled(CameraMount mount, double roll_rad) {
    mount.roll_rad += roll_rad;
    return mount;
  }

  void find_ends(const std::vector<BoundaryPoint>& points) {
    ends_.clear();
    const auto& lines = fitter_.fit(points, view_.rows_per_column());
    for (const FloorLine& line : lines) {
      const bool is_some = std::abs(line.contrast) >= kClear * params_.contrast_min || goes_on(line, lines);
      if (is_some && ends_the_floor(line) && !leads_past_lens(line)) ends_.push_back(line);
    }
  }

  /// Excludes what is no edge, such as a joint, a sheet of paper or a carpet's texture, so that it does not
  /// hide an edge beyond.
  /// @return whether there is any
  bool exclude_others(const std::vector<BoundaryPoint>& points) {
    bool any = false;
    for (const BoundaryPoint& point : points) {
      const auto is_on = [&](const FloorLine& line) {
        return point.column >= line.first_column && point.column <= line.last_column;
      };
      if (std::any_of(ends_.begin(), ends_.end(), is_on)) continue;
      boundary_.exclude(view_, point);
      any = true;
    }
    return any;
  }

  /// A pattern of the floor shows faint steps, none of which leads to another or out of sight.
  bool goes_on(const FloorLine& line, const std::vector<FloorLine>& lines) const {
    const auto leads_on = [&](double column) {
      const double row = line.row_at(column);
      const auto bottom = view_.seen(static_cast<int>(column)).end;
      if (column < kJoinColumns || column >= view_.columns() - kJoinColumns || row > bottom - kJoinRows)
        return true;
      return std::any_of(lines.begin(), lines.end(), [&](const FloorLine& other) {
        return &other != &line && column > other.first_column - kJoinColumns &&
               column < other.last_column + kJoinColumns && std::abs(other.row_at(column) - row) < kJoinRows;
      });
    };
    return leads_on(line.first_column) || leads_on(line.last_column);
  }

  /// Skips a line whose place on the floor cannot be computed.
  void add_edge(const FloorLine& line) {
    const FloorLine settled = settled_line(view_, floor_point_beneath(view_, line, board_).value_or(line));
    FloorEdge edge;
    SensedSegment& seen = edge.on_floor;
    seen.segment = segment_of(settled);
    seen.length_m = seen.segment.length();
    seen.heading_rad = seen.segment.heading();
    seen.centroid = point_of(settled, settled.middle());
    const auto start_px = pixel_of(seen.segment.start), end_px = pixel_of(seen.segment.end);
    if (!start_px || !end_px) return;
    edge.start_px = *start_px;
    edge.end_px = *end_px;
    edge.contrast = settled.contrast;
    if (set_deviations(settled, edge)) edges_.push_back(edge);
  }

  bool leads_past_lens(const FloorLine& line) const {
    const Vec2 across = left_normal(unit(segment_of(line).heading()));
    const Vec2 from_lens = point_of(line, line.middle()) - mount_.p_vehicle_camera.head<2>();
    return std::abs(across.dot(from_lens)) < kBesideLens_m;
  }

  /// Whether it is neither a joint nor something lying on the floor.
  bool ends_the_floor(const FloorLine& line) const {
    const double length_m = segment_of(line).length();
    if (!(length_m >= params_.length_min_m) || !lasts(line)) return false;
    return length_m >= kPaper_m || !(line.contrast > 0 ? floor_goes_on_beyond(line) : is_far_side(line));
  }

  Segment2 segment_of(const FloorLine& line) const {
    return {point_of(line, line.last_column), point_of(line, line.first_column)};
  }

  Vec2 point_of(const FloorLine& line, double column) const {
    return view_.floor_point(column, line.row_at(column));
  }

  std::optional<Vec2> pixel_of(const Vec2& p_vehicle) const {
    return camera_.project(mount_.to_camera({p_vehicle.x(), p_vehicle.y(), 0}));
  }

  /// What is beyond is not only a joint.
  bool lasts(const FloorLine& line) const {
    double sum = 0;
    int count = 0;
    for_each_column(line, [&](int column, double edge, double floor) {
      const double depth = view_.depth(edge);
      const auto beyond = mean_brightness(column, edge - kBoardFar * depth, edge - kBoardNear * depth);
      if (!beyond) return;
      sum += *beyond - floor;
      ++count;
    });
    return std::copysign(1.0, line.contrast) * sum > params_.contrast_min * count;
  }

  /// Beyond a bright thing the size of a sheet of paper the brightness is the floor's again.
  bool floor_goes_on_beyond(const FloorLine& line) const {
    const double alike = std::max(2 * params_.contrast_min, kAlike * line.contrast);
    int back = 0, count = 0;
    for_each_column(line, [&](int column, double edge, double floor) {
      bool is_seen = false, is_back = false;
      for (std::size_t i = 1; i < std::size(kBeyondPaper_m); ++i) {
        const auto beyond = mean_brightness(column, view_.row_beyond(edge, kBeyondPaper_m[i]),
                                            view_.row_beyond(edge, kBeyondPaper_m[i - 1]));
        is_seen = is_seen || beyond;
        is_back = is_back || (beyond && std::abs(floor - *beyond) < alike);
      }
      count += is_seen ? 1 : 0;
      back += is_back ? 1 : 0;
    });
    return 2 * back > count;
  }

  /// Whether it is the far side of something bright lying on the floor, whose near side is out of view: the
  /// floor beside it goes on beyond it.
  bool is_far_side(const FloorLine& line) const {
    double near = 0, beyond = 0;
    int count = 0;
    for_each_column(line, [&](int column, double edge, double floor) {
      const double depth = view_.depth(edge);
      const auto there = mean_brightness(column, edge - kBoardFar * depth, edge - kBoardNear * depth);
      if (!there) return;
      near += floor;
      beyond += *there;
      ++count;
    });
    if (count == 0) return false;
    const auto is_beside = [&](double end_column, int towards) {
      const auto beside = brightness_beside(line, static_cast<int>(end_column), towards);
      if (!beside) return false;
      const double brighter = near / count - *beside;
      return brighter > 2 * params_.contrast_min && std::abs(beyond / count - *beside) < kAlike * brighter;
    };
    return is_beside(line.first_column, -1) || is_beside(line.last_column, 1);
  }

  /// What is usual beside an end of the line, as far away as that.
  std::optional<double> brightness_beside(const FloorLine& line, int end_column, int towards) const {
    const double edge = line.row_at(end_column);
    std::array<double, kBesideColumns> beside{};
    std::size_t count = 0;
    for (int i = 1; i <= kBesideColumns; ++i) {
      const int column = end_column + towards * i;
      if (column < 0 || column >= view_.columns()) break;
      if (const auto there = mean_brightness(column, edge - kFloorRows, edge + kFloorRows))
        beside[count++] = *there;
    }
    if (count < kBesideMin) return std::nullopt;
    return median_reordering(std::span(beside).first(count));
  }

  /// @param look  takes a column, the edge's row, and the brightness of the floor before it
  template <class Look>
  void for_each_column(const FloorLine& line, Look look) const {
    for (int column = static_cast<int>(line.first_column); column <= line.last_column; ++column) {
      const double edge = line.row_at(column);
      const auto floor = mean_brightness(column, edge + kBlurRows, edge + kBlurRows + kFloorRows);
      if (floor) look(column, edge, *floor);
    }
  }

  /// Of the rows from one to the other and at least one; nullopt where they are not seen.
  std::optional<double> mean_brightness(int column, double from_row, double to_row) const {
    const LevelView::Rows seen = view_.seen(column);
    const int first = static_cast<int>(from_row);
    const int end = std::max(first + 1, static_cast<int>(to_row) + 1);
    if (first < seen.first || end > seen.end) return std::nullopt;
    const std::uint8_t* grey = view_.column(column);
    return std::accumulate(grey + first, grey + end, 0.0) / (end - first);
  }

  /// From the fit, its bias along the whole line, and the camera's shaking in pitch and roll; roll turns what
  /// lies across its view.
  bool set_deviations(const FloorLine& line, FloorEdge& edge) const {
    SensedSegment& seen = edge.on_floor;
    FloorLine shifted = line, turned = line;
    shifted.row_middle += std::hypot(line.sigma_row, params_.noise.pixel_px);
    turned.slope += line.sigma_slope;
    const auto tilted_start = tilted_floor_.point(edge.start_px),
               tilted_end = tilted_floor_.point(edge.end_px),
               rolled_start = rolled_floor_.point(edge.start_px),
               rolled_end = rolled_floor_.point(edge.end_px);
    if (!tilted_start || !tilted_end || !rolled_start || !rolled_end) return false;
    const Vec2 across = left_normal(unit(seen.heading_rad));
    const Segment2 by_tilt{*tilted_start, *tilted_end}, by_roll{*rolled_start, *rolled_end};
    const Segment2 by_fit{point_of(turned, line.last_column), point_of(turned, line.first_column)};
    const auto off = [&](const Vec2& p) { return across.dot(p - seen.centroid); };
    const auto turn = [&](const Segment2& s) { return wrap_angle(s.heading() - seen.heading_rad); };
    seen.sigma_offset_m = std::hypot(off(point_of(shifted, line.middle())), off(by_tilt.midpoint()));
    seen.sigma_heading_rad = std::hypot(turn(by_fit), turn(by_tilt), turn(by_roll));
    return true;
  }

  FloorEdgeParams params_;
  CameraModel camera_;
  CameraMount mount_;
  LevelView view_;
  FloorBoundary boundary_;
  SkirtingBoardParams board_;
  FloorLineFitter fitter_;
  BackProjection tilted_floor_, rolled_floor_;
  std::vector<FloorLine> ends_;  ///< those of the edges
  std::vector<FloorEdge> edges_;
};

FloorEdgeDetector::FloorEdgeDetector(const FloorEdgeParams& params, const CameraIntrinsics& intrinsics,
                                     const CameraMount& mount)
    : work_(std::make_unique<Work>(params, intrinsics, mount)) {}
FloorEdgeDetector::FloorEdgeDetector(FloorEdgeDetector&&) noexcept = default;
FloorEdgeDetector::~FloorEdgeDetector() = default;

const std::vector<FloorEdge>& FloorEdgeDetector::detect(const Image& grey) {
  return work_->detect(grey);
}

}  // namespace aisle
