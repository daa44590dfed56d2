#pragma once

namespace aisle {

/// Notes when floor was learned last. A vehicle that drives far without learning any explores nothing more.
class LearningProgress {
 public:
  /// @param free_m2  free floor known by now
  /// @param path_m   distance travelled
  /// @return whether that is enough more than when floor was learned last: now is the last time
  bool takes_in(double free_m2, double path_m);

  /// Whether the vehicle has driven too far since floor was learned last: 150 m, or half as far as it had
  /// driven until then.
  bool is_idle(double path_m) const;

 private:
  double learned_m2_ = 0;
  double learned_path_m_ = 0;
};

}  // namespace aisle
