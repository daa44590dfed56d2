#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <array>
#include <charconv>
#include <memory>

#include "images/drawing.hpp"

namespace aisle {
namespace {

struct ObjectEnd {
  void operator()(void* object) const {
    if (object != nullptr) g_object_unref(object);
  }
};

/// The text of an attribute of the first <svg> tag.
std::string_view svg_attribute(std::string_view bytes, const std::string& key) {
  const std::size_t tag = bytes.find("<svg");
  const std::string_view head = bytes.substr(tag, bytes.find('>', tag) - tag);
  for (const char* blank : {" ", "\n", "\t", "\r"}) {
    for (const char quote : {'"', '\''}) {
      const std::string start = blank + key + "=" + quote;
      if (const std::size_t at = head.find(start); at != std::string_view::npos) {
        const std::string_view rest = head.substr(at + start.size());
        return rest.substr(0, rest.find(quote));
      }
    }
  }
  return {};
}

/// "210mm" in metres; nullopt in pixels, percent or no unit: they say nothing of the building.
std::optional<double> length_m(std::string_view text) {
  struct Unit {
    std::string_view name;
    double length_m;
  };
  static constexpr std::array kUnits{Unit{"mm", 0.001}, Unit{"cm", 0.01}, Unit{"m", 1}, Unit{"in", 0.0254}};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !(value > 0)) return std::nullopt;
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  for (const Unit& known : kUnits) {
    if (unit == known.name) return value * known.length_m;
  }
  return std::nullopt;
}

std::string_view next_number(std::string_view& text) {
  const std::size_t start = std::min(text.find_first_not_of(" ,\t\r\n"), text.size());
  const std::size_t end = std::min(text.find_first_of(" ,\t\r\n", start), text.size());
  const std::string_view number = text.substr(start, end - start);
  text.remove_prefix(end);
  return number;
}

double svg_number(std::string_view text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

Result<Drawing> read_svg(std::string_view bytes, const std::string& name) {
  GError* error = nullptr;
  const std::shared_ptr<RsvgHandle> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(bytes.data()), bytes.size(), &error),
      ObjectEnd());
  if (handle == nullptr) {
    const std::string why = error != nullptr ? error->message : "";
    g_clear_error(&error);
    return Problem{{name}, "is not an SVG that can be read: " + why};
  }
  Drawing drawing;
  const std::string_view width = svg_attribute(bytes, "width"), height = svg_attribute(bytes, "height");
  if (std::string_view box = svg_attribute(bytes, "viewBox"); !box.empty()) {
    next_number(box), next_number(box);
    drawing.width = svg_number(next_number(box));
    drawing.height = svg_number(next_number(box));
    if (const auto metres = length_m(width)) drawing.unit_m = *metres / drawing.width;
  } else {
    drawing.width = svg_number(width);
    drawing.height = svg_number(height);
    if (const auto metres = length_m(width)) drawing.unit_m = *metres / drawing.width;
  }
  if (!(drawing.width > 0 && drawing.height > 0))
    return Problem{{name}, "has neither a viewBox nor a width and a height"};
  drawing.paint = [handle, size = RsvgRectangle{0, 0, drawing.width, drawing.height}](cairo_t* canvas,
                                                                                      double) {
    return rsvg_handle_render_document(handle.get(), canvas, &size, nullptr) != FALSE;
  };
  return drawing;
}

}  // namespace aisle
