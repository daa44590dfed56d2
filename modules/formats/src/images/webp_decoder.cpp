#include <webp/decode.h>

#include "images/alpha_channel.hpp"
#include "images/image_codecs.hpp"

namespace aisle {

std::optional<TransparentImage> decode_webp(std::string_view bytes) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(begin, bytes.size(), &features) != VP8_STATUS_OK || features.has_animation != 0)
    return std::nullopt;
  Image pixels(features.width, features.height, features.has_alpha != 0 ? 4 : 3);
  const auto into = features.has_alpha != 0 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
  if (into(begin, bytes.size(), pixels.bytes.data(), pixels.bytes.size(),
           static_cast<int>(pixels.row_bytes())) == nullptr)
    return std::nullopt;
  if (features.has_alpha == 0) return TransparentImage{std::move(pixels), {}};
  return apart_from_alpha(pixels.bytes, features.width, features.height, pixels.channels);
}

}  // namespace aisle
