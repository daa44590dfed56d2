#pragma once

#include <cstddef>
#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The problems of one file. Keeps the first 20 and counts the rest: a file of the wrong kind has one per
/// line.
class ProblemList {
 public:
  explicit ProblemList(std::string file) : file_(std::move(file)) {}

  void add(long line, std::string what) { add(line, "", std::move(what)); }
  void add(long line, std::string key, std::string what);
  /// Adds a problem that already has its place.
  void add(Problem problem);

  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  /// The first 20 and, if there were more, a last one with the number of the rest.
  Problems take();

 private:
  std::string file_;
  Problems first_;
  std::size_t count_ = 0;
};

}  // namespace aisle
