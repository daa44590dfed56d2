#pragma once

#include "aisle/core/result.hpp"
#include "aisle/vehicle/camera_source.hpp"
#include "gst_pointers.hpp"

namespace aisle {

/// A pipeline that is ready to be started, and the element at its end that gives the images.
struct CameraPipeline {
  GstOwned<GstElement> pipeline;
  GstOwned<GstElement> sink;    ///< an appsink: keeps the newest image alone
  GstOwned<GstElement> source;  ///< the element that reads; null: of the user's own pipeline
};

/// @param source  not a folder
Result<CameraPipeline> camera_pipeline(const CameraSource& source);

}  // namespace aisle
