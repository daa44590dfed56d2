#include <fmt/format.h>
#include <poppler.h>

#include <memory>

#include "images/drawing.hpp"

namespace aisle {
namespace {

struct ObjectRelease {
  void operator()(void* object) const { g_object_unref(object); }
};

}  // namespace

Result<Drawing> read_pdf(std::string_view bytes, const std::string& name) {
  GError* error = nullptr;
  GBytes* copy = g_bytes_new(bytes.data(), bytes.size());
  const std::shared_ptr<PopplerDocument> document(poppler_document_new_from_bytes(copy, nullptr, &error),
                                                  [](PopplerDocument* d) {
                                                    if (d != nullptr) g_object_unref(d);
                                                  });
  g_bytes_unref(copy);
  if (document == nullptr) {
    const std::string why = error != nullptr ? error->message : "";
    g_clear_error(&error);
    return Problem{{name}, "is not a PDF that can be read: " + why};
  }
  const int pages = poppler_document_get_n_pages(document.get());
  PopplerPage* first = pages > 0 ? poppler_document_get_page(document.get(), 0) : nullptr;
  if (first == nullptr) return Problem{{name}, "has no page"};
  const std::shared_ptr<PopplerPage> page(first, ObjectRelease());
  Drawing drawing;
  poppler_page_get_size(page.get(), &drawing.width, &drawing.height);
  if (pages > 1) drawing.warnings.push_back({{name}, fmt::format("has {} pages; the first is read", pages)});
  drawing.paint = [document, page](cairo_t* canvas, double) {
    poppler_page_render_for_printing(page.get(), canvas);
    return true;
  };
  return drawing;
}

}  // namespace aisle
