#include "aisle/formats/bags/bag_image.hpp"

#include <utility>

#include "aisle/formats/images/image_file.hpp"
#include "sessions/ros_image.hpp"

namespace aisle {

Result<BagImage> bag_image(std::string_view bytes, const std::string& type, BagEncoding encoding,
                           const Place& place) {
  if (type == ros::Image::kType) {
    const auto message = parse_message<ros::Image>(bytes, encoding);
    if (!message) return Problem{place, "is cut off"};
    auto pixels = image_of(*message, place);
    if (!pixels) return pixels.problems();
    return BagImage{std::move(*pixels), {}};
  }
  const auto message = parse_message<ros::CompressedImage>(bytes, encoding);
  if (!message) return Problem{place, "is cut off"};
  std::string file(message->data.begin(), message->data.end());
  auto pixels = parse_image(file, to_string(Problem{place, "an image"}));
  if (!pixels) return pixels.problems();
  return BagImage{std::move(*pixels), std::move(file)};
}

}  // namespace aisle
