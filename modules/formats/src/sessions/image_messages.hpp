#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "aisle/formats/images/image_coding.hpp"
#include "aisle/vehicle/camera_description.hpp"
#include "aisle/vehicle/observation.hpp"
#include "sessions/session_topics.hpp"

namespace aisle {

/// The frame of a camera's images: camera_optical of docs/reference/frames.md.
std::string camera_frame(const std::string& camera);

/// @throws std::invalid_argument if the image is empty
RecordedMessage image_message(const CameraImage& image, const ImageCoding& coding);

/// @param bytes  of a JPEG or PNG file; they are not changed
RecordedMessage image_file_message(const std::string& camera, double stamp_s, std::string_view bytes);

/// The calibration for viewers, with the image's stamp.
RecordedMessage camera_info_message(const CameraDescription& camera, double stamp_s);

/// The camera whose images the topic contains; nullopt for other topics.
std::optional<std::string> camera_of(const std::string& topic);

Result<CameraImage> camera_image_of(const RecordedMessage& message, const std::string& camera,
                                    const std::string& file);

}  // namespace aisle
