#include "problem_list.hpp"

#include <fmt/format.h>

#include <utility>

namespace aisle {
namespace {

constexpr std::size_t kShown = 20;

}  // namespace

void ProblemList::add(long line, std::string key, std::string what) {
  add(Problem{Place{file_, line, std::move(key)}, std::move(what)});
}

void ProblemList::add(Problem problem) {
  ++count_;
  if (first_.size() < kShown) first_.push_back(std::move(problem));
}

Problems ProblemList::take() {
  if (count_ > kShown) {
    const std::string what = fmt::format("... and {} more", count_ - kShown);
    first_.push_back(Problem{Place{file_, 0, ""}, what});
  }
  count_ = 0;
  return std::exchange(first_, {});
}

}  // namespace aisle
