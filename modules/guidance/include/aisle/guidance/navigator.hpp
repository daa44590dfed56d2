#pragma once

#include <string>

#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

enum class NavigatorStatus {
  kGoing,
  kDone,    ///< reached its goal; the command is to stop
  kFailed,  ///< gave up; the command is to stop, `why` gives the reason
};

/// A navigator's answer to one observation.
struct Decision {
  Command command;
  NavigatorStatus status = NavigatorStatus::kGoing;
  std::string state;  ///< a word that the method defines: "following", "lost"
  std::string why;    ///< one line for the user; may be empty

  friend bool operator==(const Decision&, const Decision&) = default;
};

/// A driving method. Its only clock is the observations' stamps, so the same observations give the same
/// decisions, bit for bit.
class Navigator {
 public:
  virtual ~Navigator() = default;
  virtual Decision step(const Observation& observation) = 0;
};

}  // namespace aisle
