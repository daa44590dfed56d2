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

/// Manual driving: passes on the operator's requests, within limits, and stops when none arrive (dead man's
/// switch). A pressed bumper ends the drive as failed; the operator may end it as done, or give up (failed).
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
