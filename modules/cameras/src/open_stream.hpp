#pragma once

#include <memory>

#include "aisle/core/result.hpp"
#include "aisle/vehicle/camera_source.hpp"
#include "image_stream.hpp"

namespace aisle {

/// @return problems that make no sense to wait for, see LiveCamera::open
Result<std::unique_ptr<ImageStream>> open_stream(const CameraSource& source);

}  // namespace aisle
