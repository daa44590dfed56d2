#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// Driving by keys: those of L03 Table 1, and those that set marks.
struct Key {
  enum class Kind {
    kUp,     ///< forwards
    kDown,   ///< backwards
    kLeft,   ///< to the left, as fast as it goes
    kRight,  ///< to the right
    kStop,   ///< stand
    kQuit,   ///< the drive ends
    kMark,   ///< see `mark`
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

/// What the keys of one cycle after another mean. A key is held as long as it keeps coming; left and right
/// keep the speed of an up or down that came at most half a second before them, or turn where the vehicle
/// stands.
class KeyControls {
 public:
  KeyControls(const KeySpeeds& speeds, bool is_differential);

  OperatorInput press(double stamp_s, const std::vector<Key>& keys);

 private:
  Command turning(double stamp_s, double side);

  KeySpeeds speeds_;
  bool is_differential_;
  double speed_mps_ = 0;  ///< of the latest up or down
  double moved_stamp_s_ = -1e9;
};

/// The keys in what a terminal sends: arrows, q, space; d 1 to 13 and Enter: a turning begins; e: it ends; p,
/// a name and Enter: a place; x: the path ends here. Esc takes back what was begun.
class TerminalKeys {
 public:
  /// @param bytes  whatever arrived since the last call; sequences may be cut anywhere
  std::vector<Key> read(std::string_view bytes);

  /// What is being typed, for the status line: "place: lob"; empty: nothing.
  std::string typing() const;

 private:
  void read_plain(char byte, std::vector<Key>& keys);
  void read_typed(char byte, std::vector<Key>& keys);

  enum class Typing { kNothing, kTurning, kPlace };

  std::string escape_;  ///< an unfinished escape sequence
  Typing typing_ = Typing::kNothing;
  std::string typed_;
  std::string turning_;  ///< the latest that has begun
};

}  // namespace aisle
