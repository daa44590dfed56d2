#include <gdk-pixbuf/gdk-pixbuf.h>

#include <algorithm>
#include <memory>
#include <set>

#include "images/alpha_channel.hpp"
#include "images/image_codecs.hpp"

namespace aisle {
namespace {

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
using Loader = std::unique_ptr<GdkPixbufLoader, Unref>;

void see_rows(GdkPixbufLoader* /*loader*/, int /*x*/, int y, int /*width*/, int height, gpointer rows) {
  for (int v = y; v < y + height; ++v) static_cast<std::set<int>*>(rows)->insert(v);
}

/// A BMP or PPM that is cut off is loaded without a word: only the rows that were seen tell.
bool is_loaded(GdkPixbufLoader* loader, std::string_view bytes) {
  std::set<int> rows;
  g_signal_connect(loader, "area-updated", G_CALLBACK(see_rows), &rows);
  const bool is_written = gdk_pixbuf_loader_write(loader, reinterpret_cast<const guchar*>(bytes.data()),
                                                  bytes.size(), nullptr) != FALSE;
  if (gdk_pixbuf_loader_close(loader, nullptr) == FALSE || !is_written) return false;
  const GdkPixbuf* pixbuf = gdk_pixbuf_loader_get_pixbuf(loader);
  return pixbuf != nullptr && rows.size() == static_cast<std::size_t>(gdk_pixbuf_get_height(pixbuf));
}

Image rows_of(const GdkPixbuf* pixbuf) {
  Image pixels(gdk_pixbuf_get_width(pixbuf), gdk_pixbuf_get_height(pixbuf),
               gdk_pixbuf_get_n_channels(pixbuf));
  const guint8* from = gdk_pixbuf_read_pixels(pixbuf);
  for (int v = 0; v < pixels.height_px; ++v)
    std::copy_n(from + static_cast<std::ptrdiff_t>(v) * gdk_pixbuf_get_rowstride(pixbuf), pixels.row_bytes(),
                pixels.row(v));
  return pixels;
}

bool has_no_colour(const Image& rgb) {
  for (std::size_t i = 0; i < rgb.bytes.size(); i += 3) {
    if (rgb.bytes[i] != rgb.bytes[i + 1] || rgb.bytes[i] != rgb.bytes[i + 2]) return false;
  }
  return true;
}

Image grey_of(const Image& rgb) {
  Image grey(rgb.width_px, rgb.height_px);
  for (std::size_t i = 0; i < grey.bytes.size(); ++i) grey.bytes[i] = rgb.bytes[3 * i];
  return grey;
}

}  // namespace

std::optional<TransparentImage> decode_by_pixbuf(std::string_view bytes) {
  const Loader loader(gdk_pixbuf_loader_new());
  if (!is_loaded(loader.get(), bytes)) return std::nullopt;
  const GdkPixbuf* pixbuf = gdk_pixbuf_loader_get_pixbuf(loader.get());
  TransparentImage decoded{rows_of(pixbuf), {}};
  if (decoded.image.channels == 4)
    decoded = apart_from_alpha(decoded.image.bytes, decoded.image.width_px, decoded.image.height_px, 4);
  // What BMPs of 32 bits have in their fourth byte is seldom an alpha channel.
  if (bytes.starts_with("BM")) decoded.transparent.clear();
  if (has_no_colour(decoded.image)) decoded.image = grey_of(decoded.image);
  return decoded;
}

}  // namespace aisle
