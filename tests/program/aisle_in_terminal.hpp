#pragma once

#include <sys/types.h>
#include <termios.h>

#include <string>
#include <string_view>

#include "run_aisle.hpp"

namespace aisle {

/// The program in a terminal of its own, as where a person sits at the keys. The destructor ends it.
class AisleInTerminal {
 public:
  explicit AisleInTerminal(const Arguments& arguments);
  AisleInTerminal(const AisleInTerminal&) = delete;
  AisleInTerminal& operator=(const AisleInTerminal&) = delete;
  ~AisleInTerminal();

  /// What a person types.
  void type(std::string_view keys) const;

  /// Waits for what the program prints next.
  /// @return empty: it has ended
  std::string next_words() const;

  /// Waits for the program's end.
  /// @return its exit code; -1: killed by a signal
  int wait();

  termios settings() const;

 private:
  int keyboard_ = -1;  ///< the side of the terminal where the person is
  int screen_ = -1;    ///< its other side, kept open so that it outlives the program
  pid_t process_ = 0;
};

}  // namespace aisle
