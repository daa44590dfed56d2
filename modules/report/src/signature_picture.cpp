#include "aisle/report/signature_picture.hpp"

#include <algorithm>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"

namespace aisle {
namespace {

constexpr double kBand_px = 260;  // beside and below the patterns, for the signatures
constexpr double kGap_px = 24;
constexpr Pen kLearnedPen{kInk, 3};
constexpr Pen kSensedPen{kPath, 3};
constexpr Pen kAxisPen{kQuietInk, 1};

class SignatureDrawing {
 public:
  SignatureDrawing(const SignaturePicture& picture, const PictureScale& scale)
      : picture_(picture), scale_(scale) {
    for (const Signature* signature :
         {&picture.learned.x, &picture.learned.y, &picture.sensed.x, &picture.sensed.y})
      for (const SignatureSymbol& symbol : *signature) heaviest_ = std::max(heaviest_, symbol.weight);
  }

  void draw_on(Canvas& canvas) const {
    canvas.fill(kPaper);
    draw_header(canvas, scale_, picture_.title, picture_.caption);
    draw_pattern(canvas, picture_.learned, kLearnedPen, -1);
    draw_pattern(canvas, picture_.sensed, kSensedPen, 1);
    draw_scale_bar(canvas, scale_);
    Legend legend(canvas, scale_);
    legend.add_line("seen", kSensedPen);
    legend.add_line("learned", kLearnedPen);
  }

 private:
  /// @param side  offset of the marks from their true position [px], so that both signatures stay visible
  void draw_pattern(Canvas& canvas, const SignedPattern& pattern, const Pen& pen, double side) const {
    for (const Segment2& wall : pattern.walls)
      canvas.line(scale_.to_paper(wall.start), scale_.to_paper(wall.end), pen);
    const double right_px = scale_.width_px, bottom_px = scale_.height_px + kBand_px - kGap_px;
    const Vec2 low = scale_.to_paper(scale_.low), high = scale_.to_paper(scale_.high);
    canvas.line({low.x(), bottom_px}, {high.x(), bottom_px}, kAxisPen);
    canvas.line({right_px, low.y()}, {right_px, high.y()}, kAxisPen);
    for (const SignatureSymbol& symbol : pattern.x) {
      const double x_px = scale_.to_paper({symbol.position_m, scale_.low.y()}).x() + side;
      canvas.line({x_px, bottom_px}, {x_px, bottom_px - height_px(symbol)}, pen);
    }
    for (const SignatureSymbol& symbol : pattern.y) {
      const double y_px = scale_.to_paper({scale_.low.x(), symbol.position_m}).y() + side;
      canvas.line({right_px, y_px}, {right_px + height_px(symbol), y_px}, pen);
    }
  }

  double height_px(const SignatureSymbol& symbol) const {
    return symbol.weight / heaviest_ * (kBand_px - 2 * kGap_px);
  }

  const SignaturePicture& picture_;
  const PictureScale& scale_;
  double heaviest_ = 1e-9;
};

}  // namespace

std::string svg(const SignaturePicture& picture) {
  PictureContent content;
  for (const SignedPattern* pattern : {&picture.learned, &picture.sensed}) {
    for (const Segment2& wall : pattern->walls) {
      content.add(wall.start);
      content.add(wall.end);
    }
  }
  const PictureScale scale = fit_scale(content);
  const SignatureDrawing drawing(picture, scale);
  return svg_document(scale.width_px + static_cast<int>(kBand_px),
                      scale.height_px + static_cast<int>(kBand_px),
                      [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace aisle
