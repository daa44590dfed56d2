#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lines/edge_bands.hpp"

namespace aisle {

/// Steps of neighbouring bands that follow each other, from the top down.
struct EdgeChain {
  Step step = Step::kBrighter;
  std::size_t first = 0, count = 0;  ///< range in the points of its EdgeLinker
};

struct LinkParams {
  int band_rows = 4;
  double contrast_min = 4.5;  ///< [grey levels]
  double stray_px = 1.25;
  double slope_max = 0.4;
  double slope_unknown = 0.36;  ///< the slope of a new chain may be this much [px per row]
};

/// Links the steps of bands to chains. Each chain predicts its next point by a filter of position and slope
/// (least squares over its last points); older chains choose first.
class EdgeLinker {
 public:
  /// Replaces the chains by those of an image, the short ones dropped.
  void link(const Image& grey, const LinkParams& params);

  const std::vector<EdgeChain>& chains() const { return chains_; }
  const std::vector<EdgePoint>& points() const { return points_; }

 private:
  /// A chain that may still grow.
  struct Growing {
    Step step = Step::kBrighter;
    float u_px = 0, v_px = 0, slope = 0, contrast = 0;
    int count = 0;
    int last_link = 0;
    int missed = 0;
  };
  struct Link {
    EdgePoint point;
    int previous = -1;
  };

  void grow(const EdgeBand& band);
  int best_edge(const EdgeBand& band, const Growing& chain) const;
  void append(Growing& chain, const EdgePoint& point);
  void start(Step step, const EdgePoint& point);
  void finish(const Growing& chain);

  LinkParams params_;
  EdgeBand band_;
  std::vector<Growing> growing_;
  std::array<std::vector<char>, 2> taken_;
  std::vector<Link> links_;
  std::vector<EdgeChain> chains_;
  std::vector<EdgePoint> points_;
};

}  // namespace aisle
