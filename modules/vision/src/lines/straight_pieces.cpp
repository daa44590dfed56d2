#include "lines/straight_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr int kJoinRounds = 4;
constexpr double kOverlapBandsMax = 3;      // by which pieces of one line may overlap
constexpr double kJoinOffset_px = 1.6;      // between their ends, across ...
constexpr double kJoinOffsetPerGap = 0.01;  // ... and more over a gap
constexpr double kJoinRms_px = 0.75;        // of the joint line
constexpr double kPieceContrastRatioMax = 4;
constexpr double kTypicalContrast = 0.7;  // quantile of a line's steps that fading is measured against
constexpr std::size_t kFadePoints = 4;    // of which the mean contrast is taken at an end

}  // namespace

void PieceCutter::Sums::add(const EdgePoint& point) {
  const double x = point.u_px, y = point.v_px;
  n += 1;
  u += x;
  v += y;
  uu += x * x;
  uv += x * y;
  vv += y * y;
  contrast += point.contrast;
}

PieceCutter::Sums PieceCutter::Sums::operator+(const Sums& other) const {
  return {n + other.n,
          u + other.u,
          v + other.v,
          uu + other.uu,
          uv + other.uv,
          vv + other.vv,
          contrast + other.contrast};
}

double PieceCutter::Sums::slope() const {
  const double spread = vv - v * v / n;
  return spread > 1e-6 ? (uv - u * v / n) / spread : 0;
}

double PieceCutter::Sums::rms_px() const {
  return std::sqrt(std::max(0.0, (uu - u * u / n - slope() * (uv - u * v / n)) / n));
}

void PieceCutter::cut(const EdgeLinker& linker, const PieceParams& params, std::vector<UprightLine>& lines) {
  params_ = params;
  points_ = linker.points();
  pieces_.clear();
  for (const EdgeChain& chain : linker.chains()) split(chain);
  join_pieces();
  lines.clear();
  for (Piece& piece : pieces_) {
    trim(piece);
    lines.push_back(line_of(piece));
  }
}

void PieceCutter::split(const EdgeChain& chain) {
  stack_.assign(1, {chain.first, chain.first + chain.count - 1});
  while (!stack_.empty()) {
    const Range range = stack_.back();
    stack_.pop_back();
    if (range.last + 1 < range.first + params_.count_min) continue;
    const Sums sums = sums_over(range);
    if (is_straight(range, sums)) {
      if (std::abs(sums.slope()) <= params_.slope_max) pieces_.push_back({chain.step, range, sums});
      continue;
    }
    const std::size_t corner = farthest_from_chord(range);
    stack_.push_back({corner + 1, range.last});
    stack_.push_back({range.first, corner});
  }
}

bool PieceCutter::is_straight(const Range& range, const Sums& sums) const {
  const double slope = sums.slope();
  const double u_first_px = sums.u_at(points_[range.first].v_px);
  for (std::size_t i = range.first; i <= range.last; ++i) {
    const double down_px = points_[i].v_px - points_[range.first].v_px;
    if (std::abs(points_[i].u_px - u_first_px - slope * down_px) > params_.straight_px) return false;
  }
  return true;
}

/// Of the inner points.
std::size_t PieceCutter::farthest_from_chord(const Range& range) const {
  const EdgePoint& first = points_[range.first];
  const EdgePoint& last = points_[range.last];
  const float slope = (last.u_px - first.u_px) / (last.v_px - first.v_px);
  std::size_t farthest = range.first + 1;
  float off_px = 0;
  for (std::size_t i = range.first + 1; i < range.last; ++i) {
    const float off = std::abs(points_[i].u_px - first.u_px - slope * (points_[i].v_px - first.v_px));
    if (off > off_px) {
      off_px = off;
      farthest = i;
    }
  }
  return farthest;
}

PieceCutter::Sums PieceCutter::sums_over(const Range& range) const {
  Sums sums;
  for (std::size_t i = range.first; i <= range.last; ++i) sums.add(points_[i]);
  return sums;
}

/// Occluders, handles and shadows break a line; its straight continuation beyond them is the same line.
void PieceCutter::join_pieces() {
  bool joined = true;
  for (int round = 0; round < kJoinRounds && joined; ++round) {
    joined = false;
    std::sort(pieces_.begin(), pieces_.end(), [this](const Piece& a, const Piece& b) {
      return std::pair(top_px(a), points_[a.points.first].u_px) <
             std::pair(top_px(b), points_[b.points.first].u_px);
    });
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t j = i + 1; j < pieces_.size() && !pieces_[i].joined; ++j) {
        if (top_px(pieces_[j]) - bottom_px(pieces_[i]) > params_.gap_max_px) break;
        if (pieces_[j].joined || !continues(pieces_[i], pieces_[j])) continue;
        join(pieces_[i], pieces_[j]);
        joined = true;
      }
    }
    std::erase_if(pieces_, [](const Piece& piece) { return piece.joined; });
  }
}

bool PieceCutter::continues(const Piece& upper, const Piece& lower) const {
  if (upper.step != lower.step) return false;
  const double gap_px = top_px(lower) - bottom_px(upper);
  const double longer_px = std::max(bottom_px(upper) - top_px(upper), bottom_px(lower) - top_px(lower));
  if (gap_px < -kOverlapBandsMax * params_.band_rows || gap_px > longer_px) return false;
  const double v_px = 0.5 * (top_px(lower) + bottom_px(upper));
  const double offset_px = std::abs(upper.sums.u_at(v_px) - lower.sums.u_at(v_px));
  if (offset_px > kJoinOffset_px * params_.width_share + kJoinOffsetPerGap * std::max(0.0, gap_px))
    return false;
  const double contrasts = upper.contrast() / lower.contrast();
  if (contrasts > kPieceContrastRatioMax || contrasts < 1 / kPieceContrastRatioMax) return false;
  return (upper.sums + lower.sums).rms_px() <= kJoinRms_px * params_.width_share;
}

void PieceCutter::join(Piece& upper, Piece& lower) {
  const std::size_t first = points_.size();
  points_.reserve(first + static_cast<std::size_t>(upper.sums.n + lower.sums.n));
  for (const Piece* piece : {&upper, &lower}) {
    for (std::size_t i = piece->points.first; i <= piece->points.last; ++i) points_.push_back(points_[i]);
  }
  const auto by_row = [](const EdgePoint& a, const EdgePoint& b) { return a.v_px < b.v_px; };
  std::sort(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.end(), by_row);
  upper.points = {first, points_.size() - 1};
  upper.sums = upper.sums + lower.sums;
  lower.joined = true;
}

/// A line's reflection in the floor continues it, but fainter.
void PieceCutter::trim(Piece& piece) {
  Range& range = piece.points;
  contrasts_.clear();
  for (std::size_t i = range.first; i <= range.last; ++i) contrasts_.push_back(points_[i].contrast);
  const auto quantile =
      static_cast<std::ptrdiff_t>(kTypicalContrast * static_cast<double>(contrasts_.size()));
  std::nth_element(contrasts_.begin(), contrasts_.begin() + quantile, contrasts_.end());
  const double least = params_.fade_share * contrasts_[static_cast<std::size_t>(quantile)];
  const auto mean_from = [this](std::size_t first) {
    double sum = 0;
    for (std::size_t i = 0; i < kFadePoints; ++i) sum += points_[first + i].contrast;
    return sum / kFadePoints;
  };
  const Range whole = range;
  while (range.last - range.first > kFadePoints && mean_from(range.first) < least) ++range.first;
  while (range.last - range.first > kFadePoints && mean_from(range.last + 1 - kFadePoints) < least)
    --range.last;
  if (range.first != whole.first || range.last != whole.last) piece.sums = sums_over(range);
}

UprightLine PieceCutter::line_of(const Piece& piece) const {
  UprightLine line;
  line.step = piece.step;
  line.v_top_px = top_px(piece) - 0.5 * params_.band_rows;
  line.v_bottom_px = bottom_px(piece) + 0.5 * params_.band_rows;
  line.slope = piece.sums.slope();
  line.u_middle_px = piece.sums.u_at(0.5 * (line.v_top_px + line.v_bottom_px));
  line.contrast = piece.contrast();
  line.fill = piece.sums.n * params_.band_rows / line.length_px();
  return line;
}

}  // namespace aisle
