/// Landmarks from a real camera: a robot among numbered posts (UTIAS MRCLAM, Leung et al. 2011), whose
/// numbers are hidden from the method, and other robots, which it takes for posts until they move.
///   real_landmarks [FOLDER [ROBOT [DELAY_S]]]    FOLDER with Landmark_Groundtruth.dat, Barcodes.dat,
///                                                RobotN_Odometry.dat and RobotN_Measurement.dat;
///                                                DELAY_S: what is seen is stamped later than what the wheels
///                                                do
/// Learns the posts from wheel odometry and sightings, localises among them, and prints what that is off
/// against the surveyed posts. The pose that it is compared with is one by the numbers and the survey: a
/// filter over the same odometry and sightings, itself a few centimetres off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "aisle/learning/landmarks/landmark_relocation.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "landmarks/point_fit.hpp"

using namespace aisle;
namespace fs = std::filesystem;

namespace {

constexpr double kRange = 0.05;  // sigma of a sighting's range, as a share of it ...
constexpr double kBearing_rad = 0.02;
constexpr double kSameImage_s = 0.005;
constexpr double kCycle_s = 0.25;  // longest
constexpr double kStep_m = 1e-6;   // the odometry states speeds, not steps

/// What the folder holds of one robot.
struct Recording {
  VehicleDescription vehicle;
  std::vector<LandmarkCycle> cycles;
  std::vector<std::vector<int>> subjects;  ///< of each cycle's sightings; for the reference alone
  std::map<int, Vec2> p_survey_posts;
};

using Row = std::vector<double>;

std::vector<Row> rows_of(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    Row row;
    for (double value = 0; words >> value;) row.push_back(value);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

/// An iRobot Create whose wheels nobody has calibrated.
VehicleDescription create() {
  VehicleDescription vehicle;
  vehicle.name = "create";
  vehicle.is_differential = true;
  vehicle.differential.steps_per_turn = 1000000;
  vehicle.differential.wheel_radius_m = kStep_m * 1e6 / (2 * kPi);
  vehicle.differential.wheel_separation_m = 0.258;
  vehicle.differential_noise = {
      .wheel_scale = 0.05, .wheel_slip_m_per_sqrt_m = 0.02, .separation_scale = 0.05};
  return vehicle;
}

/// The path of each wheel to any time, from speeds that last until the next ones are stated.
class WheelPaths {
 public:
  WheelPaths(const std::vector<Row>& speeds, double separation_m)
      : speeds_(speeds), separation_m_(separation_m) {}

  /// @param until_s  not before that of the call before
  WheelSteps steps_until(double until_s) {
    while (at_ + 1 < speeds_.size() && speeds_[at_ + 1][0] <= until_s) {
      add(speeds_[at_ + 1][0]);
      ++at_;
    }
    add(until_s);
    const auto whole = [](double path_m) { return static_cast<int>(std::lround(path_m / kStep_m)); };
    const WheelSteps steps{whole(left_m_), whole(right_m_)};
    left_m_ -= steps.left * kStep_m;
    right_m_ -= steps.right * kStep_m;
    return steps;
  }

 private:
  void add(double until_s) {
    const double duration_s = std::max(0.0, until_s - now_s_.value_or(until_s));
    const double half = speeds_[at_][2] * separation_m_ / 2;
    left_m_ += (speeds_[at_][1] - half) * duration_s;
    right_m_ += (speeds_[at_][1] + half) * duration_s;
    now_s_ = until_s;
  }

  const std::vector<Row>& speeds_;
  double separation_m_;
  std::size_t at_ = 0;
  std::optional<double> now_s_;
  double left_m_ = 0, right_m_ = 0;
};

LandmarkSighting sighting_of(double range_m, double bearing_rad) {
  const Vec2 away = unit(bearing_rad), left = left_normal(away);
  return {.p_vehicle = range_m * away,
          .covariance = square(kRange * range_m) * away * away.transpose() +
                        square(kBearing_rad * range_m) * left * left.transpose()};
}

Recording read_recording(const fs::path& folder, int robot, double delay_s) {
  Recording recording{.vehicle = create(), .cycles = {}, .subjects = {}, .p_survey_posts = {}};
  for (const Row& row : rows_of(folder / "Landmark_Groundtruth.dat"))
    recording.p_survey_posts[static_cast<int>(row.at(0))] = {row.at(1), row.at(2)};
  std::map<int, int> subject_of;
  for (const Row& row : rows_of(folder / "Barcodes.dat"))
    subject_of[static_cast<int>(row.at(1))] = static_cast<int>(row.at(0));
  const auto speeds = rows_of(folder / fmt::format("Robot{}_Odometry.dat", robot));
  const auto seen = rows_of(folder / fmt::format("Robot{}_Measurement.dat", robot));
  WheelPaths wheels(speeds, recording.vehicle.differential.wheel_separation_m);
  const auto begin_cycle = [&](double stamp_s) {
    recording.cycles.push_back(
        {.stamp_s = stamp_s, .odometry = wheels.steps_until(stamp_s), .sightings = {}, .floor_edges = {}});
    recording.subjects.emplace_back();
  };
  begin_cycle(speeds.front().at(0));
  for (Row row : seen) {
    row.at(0) -= delay_s;
    while (row.at(0) - recording.cycles.back().stamp_s > kCycle_s)
      begin_cycle(recording.cycles.back().stamp_s + kCycle_s);
    if (row.at(0) - recording.cycles.back().stamp_s > kSameImage_s) begin_cycle(row.at(0));
    const auto subject = subject_of.find(static_cast<int>(row.at(1)));
    recording.cycles.back().sightings.push_back(sighting_of(row.at(2), row.at(3)));
    recording.subjects.back().push_back(subject == subject_of.end() ? 0 : subject->second);
  }
  return recording;
}

/// The pose by the numbers and the survey.
class Reference {
 public:
  explicit Reference(const Recording& recording) : recording_(recording), posts_(recording.p_survey_posts) {
    run(best_start());
    for (const auto& [subject, fit] : fits_) {
      if (fit.misfits * 2 <= fit.sightings) continue;
      misnumbered_.push_back(subject);
      posts_.erase(subject);
    }
    run(best_start());
  }

  const std::vector<UncertainPose2>& poses() const { return T_survey_vehicle_; }
  /// Posts most of whose sightings are far from where the survey has their number.
  const std::vector<int>& misnumbered() const { return misnumbered_; }

 private:
  static constexpr double kMisfit = 16;  // squared standard deviations
  static constexpr double kStart_s = 150;

  struct Fit {
    int sightings = 0, misfits = 0;
  };

  /// @return the sum of squared deviations, each at most kMisfit
  double run(const Pose2& T_survey_start, double duration_s = 1e9) {
    PoseFilter filter(recording_.vehicle, about(T_survey_start, 0.4, 0.4));
    T_survey_vehicle_.clear();
    fits_.clear();
    double cost = 0;
    for (std::size_t i = 0; i < recording_.cycles.size(); ++i) {
      const LandmarkCycle& cycle = recording_.cycles[i];
      if (cycle.stamp_s - recording_.cycles.front().stamp_s > duration_s) break;
      if (i > 0) filter.predict(cycle.odometry);
      for (std::size_t k = 0; k < cycle.sightings.size(); ++k) {
        const auto post = posts_.find(recording_.subjects[i][k]);
        if (post == posts_.end()) continue;
        const LandmarkSighting& sighting = cycle.sightings[k];
        const std::vector<SeenPoint> point{
            {.p_map = post->second, .p_vehicle = sighting.p_vehicle, .covariance = sighting.covariance}};
        const double off = filter.squared_distance(point, filter.pose());
        cost += std::min(off, kMisfit);
        Fit& fit = fits_[post->first];
        ++fit.sightings;
        if (off > kMisfit) ++fit.misfits;
        if (off <= kMisfit) filter.update(point, filter.pose());
      }
      T_survey_vehicle_.push_back({filter.pose(), filter.covariance()});
    }
    return cost;
  }

  /// The first post seen tells where the robot begins, but for the direction that it looks in.
  Pose2 best_start() {
    constexpr int kDirections = 24;
    const auto [first_post, seen_at] = first_sighting();
    Pose2 best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kDirections; ++i) {
      const double theta = 2 * kPi * i / kDirections;
      const Vec2 p = first_post - rotate(theta, seen_at);
      const double cost = run({p.x(), p.y(), theta}, kStart_s);
      if (cost >= least) continue;
      least = cost;
      best = {p.x(), p.y(), theta};
    }
    return best;
  }

  /// The surveyed position of the first post seen, and where it was seen from the start, by odometry.
  std::pair<Vec2, Vec2> first_sighting() const {
    Pose2 T_start_vehicle;
    for (std::size_t i = 0; i < recording_.cycles.size(); ++i) {
      if (i > 0)
        T_start_vehicle = T_start_vehicle * odometry_step(recording_.vehicle, recording_.cycles[i].odometry);
      for (std::size_t k = 0; k < recording_.subjects[i].size(); ++k) {
        const auto post = posts_.find(recording_.subjects[i][k]);
        if (post != posts_.end())
          return {post->second, T_start_vehicle * recording_.cycles[i].sightings[k].p_vehicle};
      }
    }
    throw std::runtime_error("no post was seen");
  }

  const Recording& recording_;
  std::map<int, Vec2> posts_;
  std::vector<UncertainPose2> T_survey_vehicle_;
  std::map<int, Fit> fits_;
  std::vector<int> misnumbered_;
};

/// A learned map upon the survey.
struct Alignment {
  Pose2 T_survey_map;
  std::vector<double> off_m;  ///< of the posts that were learned
  std::vector<double> path_off_m;
  std::size_t others = 0;  ///< landmarks that are no post, or a post again
};

/// The reference begins without knowing where.
bool is_settled(const UncertainPose2& T_survey_vehicle) {
  constexpr double kSettled_m = 0.1;
  return T_survey_vehicle.covariance.topLeftCorner<2, 2>().trace() < square(kSettled_m);
}

/// The rigid transform that lays the learned posts upon the surveyed ones, begun where the paths lie upon
/// each other.
Alignment align(const LandmarkMap& map, std::span<const Pose2> T_map_vehicle,
                std::span<const UncertainPose2> T_survey_vehicle, const std::map<int, Vec2>& posts) {
  constexpr double kSamePost_m = 0.5;  // posts are 0.7 m apart and more
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < T_map_vehicle.size(); ++i) {
    if (is_settled(T_survey_vehicle[i]))
      pairs.push_back({T_map_vehicle[i].position(), T_survey_vehicle[i].mean.position()});
  }
  Alignment alignment{.T_survey_map = fit_points(pairs), .off_m = {}, .path_off_m = {}};
  for (const PointPair& pair : pairs)
    alignment.path_off_m.push_back((alignment.T_survey_map * pair.from - pair.to).norm());
  for (int round = 0; round < 5; ++round) {
    pairs.clear();
    for (const auto& [subject, p_survey] : posts) {
      double nearest_m = kSamePost_m;
      std::optional<Vec2> nearest;
      for (const Landmark& landmark : map.all()) {
        const double off_m = (alignment.T_survey_map * landmark.p_map - p_survey).norm();
        if (landmark.weight == 0 || off_m >= nearest_m) continue;
        nearest_m = off_m;
        nearest = landmark.p_map;
      }
      if (nearest) pairs.push_back({*nearest, p_survey});
    }
    if (pairs.size() < 3) break;
    alignment.T_survey_map = fit_points(pairs);
  }
  for (const PointPair& pair : pairs)
    alignment.off_m.push_back((alignment.T_survey_map * pair.from - pair.to).norm());
  alignment.others = map.size() - pairs.size();
  return alignment;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += square(value);
  return std::sqrt(sum / std::max<double>(1, static_cast<double>(values.size())));
}

double worst(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

void print_map(const std::string& what, const Alignment& alignment, std::size_t posts) {
  fmt::print("| {} | {:.3f} | {} of {} | {:.3f} | {:.3f} | {} |\n", what, rms(alignment.path_off_m),
             alignment.off_m.size(), posts, rms(alignment.off_m), worst(alignment.off_m), alignment.others);
  std::fflush(stdout);
}

/// How a robot fared among known landmarks.
struct Localisation {
  std::vector<double> off_m, off_rad;  ///< while it was sure of its place
  int images = 0, matched = 0, sure_cycles = 0, cycles = 0;
  int lost = 0, found = 0, wrong = 0;  ///< times; wrong: sure of a place that is not its own
};

constexpr double kWrong_m = 0.5, kWrong_rad = 10 * kDegree;
constexpr double kLost_m = 0.35, kLost_rad = 6 * kDegree;  // more uncertain, it is lost: as LandmarkNavigator

Localisation localise(const LandmarkMap& map, const Recording& recording, std::size_t from,
                      const Pose2& T_survey_map, std::span<const UncertainPose2> T_survey_vehicle,
                      const UncertainPose2& T_map_start, const std::vector<Pose2>& places, bool begins_lost) {
  LandmarkLocaliser localiser({}, recording.vehicle, T_map_start);
  LandmarkRelocator relocator({}, {}, recording.vehicle, places);
  Localisation result;
  bool is_lost = begins_lost, is_wrong = false;
  relocator.start();
  for (std::size_t i = from; i < recording.cycles.size(); ++i) {
    const LandmarkCycle& cycle = recording.cycles[i];
    ++result.cycles;
    if (is_lost) {
      relocator.predict(cycle.odometry);
      if (cycle.sightings.empty()) continue;
      const auto T_map_found = relocator.look(map, cycle.sightings);
      if (!T_map_found) continue;
      localiser.place(about(*T_map_found, 0.1, 2 * kDegree));
      is_lost = false;
      ++result.found;
    } else {
      if (i > from) localiser.predict(cycle.odometry);
      if (!cycle.sightings.empty()) {
        ++result.images;
        if (localiser.correct(map, cycle.sightings) == LandmarkMatch::kMatched) ++result.matched;
      }
      const Mat3 covariance = localiser.covariance();
      if (std::sqrt(covariance.topLeftCorner<2, 2>().trace()) > kLost_m ||
          std::sqrt(covariance(2, 2)) > kLost_rad) {
        is_lost = true;
        is_wrong = false;
        ++result.lost;
        relocator.start();
        continue;
      }
    }
    if (!is_settled(T_survey_vehicle[i])) continue;
    const Pose2 off = between(T_survey_vehicle[i].mean, T_survey_map * localiser.pose());
    result.off_m.push_back(off.position().norm());
    result.off_rad.push_back(std::abs(off.theta));
    ++result.sure_cycles;
    const bool is_wrong_now = off.position().norm() > kWrong_m || std::abs(off.theta) > kWrong_rad;
    if (is_wrong_now && !is_wrong) ++result.wrong;
    is_wrong = is_wrong_now;
  }
  return result;
}

void print_localisation(const std::string& what, const Localisation& result) {
  fmt::print(
      "| {} | {:.3f} | {:.2f} | {:.3f} | {:.0f} | {:.0f} | {} | {} | {} |\n", what, rms(result.off_m),
      rms(result.off_rad) / kDegree, worst(result.off_m), 100.0 * result.matched / std::max(1, result.images),
      100.0 * result.sure_cycles / std::max(1, result.cycles), result.lost, result.found, result.wrong);
}

std::vector<Pose2> places_along(std::span<const Pose2> T_map_vehicle) {
  constexpr double kApart_m = 0.4, kApart_rad = 20 * kDegree;
  std::vector<Pose2> places;
  for (const Pose2& T : T_map_vehicle) {
    const bool is_new = std::none_of(places.begin(), places.end(), [&](const Pose2& place) {
      const Pose2 off = between(place, T);
      return off.position().norm() < kApart_m && std::abs(off.theta) < kApart_rad;
    });
    if (is_new) places.push_back(T);
  }
  return places;
}

void measure(const Recording& recording) {
  const Reference reference(recording);
  std::string misnumbered;
  for (const int subject : reference.misnumbered()) misnumbered += fmt::format(" {}", subject);
  fmt::print("{} cycles; posts whose numbers do not fit the survey:{}\n", recording.cycles.size(),
             misnumbered);
  const auto& truth = reference.poses();
  const LandmarkLearningParams params;
  const std::size_t posts = recording.p_survey_posts.size();
  const std::span<const LandmarkCycle> all = recording.cycles;

  fmt::print(
      "\n| learned | path, rms (m) | posts | rms (m) | worst (m) | others |\n|---|---|---|---|---|---|\n");
  const std::size_t third = all.size() / 3;
  const LearnedRun taught = learn_landmarks(all.first(third), recording.vehicle, params);
  const Alignment on_taught = align(taught.map, taught.T_map_vehicle, truth, recording.p_survey_posts);
  print_map("first third", on_taught, posts);

  LandmarkMap map = taught.map;
  UncertainPose2 T_map_vehicle = about(taught.T_map_vehicle.back(), 0.15, 3 * kDegree);
  for (const std::size_t from : {third, 2 * third}) {
    const RefinedLandmarks refined =
        refine_landmarks(map, all.subspan(from, third), recording.vehicle, T_map_vehicle, params);
    map = refined.map;
    T_map_vehicle = about(refined.T_map_vehicle.back(), 0.15, 3 * kDegree);
    print_map(
        from == third ? "refined by the second" : "refined by the last",
        align(map, refined.T_map_vehicle, std::span(truth).subspan(from, third), recording.p_survey_posts),
        posts);
  }

  const LearnedRun whole = learn_landmarks(all, recording.vehicle, params);
  const Alignment on_whole = align(whole.map, whole.T_map_vehicle, truth, recording.p_survey_posts);
  print_map("whole run", on_whole, posts);

  fmt::print(
      "\n| localised | rms (m) | rms (deg) | worst (m) | images matched (%) | sure (%) | lost | found | "
      "wrong "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  print_localisation("whole run in its own map",
                     localise(whole.map, recording, 0, on_whole.T_survey_map, truth,
                              about(whole.T_map_vehicle.front(), 0.15, 3 * kDegree),
                              places_along(whole.T_map_vehicle), false));
  print_localisation("rest in the first third's map",
                     localise(taught.map, recording, third, on_taught.T_survey_map, truth,
                              about(taught.T_map_vehicle.back(), 0.15, 3 * kDegree),
                              places_along(taught.T_map_vehicle), false));
  print_localisation("the same, begun anywhere",
                     localise(taught.map, recording, third, on_taught.T_survey_map, truth, {},
                              places_along(taught.T_map_vehicle), true));
}

}  // namespace

int main(int argc, char** argv) {
  const char* data = std::getenv("AISLE_DATA");
  const fs::path folder = argc > 1 ? fs::path(argv[1])
                                   : fs::path(data != nullptr ? data : AISLE_SOURCE_DIR "/../shared/data") /
                                         "recordings/mrclam-camera";
  if (!fs::exists(folder)) {
    fmt::print("SKIPPED: {} is not here; AISLE_DATA may point to the data\n", folder.string());
    return 0;
  }
  try {
    measure(read_recording(folder, argc > 2 ? std::atoi(argv[2]) : 1, argc > 3 ? std::atof(argv[3]) : 0));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
