#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "aisle/simulation/scenario_play.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// The way of one camera's pictures to the vehicle, and what may happen to them there.
class CameraFeed {
 public:
  /// A picture was taken. Dark pictures are the camera's business: `trouble.dark` is not looked at.
  void take(CameraPicture picture, const CameraTrouble& trouble);

  /// The newest picture that has arrived since the last call, if any; older ones are lost.
  std::optional<CameraPicture> deliver(double now_s);

 private:
  struct Underway {
    double due_s = 0;
    CameraPicture picture;
  };

  std::deque<Underway> underway_;  ///< none overtakes another
  std::shared_ptr<const Image> last_good_;
};

}  // namespace aisle
