#include "aisle/vehicle/camera_source.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

constexpr std::array<std::string_view, 5> kUrlSchemes = {"rtsp://", "rtspt://", "rtsps://", "http://",
                                                         "https://"};

bool has_scheme(std::string_view url) {
  return std::any_of(kUrlSchemes.begin(), kUrlSchemes.end(),
                     [&](std::string_view scheme) { return url.starts_with(scheme); });
}

bool has_blank(std::string_view url) {
  return std::any_of(url.begin(), url.end(), [](unsigned char c) { return c <= ' ' || c == 0x7f; });
}

/// The values are set again, so that each meets its own range.
Problems out_of_range(CameraSource source) {
  FieldList fields = fields_of(source);
  const std::vector<Field> all = fields.all();
  Problems problems;
  for (const Field& field : all) {
    for (Problem& found : fields.assign(field.key, field.value_text(), {}))
      problems.push_back(std::move(found));
  }
  return problems;
}

}  // namespace

std::array<CameraSource::Origin, 4> CameraSource::origins() {
  return {{{"device", &device}, {"url", &url}, {"folder", &folder}, {"pipeline", &pipeline}}};
}

void CameraSource::describe(FieldList& fields) {
  fields.flag("colour", is_colour, "images are red, green, blue instead of grey");
  fields.count("width_px", width_px, {0, 8192}, "of every image; 0: as the first has it");
  fields.count("height_px", height_px, {0, 8192}, "of every image; 0: as the first has it");
  fields.count("latency_ms", latency_ms, {0, 5000}, "how long rtsp waits for packets that come late");
  fields.real("exposure_offset_s", exposure_offset_s, {-5, 5},
              "middle of the exposure, from the moment that the image is stamped with; mostly negative");
  fields.real("silent_max_s", silent_max_s, {0.2, 60},
              "after so long without an image the camera is opened again, and again every so long");
  fields.real("rate_hz", rate_hz, {0.01, 1000}, "a folder's images a second");
  fields.flag("loops", loops, "a folder begins again after its last image");
}

Problems CameraSource::problems() const {
  CameraSource copy = *this;
  const auto origins = copy.origins();
  const auto given = std::count_if(origins.begin(), origins.end(),
                                   [](const Origin& origin) { return !origin.text->empty(); });
  Problems problems = out_of_range(*this);
  if (given != 1) {
    problems.push_back(
        {{}, fmt::format("{} of device, url, folder and pipeline are given, instead of one", given)});
  }
  if (!url.empty() && !has_scheme(url)) {
    problems.push_back({{.key = "url"}, fmt::format("does not begin with {}", fmt::join(kUrlSchemes, ", "))});
  }
  if (has_blank(url)) problems.push_back({{.key = "url"}, "contains a blank, which is written %20"});
  if ((width_px == 0) != (height_px == 0))
    problems.push_back({{.key = "width_px"}, "and height_px are given both or not at all"});
  return problems;
}

}  // namespace aisle
