#pragma once

#include <string>

#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

enum class NavigatorStatus {
  kGoing,
  kDone,    ///< where it wanted to be; the command is to stop
  kFailed,  ///< gave up; the command is to stop, `why` says what happened
};

/// What a navigator makes of one observation.
struct Decision {
  Command command;
  NavigatorStatus status = NavigatorStatus::kGoing;
  std::string state;  ///< one word of the method's own: "following", "lost"
  std::string why;    ///< one line for people; may be empty

  friend bool operator==(const Decision&, const Decision&) = default;
};

/// A method of driving. Knows time only from the observations' stamps: the same observations give the same
/// decisions, bit for bit.
class Navigator {
 public:
  virtual ~Navigator() = default;
  virtual Decision step(const Observation& observation) = 0;
};

}  // namespace aisle
