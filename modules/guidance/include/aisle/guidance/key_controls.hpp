#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// A key for manual driving: those of L03 Table 1, and those that set marks.
struct Key {
  enum class Kind {
    kUp,     ///< forwards
    kDown,   ///< backwards
    kLeft,   ///< to the left, at the present speed
    kRight,  ///< to the right
    kStop,
    kQuit,  ///< end the drive
    kMark,  ///< see `mark`
  };
  Kind kind = Kind::kStop;
  Mark mark;

  friend bool operator==(const Key&, const Key&) = default;
};

struct KeySpeeds {
  double speed_mps = 0.3;
  double reverse_speed_mps = 0.2;
  double steering_rad = 25 * kDegree;
  double turn_rate_rad_s = 30 * kDegree;

  void describe(FieldList& fields);
};

/// Turns the keys pressed in each cycle into operator input. A key counts as held while it repeats. Left and
/// right keep the speed of an up or down key pressed at most half a second earlier; otherwise they turn the
/// vehicle, or its wheels, on the spot.
class KeyControls {
 public:
  KeyControls(const KeySpeeds& speeds, bool is_differential);

  OperatorInput press(double stamp_s, const std::vector<Key>& keys);

 private:
  Command turning(double stamp_s, double side);

  KeySpeeds speeds_;
  bool is_differential_;
  double speed_mps_ = 0;  ///< of the last up or down key
  double moved_stamp_s_ = -1e9;
};

/// Decodes the keys that a terminal sends: arrows; q: stop; space: quit; d, 1 to 13 and Enter: a turning
/// begins; e: it ends; p, a name and Enter: a place; x: the path ends here. Esc cancels what is being typed.
class TerminalKeys {
 public:
  /// @param bytes  all that arrived since the last call; an escape sequence may be split between calls
  std::vector<Key> read(std::string_view bytes);

  /// What is being typed, for the status line: "place: lob"; empty if nothing is.
  std::string typing() const;

 private:
  void read_plain(char byte, std::vector<Key>& keys);
  void read_typed(char byte, std::vector<Key>& keys);

  enum class Typing { kNothing, kTurning, kPlace };

  std::string escape_;  ///< an unfinished escape sequence
  Typing typing_ = Typing::kNothing;
  std::string typed_;
  std::string turning_;  ///< class of the turning that was begun last; empty: none is open
};

}  // namespace aisle
