#pragma once

#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/guidance/navigator.hpp"

namespace aisle {

struct HandDriverParams {
  double speed_max_mps = 0.4;
  double reverse_speed_max_mps = 0.2;
  double steering_max_rad = 35 * kDegree;
  double turn_rate_max_rad_s = 45 * kDegree;
  double request_age_max_s = 0.5;

  void describe(FieldList& fields);
};

/// Drives as the person at the controls requests, within limits, and stops when requests stay away (dead
/// man). A pressed bumper ends the drive, and so does the person; who gives up has failed.
class HandDriver final : public Navigator {
 public:
  explicit HandDriver(const HandDriverParams& params) : params_(params) {}

  Decision step(const Observation& observation) override;

 private:
  Command limited(const Command& requested) const;

  HandDriverParams params_;
  Command requested_;
  std::optional<double> request_stamp_s_;
};

}  // namespace aisle
