#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "command_intake.hpp"
#include "offscreen_view.hpp"
#include "options.hpp"
#include "record.hpp"
#include "telemetry.hpp"
#include "world.hpp"

namespace robots {

/// A vehicle in a world, with its sensors, its driver and its topics.
class Robot {
 public:
  static constexpr double kCycle_s = 0.01;
  static constexpr ImageSize kPictureSize{1200, 900};

  Robot(const Options& options, const World& world, const Vehicle& vehicle);

  /// Tells where its sensors sit, for everybody who listens now or later.
  void introduce(const Time& now) const;
  /// Obeys the newest command for one cycle of physics, then publishes what is due.
  /// @param begin, end what time it is then, for stamps
  void cycle(const Time& begin, const Time& end);

  double time_s() const { return physics_.time_s(); }
  /// Red, green and blue by rows, of kPictureSize. Only if the options ask for a picture.
  std::vector<std::uint8_t> seen_from_above();
  nlohmann::json report() const;

 private:
  /// What comes again and again in simulated time.
  struct Beat {
    double period_s;
    double next_s = 0;

    bool is_due(double time_s);
  };

  void publish(const Time& stamp);

  Options options_;
  Physics physics_;
  Calibration calibration_;
  Driver driver_;
  WheelOdometry odometry_;
  RangeScanner scanner_;
  std::optional<OffscreenView> view_;
  Record record_;
  Participant participant_;
  CommandIntake commands_;
  Telemetry telemetry_;
  Beat odometry_beat_{0.02}, scan_beat_, image_beat_{0.1};
};

}  // namespace robots
