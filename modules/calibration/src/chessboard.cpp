#include "aisle/calibration/chessboard.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "images.hpp"

namespace aisle {
namespace {

using Corners = std::vector<cv::Point2f>;

constexpr double kSearchedSide_px = 2048;

/// Row by row over the corners of one board.
class CornerGrid {
 public:
  CornerGrid(Corners& corners, const Chessboard& board) : corners_(corners), board_(board) {}

  cv::Point2f& at(int column, int row) const {
    return corners_[static_cast<std::size_t>(row * board_.columns + column)];
  }

  double shortest_spacing_px() const {
    double shortest = 1e9;
    for (int row = 0; row < board_.rows; ++row) {
      for (int column = 0; column < board_.columns; ++column) {
        if (column > 0) shortest = std::min(shortest, cv::norm(at(column, row) - at(column - 1, row)));
        if (row > 0) shortest = std::min(shortest, cv::norm(at(column, row) - at(column, row - 1)));
      }
    }
    return shortest;
  }

  /// Whether rows follow columns clockwise, as on a print that is not seen from behind.
  bool is_mirrored() const {
    const cv::Point2f along = at(board_.columns - 1, 0) - at(0, 0), down = at(0, board_.rows - 1) - at(0, 0);
    return along.cross(down) < 0;
  }

  void mirror() const {
    for (int row = 0; row < board_.rows; ++row) std::reverse(&at(0, row), &at(0, row) + board_.columns);
  }

  void turn_half_round() const { std::reverse(corners_.begin(), corners_.end()); }

  /// How much brighter the squares are that have the colour of the one before the first corner.
  double first_colour_lead(const cv::Mat& grey) const {
    double lead = 0;
    for (int row = 1; row < board_.rows; ++row) {
      for (int column = 1; column < board_.columns; ++column) {
        const cv::Point2f middle = (at(column - 1, row - 1) + at(column, row)) / 2;
        const int brightness = grey.at<std::uint8_t>(cv::Point(middle));
        lead += (row + column) % 2 == 0 ? brightness : -brightness;
      }
    }
    return lead;
  }

 private:
  Corners& corners_;
  const Chessboard& board_;
};

/// The thresholding search finds nearly all boards, the search by Radon transform some of the rest: blurred
/// and steeply seen ones. OpenCV throws where an image is too small for what it tries.
bool is_found(const cv::Mat& grey, const cv::Size& size, Corners& corners) try {
  return cv::findChessboardCorners(grey, size, corners) ||
         cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY);
} catch (const cv::Exception&) {
  return false;
}

/// In a smaller copy of large images, because the searches take 80 bytes and more for every pixel.
bool find_roughly(const cv::Mat& grey, const cv::Size& size, Corners& corners) {
  const double scale = std::max(1.0, static_cast<double>(std::max(grey.cols, grey.rows)) / kSearchedSide_px);
  cv::Mat searched = grey;
  if (scale > 1) cv::resize(grey, searched, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
  if (!is_found(searched, size, corners)) return false;
  const float to_full = static_cast<float>(scale), off = static_cast<float>((scale - 1) / 2);
  for (cv::Point2f& corner : corners) corner = corner * to_full + cv::Point2f(off, off);
  return true;
}

/// Each corner to where the gradients around it point; the window must not reach the next corner.
void refine(const cv::Mat& grey, double spacing_px, Corners& corners) {
  const int half = std::clamp(static_cast<int>(0.4 * spacing_px), 2, 7);
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-3);
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1}, until);
}

}  // namespace

std::vector<Vec3> Chessboard::p_board_corners() const {
  std::vector<Vec3> corners;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      corners.emplace_back(column * square_m, row * square_m, 0);
    }
  }
  return corners;
}

std::vector<Vec2> BoardOnFloor::p_vehicle_corners(const Chessboard& board) const {
  const Vec2 ahead{std::cos(heading_rad), std::sin(heading_rad)}, left{-ahead.y(), ahead.x()};
  const Vec2 middle{(board.columns - 1) * board.square_m / 2, (board.rows - 1) * board.square_m / 2};
  std::vector<Vec2> corners;
  for (const Vec3& p : board.p_board_corners()) {
    corners.push_back(p_vehicle_centre + (middle.y() - p.y()) * ahead + (middle.x() - p.x()) * left);
  }
  return corners;
}

std::optional<std::vector<Vec2>> find_chessboard(const Image& image, const Chessboard& board) {
  const Image grey_image = to_grey(image);
  const cv::Mat grey = as_mat(grey_image);
  Corners corners;
  if (!find_roughly(grey, {board.columns, board.rows}, corners)) return std::nullopt;
  const CornerGrid grid(corners, board);
  refine(grey, grid.shortest_spacing_px(), corners);
  if (grid.is_mirrored()) grid.mirror();
  if (grid.first_colour_lead(grey) > 0) grid.turn_half_round();
  std::vector<Vec2> found;
  for (const cv::Point2f& corner : corners) found.emplace_back(corner.x, corner.y);
  return found;
}

}  // namespace aisle
