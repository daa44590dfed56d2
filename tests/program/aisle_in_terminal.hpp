#pragma once

#include <sys/types.h>
#include <termios.h>

#include <string>
#include <string_view>

#include "run_aisle.hpp"

namespace aisle {

/// The program in its own terminal, as if a person sat at the keys. The destructor ends it.
class AisleInTerminal {
 public:
  explicit AisleInTerminal(const Arguments& arguments);
  AisleInTerminal(const AisleInTerminal&) = delete;
  AisleInTerminal& operator=(const AisleInTerminal&) = delete;
  ~AisleInTerminal();

  /// Types these keys.
  void type(std::string_view keys) const;

  /// Waits for what the program prints next.
  /// @return empty if it has ended
  std::string next_words() const;

  /// Waits for the program's end.
  /// @return its exit code, or -1 if it was killed by a signal
  int wait();

  termios settings() const;

 private:
  int keyboard_ = -1;  ///< the person's side of the terminal
  int screen_ = -1;    ///< the other side, kept open so that it outlives the program
  pid_t process_ = 0;
};

}  // namespace aisle
