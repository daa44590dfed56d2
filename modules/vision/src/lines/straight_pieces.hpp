#pragma once

#include <span>
#include <vector>

#include "lines/edge_chains.hpp"
#include "lines/upright_line.hpp"

namespace aisle {

struct PieceParams {
  int band_rows = 4;
  std::size_t count_min = 4;  ///< points of a piece
  double straight_px = 1.3;   ///< no point of a piece is farther from its line
  double slope_max = 0.33;
  double gap_max_px = 58;    ///< between collinear pieces that are one line
  double fade_share = 0.45;  ///< ends of less than this share of the line's contrast are cut
  double width_share = 1;    ///< the working image's width as a share of 640 px
};

/// Cuts chains of steps where they bend, joins the pieces that continue each other, and trims ends that fade.
class PieceCutter {
 public:
  /// Replaces `lines` by those of the chains of `linker`.
  void cut(const EdgeLinker& linker, const PieceParams& params, std::vector<UprightLine>& lines);

 private:
  struct Sums {
    double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0, contrast = 0;

    void add(const EdgePoint& point);
    Sums operator+(const Sums& other) const;
    double slope() const;
    double u_at(double v_px) const { return u / n + slope() * (v_px - v / n); }
    double rms_px() const;
  };
  struct Range {
    std::size_t first = 0, last = 0;  ///< inclusive
  };
  struct Piece {
    Step step = Step::kBrighter;
    Range points;  ///< of points_
    Sums sums;
    bool joined = false;  ///< it has become part of another

    double contrast() const { return sums.contrast / sums.n; }
  };

  void split(const EdgeChain& chain);
  bool is_straight(const Range& range, const Sums& sums) const;
  std::size_t farthest_from_chord(const Range& range) const;
  Sums sums_over(const Range& range) const;
  void join_pieces();
  bool continues(const Piece& upper, const Piece& lower) const;
  void join(Piece& upper, Piece& lower);
  void trim(Piece& piece);
  UprightLine line_of(const Piece& piece) const;
  double top_px(const Piece& piece) const { return points_[piece.points.first].v_px; }
  double bottom_px(const Piece& piece) const { return points_[piece.points.last].v_px; }

  PieceParams params_;
  std::vector<EdgePoint> points_;
  std::vector<Range> stack_;
  std::vector<Piece> pieces_;
  std::vector<float> contrasts_;
};

}  // namespace aisle
