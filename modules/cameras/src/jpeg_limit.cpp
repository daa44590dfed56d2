#include "jpeg_limit.hpp"

#include <algorithm>
#include <cstddef>

#include "gst_pointers.hpp"

namespace aisle {
namespace {

constexpr unsigned kFill = 0xff, kStuffed = 0x00, kTemporary = 0x01, kRestart = 0xd0, kEndOfImage = 0xd9,
                   kStartOfScan = 0xda;

bool is_frame(unsigned marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

bool has_length(unsigned marker) {
  return marker != kStuffed && marker != kTemporary && (marker < kRestart || marker > kEndOfImage);
}

/// Reads big-endian numbers; 0 behind the end.
class JpegBytes {
 public:
  explicit JpegBytes(std::string_view bytes) : bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }
  unsigned byte() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }
  int word() {
    const unsigned high = byte();
    return static_cast<int>(high << 8 | byte());
  }
  void skip(int count) { bytes_.remove_prefix(std::min(bytes_.size(), static_cast<std::size_t>(count))); }

  /// The next marker, whatever lies before it.
  unsigned marker() {
    while (!at_end() && byte() != kFill) continue;
    unsigned marker = kFill;
    while (!at_end() && marker == kFill) marker = byte();
    return marker;
  }

 private:
  std::string_view bytes_;
};

GstPadProbeReturn check_size(GstPad* pad, GstPadProbeInfo* info, gpointer side_max_px) {
  GstBuffer* buffer = GST_PAD_PROBE_INFO_BUFFER(info);
  GstMapInfo map;
  if (!gst_buffer_map(buffer, &map, GST_MAP_READ)) return GST_PAD_PROBE_DROP;
  const auto size = jpeg_size({reinterpret_cast<const char*>(map.data), map.size});
  gst_buffer_unmap(buffer, &map);
  if (!size || std::max(size->width_px, size->height_px) <= GPOINTER_TO_INT(side_max_px))
    return GST_PAD_PROBE_OK;
  const GstOwned<GstElement> decoder(gst_pad_get_parent_element(pad));
  GST_ELEMENT_ERROR(decoder.get(), STREAM, DECODE,
                    ("an image of %d x %d pixels is too large", size->width_px, size->height_px), (nullptr));
  return GST_PAD_PROBE_DROP;
}

void limit_decoder(GstElement* element, gpointer side_max_px) {
  const GstElementFactory* factory = gst_element_get_factory(element);
  if (!factory || std::string_view(GST_OBJECT_NAME(factory)) != "jpegdec") return;
  const GstOwned<GstPad> pad(gst_element_get_static_pad(element, "sink"));
  gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_BUFFER, check_size, side_max_px, nullptr);
}

}  // namespace

std::optional<JpegSize> jpeg_size(std::string_view bytes) {
  for (JpegBytes jpeg(bytes); !jpeg.at_end();) {
    const unsigned marker = jpeg.marker();
    if (marker == kStartOfScan || marker == kEndOfImage) return std::nullopt;
    if (!has_length(marker)) continue;
    const int length = jpeg.word();
    if (!is_frame(marker)) {
      jpeg.skip(std::max(0, length - 2));
      continue;
    }
    jpeg.byte();  // bits of a sample
    const int height_px = jpeg.word();
    return JpegSize{.width_px = jpeg.word(), .height_px = height_px};
  }
  return std::nullopt;
}

void limit_jpeg_size(GstBin* pipeline, int side_max_px) {
  const gpointer limit = GINT_TO_POINTER(side_max_px);
  const auto added =
      +[](GstBin*, GstBin*, GstElement* element, gpointer side) { limit_decoder(element, side); };
  g_signal_connect(pipeline, "deep-element-added", G_CALLBACK(added), limit);
  GstIterator* elements = gst_bin_iterate_recurse(pipeline);
  const auto present = +[](const GValue* value, gpointer side) {
    limit_decoder(GST_ELEMENT(g_value_get_object(value)), side);
  };
  while (gst_iterator_foreach(elements, present, limit) == GST_ITERATOR_RESYNC) gst_iterator_resync(elements);
  gst_iterator_free(elements);
}

}  // namespace aisle
