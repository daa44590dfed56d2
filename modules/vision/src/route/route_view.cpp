#include "aisle/vision/route/route_view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace aisle {
namespace {

constexpr int kEdgeColumns = 80;
constexpr int kPatchesInHeight = 6;
constexpr double kDarkShare = 0.65;  // of the patch's grey level: what is darker is not route

constexpr int kNearest_px = 3,
              kFarthest_px = 7;             // from a floor point, the rows that are compared
constexpr double kFloorEdgeStepMin = 0.05;  // of the floor's grey level, between them
constexpr double kThingLength_m = 0.5;      // pieces of obstacles longer than this are checked one by one
constexpr double kThingGap_m = 0.15;        // between neighbouring places of one
constexpr double kLeavesView_m = 0.15;      // a return this near to the lower edge leaves the image ...
constexpr std::size_t kEndPoints = 5;       // ... in the direction of this many returns

/// How many of the first laser returns, from right to left, are of one obstacle.
std::size_t points_of_one_thing(std::span<const Vec2> p_vehicle_returns) {
  std::size_t count = 1;
  while (count < p_vehicle_returns.size() &&
         (p_vehicle_returns[count] - p_vehicle_returns[count - 1]).norm() <= kThingGap_m &&
         (p_vehicle_returns[count] - p_vehicle_returns[0]).norm() <= kThingLength_m)
    ++count;
  return count;
}

/// Share of the columns from `begin` to before `end` that is route.
double route_share(const Image& mask, int begin, int end) {
  long count = 0;
  for (int v = 0; v < mask.height_px; ++v)
    count += std::count(mask.row(v) + begin, mask.row(v) + end, std::uint8_t{255});
  return static_cast<double>(count) / (static_cast<double>(end - begin) * mask.height_px);
}

/// L96 section 2.2: the square patch before the vehicle.
void measure_patch(const Image& image, RouteSight& sight) {
  const int side = image.height_px / kPatchesInHeight, u0 = (image.width_px - side) / 2;
  double sum = 0, squares = 0;
  for (int v = image.height_px - side; v < image.height_px; ++v) {
    for (int u = u0; u < u0 + side; ++u) {
      const double grey = image.row(v)[static_cast<std::ptrdiff_t>(u) * image.channels];
      sum += grey;
      squares += grey * grey;
    }
  }
  const double count = static_cast<double>(side) * side;
  sight.patch_grey = sum / count;
  sight.patch_deviation = std::sqrt(std::max(0.0, squares / count - sight.patch_grey * sight.patch_grey));
}

/// L96 section 2.2: an obstacle that stands alone on the route is known by its grey level.
void take_out_dark(const Image& image, RouteSight& sight) {
  const double least = kDarkShare * sight.patch_grey;
  for (int v = 0; v < image.height_px; ++v) {
    std::uint8_t* route = sight.mask.row(v);
    for (int u = 0; u < image.width_px; ++u)
      if (image.row(v)[static_cast<std::ptrdiff_t>(u) * image.channels] < least) route[u] = 0;
  }
}

/// The pixel that sees the nearest floor straight ahead.
Vec2 lowest_middle(int width_px, int height_px) {
  return {(width_px - 1) / 2.0, height_px - 1};
}

}  // namespace

void RouteViewParams::describe(FieldList& fields) {
  fields.group("region", region);
  fields.group("stripe", stripe);
  fields.real("far_scan_m", far_scan_m, {0.3, 20}, "floor distance of the upper scan line from the camera");
  fields.real("near_scan_m", near_scan_m, {0.3, 20}, "floor distance of the lower scan line from the camera");
  fields.real("check_ahead_m", check_ahead_m, {0.05, 5},
              "how far beyond the view's lower edge region A reaches");
  fields.real("check_beside_m", check_beside_m, {0.02, 2},
              "how wide regions B and C are, beside the vehicle");
  fields.real("check_share", check_share, {0, 1}, "a check region with a smaller share of route is occupied");
  fields.real("edge_range_m", edge_range_m, {0.5, 20}, "farther edges of the route are not remembered");
}

bool RouteView::sees_floor(const CameraIntrinsics& intrinsics, const CameraMount& mount, int width_px,
                           int height_px) {
  const BackProjection floor(CameraModel(intrinsics), mount, 0);
  return floor.point(lowest_middle(width_px, height_px)).has_value();
}

RouteView::RouteView(const RouteViewParams& params, const CameraIntrinsics& intrinsics,
                     const CameraMount& mount, int width_px, int height_px, double width_m,
                     std::optional<double> stripe_height_m)
    : params_(params),
      regions_(params.region),
      camera_(intrinsics),
      mount_(mount),
      floor_(camera_, mount, 0),
      width_px_(width_px),
      height_px_(height_px) {
  const auto nearest = floor_.point(lowest_middle(width_px, height_px));
  if (!nearest) throw std::invalid_argument("a camera for routes must look down at the floor");
  nearest_m_ = nearest->x();
  const int patch_px = height_px / kPatchesInHeight;
  p_vehicle_patch_ = floor_.point(Vec2((width_px - patch_px) / 2.0, height_px - patch_px)).value_or(*nearest);
  const double camera_m = mount.p_vehicle_camera.x();
  far_row_ = row_at(std::max(nearest_m_, camera_m + params.far_scan_m));
  near_row_ = row_at(std::max(nearest_m_, camera_m + params.near_scan_m));
  const double side_m = width_m / 2, beside_m = side_m + params.check_beside_m;
  ahead_ = patch_of(nearest_m_, nearest_m_ + params.check_ahead_m, {-side_m, side_m});
  left_ = patch_of(nearest_m_, nearest_m_ + params.check_ahead_m / 2, {side_m, beside_m});
  right_ = patch_of(nearest_m_, nearest_m_ + params.check_ahead_m / 2, {-beside_m, -side_m});
  if (!stripe_height_m) return;
  stripe_height_m_ = *stripe_height_m;
  stripe_.emplace(params.stripe, intrinsics, mount, width_px, height_px, stripe_height_m_);
}

std::optional<Vec2> RouteView::projected(const Vec2& p_vehicle, double height_m) const {
  return camera_.project(mount_.to_camera({p_vehicle.x(), p_vehicle.y(), height_m}));
}

std::optional<Vec2> RouteView::pixel_of(const Vec2& p_vehicle) const {
  auto pixel = projected(p_vehicle, 0);
  if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > width_px_ - 1 || pixel->y() > height_px_ - 1)
    return std::nullopt;
  return pixel;
}

int RouteView::row_at(double ahead_m) const {
  const auto pixel = pixel_of({ahead_m, mount_.p_vehicle_camera.y()});
  return pixel ? static_cast<int>(std::lround(pixel->y())) : height_px_ - 1;
}

RouteView::FloorPatch RouteView::patch_of(double ahead_from_m, double ahead_to_m,
                                          const Interval& lateral_m) const {
  constexpr double kGrid_m = 0.02;
  FloorPatch patch;
  const int rows = static_cast<int>((ahead_to_m - ahead_from_m) / kGrid_m);
  const int columns = static_cast<int>(lateral_m.length() / kGrid_m);
  for (int i = 0; i <= rows; ++i) {
    for (int k = 0; k <= columns; ++k) {
      const auto pixel = pixel_of({ahead_from_m + i * kGrid_m, lateral_m.min + k * kGrid_m});
      if (!pixel) continue;
      patch.push_back(static_cast<std::size_t>(std::lround(pixel->y())) *
                          static_cast<std::size_t>(width_px_) +
                      static_cast<std::size_t>(std::lround(pixel->x())));
    }
  }
  return patch;
}

bool RouteView::is_occupied(const Image& mask, const FloorPatch& patch) const {
  const auto route =
      std::count_if(patch.begin(), patch.end(), [&](std::size_t i) { return mask.bytes[i] != 0; });
  return static_cast<double>(route) < params_.check_share * static_cast<double>(patch.size());
}

const RouteSight& RouteView::look(const Image& image) {
  if (!sight_) sight_.emplace();
  RouteSight& sight = *sight_;
  regions_.find(image, sight.mask);
  measure_patch(image, sight);
  take_out_dark(image, sight);
  if (stripe_) take_out_lit(image, sight.mask);
  sight.share = route_share(sight.mask, 0, width_px_);
  sight.checks = {.ahead = is_occupied(sight.mask, ahead_),
                  .left = is_occupied(sight.mask, left_),
                  .right = is_occupied(sight.mask, right_),
                  .left_share = route_share(sight.mask, 0, width_px_ / 2),
                  .right_share = route_share(sight.mask, width_px_ / 2, width_px_)};
  find_edges(sight);
  return sight;
}

/// An obstacle with a floor edge below the stripe hides the floor behind it. A stripe without a floor edge is
/// no obstacle: a line painted on the floor farther away looks like it.
void RouteView::take_out_lit(const Image& image, Image& mask) {
  find_lit_pieces(as_grey(image, grey_));
  for (std::size_t i = 0; i < lit_pieces_.size(); ++i) {
    const LitPiece& piece = lit_pieces_[i];
    if (!piece.has_floor_edge.value_or(false)) continue;
    const std::span<const Vec2> p_vehicle = piece.p_vehicle;
    for (std::size_t k = 0; k + 1 < p_vehicle.size(); ++k)
      take_out_above(p_vehicle[k], p_vehicle[k + 1], mask);
    const bool goes_on_left = i + 1 < lit_pieces_.size() && lit_pieces_[i + 1].goes_on;
    const std::size_t end = p_vehicle.size() - 1, inwards = std::min(kEndPoints, end);
    if (!piece.goes_on && leaves_view(p_vehicle[inwards], p_vehicle.front()))
      take_out_columns(floor_point_column(p_vehicle.front()), width_px_, mask);
    if (!goes_on_left && leaves_view(p_vehicle[end - inwards], p_vehicle.back()))
      take_out_columns(0, floor_point_column(p_vehicle.back()), mask);
  }
}

/// A piece whose floor edge is out of view is taken to be of one obstacle with the piece beside it.
void RouteView::find_lit_pieces(const Image& grey) {
  stripe_->find(grey);
  p_vehicle_returns_.clear();
  stripe_->append_lit(p_vehicle_returns_);
  lit_pieces_.clear();
  for (std::span<const Vec2> rest(p_vehicle_returns_); !rest.empty();) {
    const std::span<const Vec2> piece = rest.first(points_of_one_thing(rest));
    const bool goes_on = !lit_pieces_.empty() && &lit_pieces_.back().p_vehicle.back() == piece.data();
    if (piece.size() > 1) lit_pieces_.push_back({piece, goes_on, has_floor_edge(grey, piece)});
    rest = rest.subspan(std::max<std::size_t>(1, piece.size() - 1));
  }
  const auto learn_from = [](LitPiece& piece, const LitPiece& beside) {
    if (!piece.has_floor_edge) piece.has_floor_edge = beside.has_floor_edge;
  };
  for (std::size_t i = 1; i < lit_pieces_.size(); ++i)
    if (lit_pieces_[i].goes_on) learn_from(lit_pieces_[i], lit_pieces_[i - 1]);
  for (std::size_t i = lit_pieces_.size(); i-- > 1;)
    if (lit_pieces_[i].goes_on) learn_from(lit_pieces_[i - 1], lit_pieces_[i]);
}

/// Whether the brightness steps at the floor points beneath the laser returns; nullopt: out of view.
std::optional<bool> RouteView::has_floor_edge(const Image& grey,
                                              std::span<const Vec2> p_vehicle_thing) const {
  double above = 0, below = 0;
  for (const Vec2& p_vehicle : p_vehicle_thing) {
    const auto floor_point = pixel_of(p_vehicle);
    if (!floor_point) continue;
    const auto u = static_cast<int>(std::lround(floor_point->x())),
               v = static_cast<int>(std::lround(floor_point->y()));
    if (v < kFarthest_px || v + kFarthest_px >= height_px_) continue;
    for (int i = kNearest_px; i <= kFarthest_px; ++i) {
      above += grey.row(v - i)[u];
      below += grey.row(v + i)[u];
    }
  }
  if (below == 0) return std::nullopt;
  return std::abs(above - below) > kFloorEdgeStepMin * below;
}

/// Whether the light on an obstacle goes on below the image's lower edge: what is beside it in the image then
/// belongs to the obstacle, or is behind it.
bool RouteView::leaves_view(const Vec2& p_vehicle_inwards, const Vec2& p_vehicle_end) const {
  const Vec2 outwards = p_vehicle_end - p_vehicle_inwards;
  if (outwards.isZero()) return false;
  const auto pixel = projected(p_vehicle_end + kLeavesView_m * outwards.normalized(), stripe_height_m_);
  return pixel && pixel->y() > height_px_ - 1;
}

/// The column of a laser return's floor point, even if that is below the view.
int RouteView::floor_point_column(const Vec2& p_vehicle) const {
  const auto floor_point = projected(p_vehicle, 0);
  return floor_point ? std::clamp(static_cast<int>(std::lround(floor_point->x())), 0, width_px_)
                     : width_px_ / 2;
}

void RouteView::take_out_columns(int begin, int end, Image& mask) const {
  for (int v = 0; v < height_px_; ++v) std::fill(mask.row(v) + begin, mask.row(v) + end, std::uint8_t{0});
}

/// Masks all that is seen on and above a line on the floor.
void RouteView::take_out_above(const Vec2& p_vehicle_right, const Vec2& p_vehicle_left, Image& mask) const {
  const auto right = projected(p_vehicle_right, 0), left = projected(p_vehicle_left, 0);
  if (!right || !left || right->x() <= left->x()) return;
  const int first = std::max(0, static_cast<int>(std::floor(left->x())));
  const int last = std::min(width_px_ - 1, static_cast<int>(std::ceil(right->x())));
  for (int u = first; u <= last; ++u) {
    const double share = std::clamp((u - left->x()) / (right->x() - left->x()), 0.0, 1.0);
    const double row = left->y() + share * (right->y() - left->y());
    const int lowest = std::min(height_px_ - 1, static_cast<int>(std::lround(row)));
    for (int v = 0; v <= lowest; ++v) mask.row(v)[u] = 0;
  }
}

/// In each of many columns, the lowest pixel that is not route: the floor point of the obstacle there, unless
/// that is below the view.
void RouteView::find_edges(RouteSight& sight) const {
  sight.p_vehicle_edges.clear();
  sight.p_vehicle_cut_off.clear();
  for (int i = 0; i < kEdgeColumns; ++i) {
    const int u = (2 * i + 1) * width_px_ / (2 * kEdgeColumns);
    int v = height_px_ - 1;
    while (v >= 0 && sight.mask.row(v)[u] != 0) --v;
    if (v < 0) continue;
    const auto p_vehicle = floor_.point(Vec2(u, v));
    if (!p_vehicle || p_vehicle->x() - nearest_m_ > params_.edge_range_m) continue;
    (v == height_px_ - 1 ? sight.p_vehicle_cut_off : sight.p_vehicle_edges).push_back(*p_vehicle);
  }
}

bool RouteView::sees_route(const RouteSight& sight, const Vec2& p_vehicle) const {
  const auto pixel = pixel_of(p_vehicle);
  return pixel && sight.mask.row(static_cast<int>(std::lround(pixel->y())))[std::lround(pixel->x())] != 0;
}

bool RouteView::is_before_patch_end(const Vec2& p_vehicle) const {
  return p_vehicle.x() > 0 && p_vehicle.x() < p_vehicle_patch_.x() &&
         std::abs(p_vehicle.y()) < std::abs(p_vehicle_patch_.y());
}

std::optional<Vec2> RouteView::middle(const RouteSight& sight, double mask_left, double mask_right) const {
  const int left = static_cast<int>(mask_left * width_px_);
  const int right = width_px_ - static_cast<int>(mask_right * width_px_);
  const auto middle = find_route_middle(sight.mask, far_row_, near_row_, left, right);
  if (!middle) return std::nullopt;
  return floor_.point(Vec2(middle->mean_px.x(), (far_row_ + near_row_) / 2.0));
}

}  // namespace aisle
