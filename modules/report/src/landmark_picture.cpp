#include "aisle/report/landmark_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

constexpr Color kLandmark{0.80, 0.10, 0.20};
constexpr Color kSeen{0.13, 0.47, 0.86, 0.45};
constexpr Color kPlanned{0.68, 0.71, 0.75};
constexpr Color kTrueWall{0.55, 0.59, 0.64};
constexpr Color kDriven{0.05, 0.06, 0.08};

constexpr Pen kPlannedPen{kPlanned, 5};
constexpr Pen kStartPen{kQuietInk, 2.5};
constexpr Pen kTrueWallPen{kTrueWall, 1.25};

constexpr double kSeen_px = 1.5;
constexpr double kSquare_px = 5;
constexpr double kStart_px = 8;

double cross_px(double weight) {
  return std::min(6 * std::sqrt(weight), 14.0);
}

double spot_px(double weight) {
  return std::max(4.5 * std::sqrt(weight), 1.5);
}

class LandmarkDrawing {
 public:
  LandmarkDrawing(const LandmarkPicture& picture, const PictureScale& scale)
      : picture_(picture), scale_(scale), apart_m_(round_length(30 / scale.px_per_m)) {}

  void draw_on(Canvas& canvas) const;

 private:
  void draw_true_walls(Canvas& canvas) const;
  void draw_routes(Canvas& canvas) const;
  void draw_seen(Canvas& canvas) const;
  void draw_driven(Canvas& canvas) const;
  void draw_landmarks(Canvas& canvas) const;
  void draw_legend(Canvas& canvas) const;

  void draw_cross(Canvas& canvas, const Vec2& centre, double weight) const;
  void draw_square(Canvas& canvas, const Vec2& centre) const;
  bool has_landmark(bool is_sure) const;

  const LandmarkPicture& picture_;
  const PictureScale& scale_;
  double apart_m_;  ///< distance between two squares along the path
};

void LandmarkDrawing::draw_on(Canvas& canvas) const {
  canvas.fill(kPaper);
  draw_true_walls(canvas);
  draw_routes(canvas);
  draw_seen(canvas);
  draw_driven(canvas);
  draw_landmarks(canvas);
  draw_header(canvas, scale_, picture_.title, picture_.caption);
  draw_scale_bar(canvas, scale_);
  draw_legend(canvas);
}

void LandmarkDrawing::draw_true_walls(Canvas& canvas) const {
  std::vector<std::pair<Vec2, Vec2>> ends;
  for (const Segment2& wall : picture_.true_walls) {
    ends.emplace_back(scale_.to_paper(wall.start), scale_.to_paper(wall.end));
  }
  canvas.lines(ends, kTrueWallPen);
}

void LandmarkDrawing::draw_routes(Canvas& canvas) const {
  constexpr double kTolerance_px = 0.3;
  for (const Route& route : picture_.routes) {
    if (route.path.empty()) continue;
    std::vector<Vec2> points = points_on(route.path);
    for (Vec2& p : points) p = scale_.to_paper(p);
    canvas.polyline(simplified(points, kTolerance_px), kPlannedPen);
    canvas.disc(points.front(), kStart_px, kPaper);
    canvas.ring(points.front(), kStart_px, kStartPen);
  }
}

/// Dots that would cover each other are merged.
void LandmarkDrawing::draw_seen(Canvas& canvas) const {
  constexpr double kBeyond_m = 0.3;
  std::set<std::pair<int, int>> taken;
  for (const Vec2& p : picture_.seen) {
    const bool is_within = (p.array() > scale_.low.array() - kBeyond_m).all() &&
                           (p.array() < scale_.high.array() + kBeyond_m).all();
    if (!is_within) continue;
    const Vec2 centre = scale_.to_paper(p);
    const std::pair cell(static_cast<int>(centre.x() / kSeen_px), static_cast<int>(centre.y() / kSeen_px));
    if (taken.insert(cell).second) canvas.disc(centre, kSeen_px, kSeen);
  }
}

void LandmarkDrawing::draw_square(Canvas& canvas, const Vec2& centre) const {
  constexpr double kHalf = kSquare_px / 2;
  const Vec2 low = centre - Vec2::Constant(kHalf), high = centre + Vec2::Constant(kHalf);
  canvas.areas({{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}}, kDriven);
}

void LandmarkDrawing::draw_driven(Canvas& canvas) const {
  for (const std::vector<Pose2>& run : picture_.driven) {
    double path_m = 0, next_square_m = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
      if (i > 0) path_m += (run[i].position() - run[i - 1].position()).norm();
      if (path_m < next_square_m) continue;
      draw_square(canvas, scale_.to_paper(run[i].position()));
      while (next_square_m <= path_m) next_square_m += apart_m_;
    }
  }
}

void LandmarkDrawing::draw_cross(Canvas& canvas, const Vec2& centre, double weight) const {
  const double arm = cross_px(weight) / std::sqrt(2.0);
  canvas.lines({{centre - Vec2(arm, arm), centre + Vec2(arm, arm)},
                {centre - Vec2(arm, -arm), centre + Vec2(arm, -arm)}},
               {kLandmark, 2});
}

void LandmarkDrawing::draw_landmarks(Canvas& canvas) const {
  for (const Landmark& landmark : picture_.landmarks.all()) {
    if (landmark.weight <= 0) continue;
    const Vec2 centre = scale_.to_paper(landmark.p_map);
    if (landmark.weight < 1) {
      canvas.disc(centre, spot_px(landmark.weight), kLandmark);
    } else {
      draw_cross(canvas, centre, landmark.weight);
    }
  }
}

bool LandmarkDrawing::has_landmark(bool is_sure) const {
  const auto& all = picture_.landmarks.all();
  return std::any_of(all.begin(), all.end(),
                     [&](const Landmark& l) { return l.weight > 0 && (l.weight >= 1) == is_sure; });
}

/// From right to left, only what the picture contains.
void LandmarkDrawing::draw_legend(Canvas& canvas) const {
  Legend legend(canvas, scale_);
  if (!picture_.true_walls.empty()) legend.add_line("walls (simulated)", kTrueWallPen);
  if (!picture_.routes.empty()) {
    legend.add("start", 2 * kStart_px, [&](const Vec2& p) { canvas.ring(p, kStart_px, kStartPen); });
    legend.add_line("planned path", kPlannedPen);
  }
  if (!picture_.driven.empty()) {
    legend.add(fmt::format("driven, every {:g} m", apart_m_), 25, [&](const Vec2& p) {
      for (const double x : {-10, 0, 10}) draw_square(canvas, p + Vec2(x, 0));
    });
  }
  if (!picture_.seen.empty()) {
    legend.add("lines seen", 16, [&](const Vec2& p) {
      for (const Vec2& off : {Vec2(-5, 2), Vec2(0, -3), Vec2(6, 1)}) canvas.disc(p + off, kSeen_px, kSeen);
    });
  }
  if (has_landmark(false)) {
    legend.add("below weight 1", 10, [&](const Vec2& p) { canvas.disc(p, spot_px(0.6), kLandmark); });
  }
  if (has_landmark(true)) {
    legend.add("landmark", 16, [&](const Vec2& p) { draw_cross(canvas, p, 1.5); });
  }
}

PictureScale fit_scale(const LandmarkPicture& picture) {
  PictureContent content;
  for (const Landmark& landmark : picture.landmarks.all()) {
    if (landmark.weight > 0) content.add(landmark.p_map);
  }
  for (const Route& route : picture.routes) {
    for (const Vec2& p : points_on(route.path)) content.add(p);
  }
  for (const std::vector<Pose2>& run : picture.driven) {
    for (const Pose2& pose : run) content.add(pose.position());
  }
  for (const Segment2& wall : picture.true_walls) {
    content.add(wall.start);
    content.add(wall.end);
  }
  return fit_scale(content);
}

std::string render(const LandmarkPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  const PictureScale scale = fit_scale(picture);
  const LandmarkDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const LandmarkPicture& picture) {
  return render(picture, svg_document);
}

std::string png(const LandmarkPicture& picture) {
  return render(picture, png_file);
}

}  // namespace aisle
