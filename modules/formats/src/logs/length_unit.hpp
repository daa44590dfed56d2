#pragma once

#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

constexpr double metres_per(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMetre:
      return 1;
    case LengthUnit::kCentimetre:
      return 0.01;
    case LengthUnit::kMillimetre:
      return 0.001;
  }
  return 1;
}

}  // namespace aisle
