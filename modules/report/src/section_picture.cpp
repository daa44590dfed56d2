#include "aisle/report/section_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

using Kind = Section::Kind;

struct KindSign {
  Kind kind;
  const char* letter;
  const char* meaning;
  Color color;
};

constexpr KindSign kSigns[] = {{Kind::kFollow, "a", "base line", {0.13, 0.47, 0.86}},
                               {Kind::kHybrid, "h", "base line, then odometry", {0.44, 0.25, 0.70}},
                               {Kind::kDead, "d", "odometry", {0.85, 0.40, 0.10}},
                               {Kind::kCurve, "c", "parabola", {0.15, 0.58, 0.30}},
                               {Kind::kBack, "b", "back", {0.50, 0.50, 0.50}}};
constexpr Pen kDrivenPen{{0.55, 0.59, 0.64}, 1.25};
constexpr double kSectionLine_px = 5;

std::vector<std::vector<Vec2>> section_lines_of(const Route& route) {
  std::vector<std::size_t> piece_sections;
  const Path path = path_of(route.sections, route.path.at(0).T_map_path, &piece_sections);
  std::vector<std::vector<Vec2>> lines(route.sections.size());
  for (std::size_t i = 0; i < piece_sections.size(); ++i) {
    std::vector<Vec2>& line = lines[piece_sections[i]];
    const PathPiece& piece = path.pieces()[i];
    if (line.empty()) line.push_back(piece.T_map_start.position());
    if (!piece.is_on_the_spot()) line.push_back(piece.end().position());
  }
  return lines;
}

class SectionDrawing {
 public:
  SectionDrawing(const SectionPicture& picture, const PictureScale& scale)
      : picture_(picture), scale_(scale) {}

  void draw_on(Canvas& canvas) const {
    canvas.fill(kPaper);
    canvas.polyline(simplified(on_paper(positions()), 0.3), kDrivenPen);
    const auto lines = section_lines_of(picture_.route);
    for (const KindSign& sign : kSigns) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (picture_.route.sections[i].kind == sign.kind) draw_section(canvas, lines[i], sign);
      }
    }
    const Vec2 start = scale_.to_paper(picture_.route.path.at(0).T_map_path.position());
    canvas.disc(start, 8, kPaper);
    canvas.ring(start, 8, {kQuietInk, 2.5});
    draw_header(
        canvas, scale_, picture_.title,
        fmt::format("{} sections, {:.1f} m", picture_.route.sections.size(), picture_.route.path.length_m()));
    draw_scale_bar(canvas, scale_);
    draw_legend(canvas);
  }

 private:
  std::vector<Vec2> positions() const {
    std::vector<Vec2> all;
    for (const Pose2& T : picture_.driven) all.push_back(T.position());
    return all;
  }

  std::vector<Vec2> on_paper(std::vector<Vec2> points) const {
    for (Vec2& p : points) p = scale_.to_paper(p);
    return points;
  }

  void draw_section(Canvas& canvas, const std::vector<Vec2>& line, const KindSign& sign) const {
    const std::vector<Vec2> points = on_paper(line);
    canvas.polyline(points, {sign.color, kSectionLine_px});
    canvas.disc(points.front(), kSectionLine_px, sign.color);
    const Vec2 middle = (points[(points.size() - 1) / 2] + points[points.size() / 2]) / 2;
    canvas.text(middle + Vec2(8, -10), sign.letter, {20, sign.color, true});
  }

  void draw_legend(Canvas& canvas) const {
    Legend legend(canvas, scale_);
    const auto& sections = picture_.route.sections;
    if (!picture_.driven.empty()) legend.add_line(picture_.driven_as, kDrivenPen);
    for (const KindSign& sign : kSigns) {
      const bool is_there = std::any_of(sections.begin(), sections.end(),
                                        [&](const Section& section) { return section.kind == sign.kind; });
      if (is_there)
        legend.add_line(fmt::format("{}: {}", sign.letter, sign.meaning), {sign.color, kSectionLine_px});
    }
  }

  const SectionPicture& picture_;
  const PictureScale& scale_;
};

}  // namespace

std::string svg(const SectionPicture& picture) {
  PictureContent content;
  for (const auto& line : section_lines_of(picture.route)) {
    for (const Vec2& p : line) content.add(p);
  }
  for (const Pose2& T : picture.driven) content.add(T.position());
  const PictureScale scale = fit_scale(content);
  const SectionDrawing drawing(picture, scale);
  return svg_document(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace aisle
