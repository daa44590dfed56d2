#include "aisle/guidance/exploration/learning_progress.hpp"

#include <algorithm>

namespace aisle {
namespace {

constexpr double kLearned_m2 = 0.5;
constexpr double kIdlePath_m = 150;
constexpr double kIdleShare = 0.5;

}  // namespace

bool LearningProgress::takes_in(double free_m2, double path_m) {
  if (!(free_m2 > learned_m2_ + kLearned_m2)) return false;
  learned_m2_ = free_m2;
  learned_path_m_ = path_m;
  return true;
}

bool LearningProgress::is_idle(double path_m) const {
  return path_m - learned_path_m_ > std::max(kIdlePath_m, kIdleShare * learned_path_m_);
}

}  // namespace aisle
