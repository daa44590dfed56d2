#pragma once

#include <fmt/format.h>

#include <string>

#include "aisle/core/problem.hpp"
#include "logs/occurrences.hpp"

namespace aisle {

/// Lines of a log that cannot be read: how many, and where and why first.
class LeftOutLines {
 public:
  void add(long line, const std::string& why) {
    if (lines_.count == 0) first_failure_ = why;
    lines_.add(line);
  }
  void warn(const std::string& name, Problems& warnings) const {
    if (lines_.count == 0) return;
    warnings.push_back(
        {{name, lines_.first_line},
         fmt::format("{}; lines that cannot be read are left out: {}", first_failure_, lines_.count)});
  }

 private:
  Occurrences lines_;
  std::string first_failure_;
};

}  // namespace aisle
