#include "aisle/report/picture_sheet.hpp"

#include <algorithm>
#include <stdexcept>

#include "canvas.hpp"
#include "palette.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPicturesInRow = 4;
constexpr int kBetweenPictures_px = 6;
constexpr double kTitleHeight_px = 17;

}  // namespace

std::string picture_sheet_png(std::span<const TakenPicture> pictures) {
  if (pictures.empty()) throw std::invalid_argument("a sheet needs at least one picture");
  int width_px = 0, height_px = 0;
  for (const TakenPicture& taken : pictures) {
    width_px = std::max(width_px, taken.picture.width_px + kBetweenPictures_px);
    height_px = std::max(height_px, taken.picture.height_px + kBetweenPictures_px);
  }
  const std::size_t columns = std::min(pictures.size(), kPicturesInRow);
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  const int sheet_width_px = static_cast<int>(columns) * width_px - kBetweenPictures_px;
  const int sheet_height_px = static_cast<int>(rows) * height_px - kBetweenPictures_px;
  return png_file(sheet_width_px, sheet_height_px, [&](Canvas& canvas) {
    canvas.fill(kPaper);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const std::size_t row = i / columns, column = i % columns;
      const Vec2 corner(static_cast<double>(column) * width_px, static_cast<double>(row) * height_px);
      canvas.image(pictures[i].picture, corner);
      canvas.text(corner + Vec2(6, kTitleHeight_px), pictures[i].title, {kTitleHeight_px - 3, kPaper, true});
    }
  });
}

}  // namespace aisle
