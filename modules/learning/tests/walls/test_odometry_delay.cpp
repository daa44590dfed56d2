#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/learning/walls/odometry_delay.hpp"

namespace aisle {
namespace {

constexpr double kPeriod_s = 0.2;
constexpr int kScans = 600;

/// A vehicle that keeps turning this way and that, at up to 40 degrees per second.
double heading_rad(double time_s) {
  return 0.9 * std::sin(0.7 * time_s) + 0.2 * std::sin(1.9 * time_s);
}

/// The log of such a run, read scan by scan.
struct DelayedRun {
  double delay_s = 0;
  double wheel_sigma_rad = 0;  ///< of each step
  double sight_sigma_rad = 0;  ///< of each scan's frame
  bool sees_walls = true;
  int scans = kScans;

  double estimated_delay_s() const {
    Random random(1);
    std::vector<OdometrySample> samples;
    double slipped_rad = 0;
    for (int i = 0; i < scans; ++i) {
      slipped_rad += random.normal(wheel_sigma_rad);
      samples.push_back({i * kPeriod_s, {0, 0, heading_rad(i * kPeriod_s + delay_s) + slipped_rad}});
    }
    const OdometryTrack odometry(samples);
    OdometryDelayEstimator estimator(odometry, kPeriod_s);
    for (int i = 0; i < scans; ++i) {
      const double seen_rad = wrap_quarter_turn(-heading_rad(i * kPeriod_s) + random.normal(sight_sigma_rad));
      estimator.add(i * kPeriod_s, static_cast<std::size_t>(i) + 1,
                    sees_walls ? std::optional(seen_rad) : std::nullopt);
    }
    return estimator.delay_s();
  }
};

TEST(OdometryDelay, IsFoundToATenthOfThePeriodLaterOrEarlier) {
  for (int tenths = -10; tenths <= 30; ++tenths) {
    const double delay_s = tenths * 0.1 * kPeriod_s;
    EXPECT_NEAR((DelayedRun{.delay_s = delay_s}.estimated_delay_s()), delay_s, 0.101 * kPeriod_s);
  }
}

TEST(OdometryDelay, IsFoundInSpiteOfNoise) {
  for (const double delay_s : {-0.16, -0.08, 0.13, 0.3, 0.5}) {
    const DelayedRun run{
        .delay_s = delay_s, .wheel_sigma_rad = 0.3 * kDegree, .sight_sigma_rad = 0.3 * kDegree};
    EXPECT_NEAR(run.estimated_delay_s(), delay_s, 0.101 * kPeriod_s);
  }
}

TEST(OdometryDelay, NoiseOfTheWheelsIsNoDelay) {
  for (const double sigma_rad : {0.1 * kDegree, 0.2 * kDegree, 0.4 * kDegree}) {
    EXPECT_EQ((DelayedRun{.wheel_sigma_rad = sigma_rad}.estimated_delay_s()), 0);
  }
}

TEST(OdometryDelay, IsNoneUntilEnoughTurningWasSeen) {
  EXPECT_EQ((DelayedRun{.delay_s = 0.2, .scans = 15}.estimated_delay_s()), 0);
  EXPECT_EQ((DelayedRun{.delay_s = 0.2, .sees_walls = false}.estimated_delay_s()), 0);
}

}  // namespace
}  // namespace aisle
