#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "aisle/simulation/scenario_play.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// Delivers one camera's images to the vehicle, with the faults that may happen on the way.
class CameraFeed {
 public:
  /// An image was taken. Dark images are the camera's business: `trouble.dark` is ignored.
  void take(CameraImage image, const CameraTrouble& trouble);

  /// The newest image that has arrived since the last call, if any; older ones are lost.
  std::optional<CameraImage> deliver(double now_s);

 private:
  struct Underway {
    double due_s = 0;
    CameraImage image;
  };

  std::deque<Underway> underway_;  ///< none overtakes another
  std::shared_ptr<const Image> last_good_;
};

}  // namespace aisle
