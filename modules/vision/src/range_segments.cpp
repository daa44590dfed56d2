#include "aisle/vision/range_segments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "aisle/core/angle.hpp"
#include "line_fit.hpp"

namespace aisle {

void SegmentParams::describe(FieldList& fields) {
  fields.real("range_min_m", range_min_m, {0, 5}, "nearer readings are the vehicle itself");
  fields.real("range_max_m", range_max_m, {1, 200}, "farther readings are too sparse for segments");
  fields.real("split_m", split_m, {0.005, 1}, "a run of points farther than this from its chord is split");
  fields.real("rms_max_m", rms_max_m, {0.005, 1}, "a rougher fit is not a straight wall");
  fields.real("length_min_m", length_min_m, {0.02, 5}, "shorter segments are dropped");
  fields.count("points_min", points_min, {3, 100}, "segments of fewer points are dropped");
  fields.real("range_sigma_m", range_sigma_m, {0.001, 0.5}, "noise of one reading");
  fields.real("offset_floor_m", offset_floor_m, {0, 0.5}, "least standard deviation of a segment's offset");
  fields.angle("heading_floor_deg", heading_floor_rad, {0, 20},
               "least standard deviation of a segment's heading");
  fields.real("uneven_m", uneven_m, {0, 0.5},
              "how far doors stand off their wall: a segment's heading is not trusted better than this over "
              "its length");
}

namespace {

constexpr std::size_t kMissingBeamsMax = 2;   // a longer hole ends a run of points
constexpr double kGrazing_rad = 8 * kDegree;  // a wall seen flatter than this falls apart
constexpr double kGapFloor_m = 0.06;          // neighbours nearer than this always belong together
constexpr double kNoiseSample = 0.3;          // the straightest share of the points measures the noise ...
constexpr double kNoisePerResidual =
    1 / (0.1903 * 1.2247);                 // ... as its mean is for a Gaussian, chord ends included
constexpr double kQuietScans = 0.15;       // share of the scans with so little clutter that it is the noise
constexpr double kNoiseStep = 0.05;        // with which that quantile is followed
constexpr std::size_t kChordReachMax = 8;  // beams to either side
constexpr double kChordMin_m = 0.2;
constexpr double kSplitSigmas = 3.5;
constexpr double kRoughSigmas = 2;
constexpr double kGapSigmas = 4;
constexpr double kMergeShare = 0.4;     // merged rms, as a share of the split distance
constexpr double kTrimFloor_m = 0.03;   // end points farther off the line are cut
constexpr double kCurveLength_m = 0.4;  // chords of a bent wall are at least this long
constexpr double kCurveGap_m = 0.4;
constexpr double kCurveMin_rad = 1 * kDegree;
constexpr double kCurveMax_rad = 25 * kDegree;

/// Adjoining chords whose headings differ a little are pieces of a bent wall.
void mark_curved(std::vector<SensedSegment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(segments.size(), i + 3); ++j) {
      SensedSegment& a = segments[i];
      SensedSegment& b = segments[j];
      if (a.length_m < kCurveLength_m || b.length_m < kCurveLength_m) continue;
      const double gap_m =
          std::min((a.segment.end - b.segment.start).norm(), (b.segment.end - a.segment.start).norm());
      if (gap_m > kCurveGap_m) continue;
      const double turn = std::abs(wrap_angle(a.heading_rad - b.heading_rad));
      const double noise = 2 * std::hypot(a.sigma_heading_rad, b.sigma_heading_rad);
      if (turn > kCurveMin_rad + noise && turn < kCurveMax_rad) a.curved = b.curved = true;
    }
  }
}

}  // namespace

class RangeSegmenter::Work {
 public:
  Work(const ScanGeometry& geometry, const SegmentParams& params) : geometry_(geometry), params_(params) {}

  void set_geometry(const ScanGeometry& geometry) {
    if (geometry == geometry_) return;
    geometry_ = geometry;
    directions_.clear();
  }

  void extract(std::span<const float> ranges_m, std::vector<SensedSegment>& segments) {
    segments.clear();
    collect_points(ranges_m);
    measure_noise();
    fitter_.assign(points_);
    for (std::size_t first = 0; first < points_.size();) {
      std::size_t last = first;
      while (last + 1 < points_.size() && belong_together(last, last + 1)) ++last;
      if (last + 1 - first >= min_points()) cut_run({first, last}, segments);
      first = last + 1;
    }
    mark_curved(segments);
  }

 private:
  /// Consecutive points first .. last.
  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;

    std::size_t count() const { return last + 1 - first; }
  };

  std::size_t min_points() const { return static_cast<std::size_t>(params_.points_min); }

  void collect_points(std::span<const float> ranges_m) {
    const double reach_m = std::min(params_.range_max_m, geometry_.range_max_m);
    if (directions_.size() != ranges_m.size()) aim(ranges_m.size());
    points_.clear();
    ranges_.clear();
    beams_.clear();
    for (std::size_t k = 0; k < ranges_m.size(); ++k) {
      const double range = ranges_m[k];
      if (!(range >= params_.range_min_m && range < reach_m)) continue;
      points_.push_back(range * directions_[k] + sweep_share(k) * geometry_.swept.position());
      ranges_.push_back(range);
      beams_.push_back(k);
    }
  }

  /// A sensor that turns while it scans looks in directions spread wider or closer.
  void aim(std::size_t beams) {
    directions_.resize(beams);
    for (std::size_t k = 0; k < beams; ++k) {
      const double angle_rad = geometry_.first_angle_rad + geometry_.angle_step_rad * static_cast<double>(k);
      directions_[k] = unit(angle_rad + sweep_share(k) * geometry_.swept.theta);
    }
  }

  /// How far a beam is from the middle of the sweep: -0.5 for the first, 0.5 for the last.
  double sweep_share(std::size_t beam) const {
    const auto last = static_cast<double>(std::max<std::size_t>(directions_.size(), 2) - 1);
    return static_cast<double>(beam) / last - 0.5;
  }

  /// The noise of a point across its wall: its distance from the chord of two points beside it, which must be
  /// long compared with the noise. The distances that decide about segments grow with it.
  void measure_noise() {
    residuals_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t reach = 1; reach <= kChordReachMax && reach <= i && i + reach < points_.size();
           ++reach) {
        if (beams_[i + reach] - beams_[i - reach] != 2 * reach) break;
        const Vec2 chord = points_[i + reach] - points_[i - reach];
        if (chord.squaredNorm() < kChordMin_m * kChordMin_m) continue;
        residuals_.push_back(std::abs(left_normal(chord).dot(points_[i] - points_[i - reach])) /
                             chord.norm());
        break;
      }
    }
    const auto sample = static_cast<std::ptrdiff_t>(kNoiseSample * static_cast<double>(residuals_.size()));
    if (sample < 10) return;
    std::nth_element(residuals_.begin(), residuals_.begin() + sample, residuals_.end());
    const double sum_m = std::accumulate(residuals_.begin(), residuals_.begin() + sample, 0.0);
    const double scan_noise_m = kNoisePerResidual * sum_m / static_cast<double>(sample);
    if (!noise_m_) noise_m_ = scan_noise_m;
    const bool quieter = scan_noise_m < *noise_m_;
    *noise_m_ *= quieter ? 1 - kNoiseStep * (1 - kQuietScans) : 1 + kNoiseStep * kQuietScans;
    sigma_m_ = std::max(params_.range_sigma_m, *noise_m_);
    split_m_ = std::max(params_.split_m, kSplitSigmas * *noise_m_);
    rms_max_m_ = std::max(params_.rms_max_m, kRoughSigmas * *noise_m_);
    gap_m_ = std::max(kGapFloor_m, kGapSigmas * *noise_m_);
  }

  /// Two neighbouring points lie on one surface, unless it would be seen at grazing incidence.
  bool belong_together(std::size_t i, std::size_t j) const {
    const std::size_t beams = beams_[j] - beams_[i];
    if (beams > kMissingBeamsMax + 1) return false;
    const double turn = geometry_.angle_step_rad * static_cast<double>(beams);
    const double slack = std::max(kGrazing_rad - turn, 2 * kDegree);
    const double reach_m = ranges_[i] * std::sin(turn) / std::sin(slack) + gap_m_;
    return (points_[j] - points_[i]).squaredNorm() <= reach_m * reach_m;
  }

  void cut_run(const Run& run, std::vector<SensedSegment>& segments) {
    split(run);
    merge();
    for (const Run& piece : pieces_) finish(piece, segments);
  }

  /// Douglas-Peucker: `pieces_` in the order of the beams, each within split_m of its chord.
  void split(const Run& run) {
    pieces_.clear();
    stack_.assign(1, run);
    while (!stack_.empty()) {
      const Run top = stack_.back();
      stack_.pop_back();
      if (top.count() < min_points()) continue;
      const std::size_t farthest = farthest_from_chord(top);
      if (farthest == top.first) {
        pieces_.push_back(top);
      } else {
        stack_.push_back({farthest, top.last});
        stack_.push_back({top.first, farthest});
      }
    }
  }

  /// The point farthest from the chord of a run; `run.first` if none is farther than split_m.
  std::size_t farthest_from_chord(const Run& run) const {
    const Vec2 origin = points_[run.first];
    const Vec2 chord = points_[run.last] - origin;
    const double length_m = chord.norm();
    const Vec2 normal = length_m > 1e-6 ? Vec2(left_normal(chord) / length_m) : Vec2(1, 0);
    std::size_t farthest = run.first;
    double farthest_m = split_m_;
    for (std::size_t k = run.first + 1; k < run.last; ++k) {
      const double distance_m = std::abs(normal.dot(points_[k] - origin));
      if (distance_m > farthest_m) {
        farthest_m = distance_m;
        farthest = k;
      }
    }
    return farthest;
  }

  /// Unites neighbouring pieces that one line fits.
  void merge() {
    std::size_t kept = 0;
    for (std::size_t k = 1; k < pieces_.size(); ++k) {
      Run& before = pieces_[kept];
      const Run joint{before.first, pieces_[k].last};
      if (pieces_[k].first - before.last <= kMissingBeamsMax && is_straight(joint)) {
        before = joint;
      } else {
        pieces_[++kept] = pieces_[k];
      }
    }
    if (!pieces_.empty()) pieces_.resize(kept + 1);
  }

  bool is_straight(const Run& run) const {
    const LineFit line = fitter_.fit(run.first, run.last);
    if (line.rms_m > kMergeShare * split_m_) return false;
    const Vec2 normal = left_normal(unit(line.heading_rad));
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (std::abs(normal.dot(points_[k] - line.centroid)) > split_m_) return false;
    }
    return true;
  }

  /// Cuts stray end points, which belong to a corner or to the gap beside the wall.
  Run trimmed(Run run) const {
    for (int round = 0; round < 2; ++round) {
      const LineFit line = fitter_.fit(run.first, run.last);
      const double stray_m = std::max(kTrimFloor_m, 2 * line.rms_m);
      while (run.count() > min_points() && std::abs(line.distance(points_[run.first])) > stray_m) ++run.first;
      while (run.count() > min_points() && std::abs(line.distance(points_[run.last])) > stray_m) --run.last;
    }
    return run;
  }

  void finish(const Run& piece, std::vector<SensedSegment>& segments) const {
    const Run run = trimmed(piece);
    const LineFit line = fitter_.fit(run.first, run.last);
    const Vec2 along = unit(line.heading_rad);
    SensedSegment s;
    s.segment.start = line.centroid + along * along.dot(points_[run.first] - line.centroid);
    s.segment.end = line.centroid + along * along.dot(points_[run.last] - line.centroid);
    s.length_m = s.segment.length();
    if (run.count() < min_points() || s.length_m < params_.length_min_m || line.rms_m > rms_max_m_) return;
    s.centroid = line.centroid;
    s.heading_rad = line.heading_rad;
    s.start = end_before(run.first);
    s.end = end_after(run.last);
    if (left_normal(along).dot(line.centroid) > 0) {  // the laser is on the right: turn round
      s.heading_rad = wrap_angle(s.heading_rad + kPi);
      s.segment = s.segment.reversed();
      std::swap(s.start, s.end);
    }
    const double sigma_m = std::max(sigma_m_, line.rms_m);
    s.sigma_offset_m =
        std::hypot(sigma_m / std::sqrt(static_cast<double>(run.count())), params_.offset_floor_m);
    s.sigma_heading_rad = std::hypot(sigma_m / std::sqrt(std::max(1e-6, line.spread_m2)),
                                     params_.heading_floor_rad, params_.uneven_m / s.length_m);
    segments.push_back(s);
  }

  WallEnd end_before(std::size_t point) const {
    return point == 0 ? WallEnd::kUnknown : end_towards(point, point - 1, beams_[point] - beams_[point - 1]);
  }
  WallEnd end_after(std::size_t point) const {
    return point + 1 == points_.size() ? WallEnd::kUnknown
                                       : end_towards(point, point + 1, beams_[point + 1] - beams_[point]);
  }

  /// A wall ends truly where the next surface adjoins (a corner) or is seen behind it; a nearer one only
  /// hides it.
  WallEnd end_towards(std::size_t point, std::size_t neighbour, std::size_t beams) const {
    if (beams > kMissingBeamsMax + 1) return WallEnd::kUnknown;
    const bool adjoins = belong_together(std::min(point, neighbour), std::max(point, neighbour));
    return adjoins || ranges_[neighbour] > ranges_[point] ? WallEnd::kSeen : WallEnd::kUnknown;
  }

  ScanGeometry geometry_;
  SegmentParams params_;
  std::optional<double> noise_m_;
  double sigma_m_ = params_.range_sigma_m;
  double split_m_ = params_.split_m;
  double rms_max_m_ = params_.rms_max_m;
  double gap_m_ = kGapFloor_m;
  std::vector<double> residuals_;
  std::vector<Vec2> directions_;
  std::vector<Vec2> points_;
  std::vector<double> ranges_;
  std::vector<std::size_t> beams_;
  std::vector<Run> stack_;
  std::vector<Run> pieces_;
  RangeLineFitter fitter_;
};

RangeSegmenter::RangeSegmenter(const ScanGeometry& geometry, const SegmentParams& params)
    : work_(std::make_unique<Work>(geometry, params)) {}
RangeSegmenter::~RangeSegmenter() = default;

void RangeSegmenter::extract(std::span<const float> ranges_m, std::vector<SensedSegment>& segments) {
  work_->extract(ranges_m, segments);
}

void RangeSegmenter::extract(const ScanGeometry& geometry, std::span<const float> ranges_m,
                             std::vector<SensedSegment>& segments) {
  work_->set_geometry(geometry);
  work_->extract(ranges_m, segments);
}

}  // namespace aisle
