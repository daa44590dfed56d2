#include "walls/wall_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kOneLine_m = 0.08;        // both ends within this of a stronger wall's line: the same wall
constexpr double kOneLineDirection = 0.9;  // cosine of the angle between the two
constexpr double kTouch_m = 0.2;
constexpr double kRival_m = 0.12;          // as far apart as a sighting and its wall may be
constexpr double kRivalDirection = 0.985;  // cosine of 10 degrees
constexpr double kStrengthCap_m = 4;       // longer walls are not stronger
constexpr double kOrthogonalTrust = 3;     // weight against an oblique wall seen as often
constexpr double kBin_m = 0.1;
constexpr std::size_t kGapMaxBins = 3;  // unseen gaps up to this are closed
constexpr int kHitsMin = 2;             // on a path of one leg, one
constexpr std::size_t kBeamStep = 4;    // every fourth beam is enough to detect a gap
constexpr double kBeamReach_m = 12;
constexpr double kBeamPiece_m = 3;
constexpr double kBehind_m = 0.25;  // a beam that goes on this far has passed the wall
constexpr double kGrazing = 0.2;    // sine below which a beam is too grazing to show where it passes
constexpr double kVehicleHalf_m = 0.2;
constexpr double kLeg_m = 0.5;  // on a shorter path nothing new is seen

/// How often something was seen, counted once per leg of the path.
struct LegCount {
  int count = 0;
  int last_leg = -1;

  void add(int leg) {
    if (leg == last_leg) return;
    last_leg = leg;
    ++count;
  }
};

int leg_at(double path_m) {
  return static_cast<int>(path_m / kLeg_m);
}

/// Where a wall was seen, and where it was seen or driven through, along its length.
struct Stroke {
  WallEstimate wall;
  std::vector<LegCount> hits;
  std::vector<LegCount> passes;
  std::vector<bool> driven;

  void make_bins() {
    const auto bins = static_cast<std::size_t>(std::ceil(wall.length_m() / kBin_m)) + 1;
    hits.resize(bins);
    passes.resize(bins);
    driven.resize(bins);
  }
  std::size_t bin(double at_m) const {
    const double last = static_cast<double>(hits.size() - 1);
    return static_cast<std::size_t>(std::clamp(std::floor((at_m - wall.extent.min) / kBin_m), 0.0, last));
  }
  void see(const Interval& span, int leg) {
    for (std::size_t b = bin(span.min); b <= bin(span.max); ++b) hits[b].add(leg);
  }
  /// Where a straight path crosses the wall [m along it].
  std::optional<double> crossing(const Vec2& from, const Vec2& to) const {
    const Vec2 path = to - from;
    const double length_m = path.norm();
    const double sine = wall.normal.dot(path) / length_m;
    if (!(std::abs(sine) > kGrazing)) return std::nullopt;
    const double until_m = -wall.offset_of(from) / sine;
    if (until_m < 0 || until_m > length_m) return std::nullopt;
    return wall.along.dot(from + path * (until_m / length_m) - wall.anchor);
  }
  void see_through(const Vec2& from, const Vec2& to, int leg) {
    const auto at_m = crossing(from, to);
    if (at_m && *at_m > wall.extent.min && *at_m < wall.extent.max) passes[bin(*at_m)].add(leg);
  }
  void drive_through(const Vec2& from, const Vec2& to) {
    const auto at_m = crossing(from, to);
    if (!at_m || *at_m < wall.extent.min - kVehicleHalf_m || *at_m > wall.extent.max + kVehicleHalf_m) return;
    for (std::size_t b = bin(*at_m - kVehicleHalf_m); b <= bin(*at_m + kVehicleHalf_m); ++b) driven[b] = true;
  }
  bool is_open(std::size_t b) const { return driven[b] || passes[b].count > hits[b].count; }
  bool is_solid(std::size_t b, int hits_min) const { return hits[b].count >= hits_min && !is_open(b); }
};

class Drawing {
 public:
  explicit Drawing(const std::vector<WallEstimate>& walls) : stroke_of_wall_(walls.size(), 0) {
    unite(walls);
  }

  void add_sightings(std::span<const WallSighting> sightings) {
    for (const WallSighting& s : sightings) {
      Stroke& stroke = strokes_[stroke_of_wall_[static_cast<std::size_t>(s.wall)]];
      stroke.see(stroke.wall.span_of(s.segment), leg_at(s.path_m));
    }
  }

  void add_beams(const PlacedScan& placed) {
    const std::vector<float>& ranges_m = placed.scan->ranges_m;
    const Vec2 from = placed.T_map_laser.position();
    for (std::size_t beam = 0; beam < ranges_m.size(); beam += kBeamStep) {
      const double range_m = ranges_m[beam];
      if (!(range_m > kBehind_m && range_m < placed.laser.range_max_m)) continue;
      const Vec2 along = unit(placed.T_map_laser.theta + placed.laser.beam_angle(beam));
      const double free_m = std::min(range_m - kBehind_m, kBeamReach_m);
      const int pieces = static_cast<int>(std::ceil(free_m / kBeamPiece_m));
      const Vec2 step = along * (free_m / pieces);
      for (int i = 0; i < pieces; ++i)
        see_through(from + i * step, from + (i + 1) * step, leg_at(placed.path_m));
    }
  }

  void add_drive(const Vec2& from, const Vec2& to) {
    if ((to - from).norm() < 1e-3) return;
    index_.query(from, to, kVehicleHalf_m, near_);
    for (const int s : near_) strokes_[static_cast<std::size_t>(s)].drive_through(from, to);
  }

  /// @param legs  of the path: nothing can be seen on more
  WallMap walls(double length_min_m, int sightings_min, int legs) {
    hits_min_ = std::min(kHitsMin, legs);
    for (std::size_t a = 0; a < strokes_.size(); ++a) {
      const Segment2 segment = strokes_[a].wall.segment();
      index_.query(segment.start, segment.end, kRival_m, near_);
      for (const int b : near_) {
        if (static_cast<std::size_t>(b) > a)
          settle_rivals(strokes_[a], strokes_[static_cast<std::size_t>(b)]);
      }
    }
    WallMap map;
    for (const Stroke& stroke : strokes_) {
      for (std::size_t first = 0; first < stroke.hits.size();) {
        if (!stroke.is_solid(first, hits_min_)) {
          ++first;
          continue;
        }
        const std::size_t last = end_of_run(stroke, first);
        const Wall wall = piece_of(stroke, first, last);
        if (wall.segment.length() >= length_min_m && wall.sightings >= std::min(sightings_min, legs))
          map.walls.push_back(wall);
        first = last + 1;
      }
    }
    return map;
  }

 private:
  /// Merges weaker walls into stronger ones on their line.
  void unite(const std::vector<WallEstimate>& walls) {
    std::vector<std::size_t> order(walls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto strength = [&](std::size_t w) {
      const double trust = walls[w].is_oblique() ? 1 : kOrthogonalTrust;
      return trust * walls[w].sightings * std::min(walls[w].length_m(), kStrengthCap_m);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return strength(a) > strength(b); });
    for (const std::size_t w : order) {
      index_.query(walls[w].segment().start, walls[w].segment().end, kTouch_m, near_);
      const auto host = std::find_if(near_.begin(), near_.end(), [&](int s) {
        return is_part_of(walls[w], strokes_[static_cast<std::size_t>(s)].wall);
      });
      if (host == near_.end()) {
        stroke_of_wall_[w] = strokes_.size();
        strokes_.push_back({walls[w], {}, {}, {}});
      } else {
        stroke_of_wall_[w] = static_cast<std::size_t>(*host);
        take_up(walls[w], strokes_[stroke_of_wall_[w]].wall);
      }
      index_.add(strokes_[stroke_of_wall_[w]].wall.segment(), static_cast<int>(stroke_of_wall_[w]));
    }
    for (Stroke& stroke : strokes_) stroke.make_bins();
  }

  void see_through(const Vec2& from, const Vec2& to, int leg) {
    index_.query(from, to, 0, near_);
    for (const int s : near_) strokes_[static_cast<std::size_t>(s)].see_through(from, to, leg);
  }

  static bool is_part_of(const WallEstimate& wall, const WallEstimate& host) {
    const Segment2 segment = wall.segment();
    return wall.along.dot(host.along) > kOneLineDirection &&
           std::abs(host.offset_of(segment.start)) < kOneLine_m &&
           std::abs(host.offset_of(segment.end)) < kOneLine_m &&
           host.extent.overlap(host.span_of(segment)) > -kTouch_m;
  }

  static void take_up(const WallEstimate& wall, WallEstimate& host) {
    const Interval span = host.span_of(wall.segment());
    if (span.min < host.extent.min) host.start = wall.start;
    if (span.max > host.extent.max) host.end = wall.end;
    host.extent = host.extent.united(span);
    if (wall.is_oblique() != host.is_oblique()) return;
    const double weight = wall.offset_weight * wall.length_m(),
                 host_weight = host.offset_weight * host.length_m();
    host.anchor += host.normal * (host.offset_of(wall.middle()) * weight / (weight + host_weight));
    host.offset_weight += wall.offset_weight;
  }

  /// Of two walls that look the same way, one hides the other: where both were seen, the one that was seen
  /// more often is there. A wall with a kink is two lines that cross.
  void settle_rivals(Stroke& a, Stroke& b) const {
    if (a.wall.along.dot(b.wall.along) < kRivalDirection) return;
    for (std::size_t i = 0; i < a.hits.size(); ++i) {
      const double at_m = a.wall.extent.min + kBin_m * (static_cast<double>(i) + 0.5);
      const Vec2 p = a.wall.anchor + at_m * a.wall.along;
      const double at_b_m = b.wall.along.dot(p - b.wall.anchor);
      if (at_b_m < b.wall.extent.min || at_b_m > b.wall.extent.max) continue;
      if (std::abs(b.wall.offset_of(p)) > kRival_m) continue;
      LegCount &of_a = a.hits[i], &of_b = b.hits[b.bin(at_b_m)];
      if (of_a.count < hits_min_ || of_b.count < hits_min_) continue;
      (of_a.count < of_b.count ? of_a : of_b).count = 0;
    }
  }

  std::size_t end_of_run(const Stroke& stroke, std::size_t first) const {
    std::size_t last = first;
    for (std::size_t b = first + 1; b < stroke.hits.size() && b - last <= kGapMaxBins && !stroke.is_open(b);
         ++b) {
      if (stroke.is_solid(b, hits_min_)) last = b;
    }
    return last;
  }

  static Wall piece_of(const Stroke& stroke, std::size_t first, std::size_t last) {
    const WallEstimate& whole = stroke.wall;
    const bool from_start = first == 0, to_end = last + 2 >= stroke.hits.size();
    const double from_m =
        from_start ? whole.extent.min : whole.extent.min + kBin_m * static_cast<double>(first);
    const double to_m = to_end ? whole.extent.max : whole.extent.min + kBin_m * static_cast<double>(last + 1);
    Wall wall;
    wall.segment = {whole.anchor + from_m * whole.along, whole.anchor + to_m * whole.along};
    wall.is_orthogonal = !whole.is_oblique();
    wall.start = from_start ? whole.start : WallEnd::kSeen;
    wall.end = to_end ? whole.end : WallEnd::kSeen;
    for (std::size_t b = first; b <= last; ++b)
      wall.sightings = std::max(wall.sightings, stroke.hits[b].count);
    wall.sigma_m = std::sqrt(1 / whole.offset_weight);
    return wall;
  }

  std::vector<Stroke> strokes_;
  std::vector<std::size_t> stroke_of_wall_;
  CellIndex index_;
  std::vector<int> near_;
  int hits_min_ = kHitsMin;
};

}  // namespace

WallMap draw_walls(const std::vector<WallEstimate>& walls, std::span<const WallSighting> sightings,
                   std::span<const PlacedScan> scans, double length_min_m, int sightings_min) {
  Drawing drawing(walls);
  drawing.add_sightings(sightings);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    drawing.add_beams(scans[i]);
    if (i > 0) drawing.add_drive(scans[i - 1].T_map_laser.position(), scans[i].T_map_laser.position());
  }
  double path_m = scans.empty() ? 0 : scans.back().path_m;
  for (const WallSighting& s : sightings) path_m = std::max(path_m, s.path_m);
  const int legs = leg_at(path_m) + 1;
  return drawing.walls(length_min_m, sightings_min, legs);
}

}  // namespace aisle
