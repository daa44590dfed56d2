#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "aisle/core/problem.hpp"

namespace aisle {

/// A value read from the outside world, or every problem that kept it from being read.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : outcome_(std::move(value)) {}                      // NOLINT(google-explicit-constructor)
  Result(Problem problem) : outcome_(Problems{std::move(problem)}) {}  // NOLINT(google-explicit-constructor)
  Result(Problems problems) : outcome_(std::move(problems)) {          // NOLINT(google-explicit-constructor)
    assert(!std::get<Problems>(outcome_).empty());
  }

  bool ok() const { return std::holds_alternative<T>(outcome_); }
  explicit operator bool() const { return ok(); }

  T& value() & { return std::get<T>(outcome_); }
  const T& value() const& { return std::get<T>(outcome_); }
  T&& value() && { return std::get<T>(std::move(outcome_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Problems& problems() const { return std::get<Problems>(outcome_); }

 private:
  std::variant<T, Problems> outcome_;
};

}  // namespace aisle
