#include "aisle/report/trajectory_picture.hpp"

#include <utility>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"

namespace aisle {
namespace {

constexpr Pen kTruePathPen{kInk, 3};
constexpr Pen kComparedPathPen{kPath, 1.75};
constexpr Pen kErrorPen{{0.86, 0.20, 0.18}, 1.25};

void draw_trajectories(Canvas& canvas, const TrajectoryPicture& picture, const PictureScale& scale) {
  const auto on_paper = [&](std::span<const Pose2> poses) {
    std::vector<Vec2> points;
    points.reserve(poses.size());
    for (const Pose2& pose : poses) points.push_back(scale.to_paper(pose.position()));
    return points;
  };
  const std::vector<Vec2> path = on_paper(picture.path), truth = on_paper(picture.truth);
  std::vector<std::pair<Vec2, Vec2>> errors;
  errors.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) errors.emplace_back(path[i], truth[i]);
  canvas.fill(kPaper);
  canvas.polyline(truth, kTruePathPen);
  canvas.lines(errors, kErrorPen);
  canvas.polyline(path, kComparedPathPen);
  draw_header(canvas, scale, picture.title, picture.caption);
  draw_scale_bar(canvas, scale);
  Legend legend(canvas, scale);
  legend.add_line("error", kErrorPen);
  legend.add_line("path", kComparedPathPen);
  legend.add_line("true path", kTruePathPen);
}

std::string render_trajectories(const TrajectoryPicture& picture,
                                std::string (*make)(int, int, const Drawing&)) {
  PictureContent content;
  for (const auto& poses : {picture.path, picture.truth}) {
    for (const Pose2& pose : poses) content.add(pose.position());
  }
  const PictureScale scale = fit_scale(content);
  return make(scale.width_px, scale.height_px,
              [&](Canvas& canvas) { draw_trajectories(canvas, picture, scale); });
}

}  // namespace

std::string svg(const TrajectoryPicture& picture) {
  return render_trajectories(picture, svg_document);
}

std::string png(const TrajectoryPicture& picture) {
  return render_trajectories(picture, png_file);
}

}  // namespace aisle
