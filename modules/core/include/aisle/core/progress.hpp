#pragma once

#include <cstddef>
#include <string_view>

namespace aisle {

/// Thrown out of Progress::report when the user has asked the program to stop.
struct Interrupted {};

/// Where long work says how far it is. Work reports often; the receiver decides what is worth showing.
class Progress {
 public:
  virtual ~Progress() = default;

  /// `done` of `total` steps of `task` are finished. May throw Interrupted.
  virtual void report(std::string_view task, std::size_t done, std::size_t total) = 0;

  /// Whether the user wants a mission to end where it is, and to keep what it has. Only missions ask.
  virtual bool shall_end() const { return false; }
};

/// Shows nothing and never interrupts.
class SilentProgress final : public Progress {
 public:
  void report(std::string_view, std::size_t, std::size_t) override {}
};

}  // namespace aisle
