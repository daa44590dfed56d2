#include <turbojpeg.h>

#include <memory>

#include "images/image_codecs.hpp"

namespace aisle {
namespace {

using Handle = std::unique_ptr<void, int (*)(tjhandle)>;

const std::uint8_t* as_bytes(std::string_view bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

}  // namespace

std::optional<TransparentImage> decode_jpeg(std::string_view bytes) {
  const Handle handle(tjInitDecompress(), tjDestroy);
  int width = 0, height = 0, subsampling = 0, colours = 0;
  if (handle == nullptr || tjDecompressHeader3(handle.get(), as_bytes(bytes), bytes.size(), &width, &height,
                                               &subsampling, &colours) != 0)
    return std::nullopt;
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) return decode_by_pixbuf(bytes);
  const bool is_grey = colours == TJCS_GRAY;
  Image image(width, height, is_grey ? 1 : 3);
  const int failed = tjDecompress2(handle.get(), as_bytes(bytes), bytes.size(), image.bytes.data(), width, 0,
                                   height, is_grey ? TJPF_GRAY : TJPF_RGB, TJFLAG_ACCURATEDCT);
  // Cameras leave bytes behind that the library warns of; the image is whole.
  if (failed != 0 && tjGetErrorCode(handle.get()) != TJERR_WARNING) return std::nullopt;
  return TransparentImage{std::move(image), {}};
}

std::string encode_jpeg(const Image& image, int quality) {
  const Handle handle(tjInitCompress(), tjDestroy);
  const bool is_grey = image.channels == 1;
  const int subsampling = is_grey ? TJSAMP_GRAY : TJSAMP_420;
  // Room for the worst image, which none is: clearing all of it takes as long as compressing.
  unsigned long size = tjBufSize(image.width_px, image.height_px, subsampling);
  const auto room = std::make_unique_for_overwrite<std::uint8_t[]>(size);
  std::uint8_t* begin = room.get();
  const int failed = tjCompress2(handle.get(), image.bytes.data(), image.width_px, 0, image.height_px,
                                 is_grey ? TJPF_GRAY : TJPF_RGB, &begin, &size, subsampling, quality,
                                 TJFLAG_ACCURATEDCT | TJFLAG_NOREALLOC);
  return {room.get(), room.get() + (failed == 0 ? size : 0)};
}

}  // namespace aisle
