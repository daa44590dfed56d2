#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// The simulator ended, or replied against the protocol.
struct MmsFailure {
  std::string what;
};

/// A move that ended at a wall.
struct MmsCrash {};

/// A mouse in the mms simulator (https://github.com/mackorone/mms), with one line per command and one per
/// reply. It starts in cell (0, 0) facing the top. Every function may throw MmsFailure.
class MmsMouse {
 public:
  MmsMouse(std::istream& replies, std::ostream& commands) : replies_(replies), commands_(commands) {}

  /// @param dimension  "mazeWidth" or "mazeHeight"
  int size(const std::string& dimension);

  Cell at() const { return at_; }
  /// Open sides of the current cell.
  Sides sense();
  /// Turns to a side and moves ahead by a number of cells. Throws MmsCrash if a wall is in the path.
  void move(Side side, int cells = 1);

  /// Whether the reset button was pressed; if so, the mouse is back in (0, 0), facing the top.
  bool take_reset();

  /// Shows the walls of the current cell and a colour on it in the simulator.
  void show(Sides open, char color);

 private:
  void say(const std::string& command) const;
  std::string ask(const std::string& command);
  bool ask_yes_no(const std::string& command);
  void act(const std::string& command);
  void turn_to(Side side);

  std::istream& replies_;
  std::ostream& commands_;
  Cell at_;
  Side heading_ = Side::kTop;
};

}  // namespace aisle
