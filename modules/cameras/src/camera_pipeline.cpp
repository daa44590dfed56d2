#include "camera_pipeline.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsink.h>

#include <string>

#include "camera_url.hpp"
#include "debian_package.hpp"
#include "jpeg_limit.hpp"

namespace aisle {
namespace {

constexpr const char* kSourceName = "aisle_source";
constexpr const char* kSinkName = "aisle_images";

// Only what is written here, or by the user as a pipeline, is read as GStreamer's language. Paths and URLs
// are set as properties, so nothing in them can become an element.
constexpr std::string_view kDevice = "v4l2src name={}{} ! decodebin";
constexpr std::string_view kMjpeg =
    "souphttpsrc name={} is-live=true do-timestamp=true retries=0 proxy=\"\" ! multipartdemux "
    "single-stream=true ! image/jpeg ! jpegdec idct-method=islow";
constexpr std::string_view kRtsp = "rtspsrc name={} ! application/x-rtp,media=video ! decodebin";
constexpr std::string_view kImages =
    "{} ! capsfilter name=video caps=video/x-raw,width=[1,{}],height=[1,{}] ! videoconvert ! "
    "video/x-raw,format={} ! appsink name={} max-buffers=1 drop=true";
constexpr int kSideMax_px = 8192;

/// Raw or MJPEG, whatever the device has in this size.
std::string device_size(const CameraSource& source) {
  if (source.width_px == 0) return "";
  const std::string size = fmt::format("width={},height={}", source.width_px, source.height_px);
  return fmt::format(" ! capsfilter caps=\"video/x-raw,{0};image/jpeg,{0}\"", size);
}

/// The elements that read and decode.
std::string origin_text(const CameraSource& source) {
  if (!source.device.empty()) return fmt::format(kDevice, kSourceName, device_size(source));
  if (source.url.starts_with("http")) return fmt::format(kMjpeg, kSourceName);
  if (!source.url.empty()) return fmt::format(kRtsp, kSourceName);
  return source.pipeline;
}

std::string whole_text(const CameraSource& source) {
  return fmt::format(kImages, origin_text(source), kSideMax_px, kSideMax_px,
                     source.is_colour ? "RGB" : "GRAY8", kSinkName);
}

/// Why GStreamer cannot be used at all; empty: it can.
const std::string& start_problem() {
  static const std::string problem = [] {
    GError* error = nullptr;
    if (gst_init_check(nullptr, nullptr, &error)) return std::string();
    const GstOwned<GError> owned(error);
    return fmt::format("GStreamer does not start: {}", owned ? owned->message : "no reason given");
  }();
  return problem;
}

Problem parse_problem(const GError& error, GstParseContext* context) {
  if (g_error_matches(&error, GST_PARSE_ERROR, GST_PARSE_ERROR_NO_SUCH_ELEMENT)) {
    const GstOwned<gchar*> missing(gst_parse_context_get_missing_elements(context));
    if (missing && missing.get()[0]) return {{.key = "camera"}, how_to_install(missing.get()[0])};
  }
  return {{.key = "pipeline"}, fmt::format("gives no images: {}", without_secrets(error.message))};
}

Result<GstOwned<GstElement>> parsed(const std::string& text) {
  const GstOwned<GstParseContext> context(gst_parse_context_new());
  GError* error = nullptr;
  GstOwned<GstElement> pipeline(
      gst_parse_launch_full(text.c_str(), context.get(), GST_PARSE_FLAG_FATAL_ERRORS, &error));
  if (const GstOwned<GError> owned(error); owned) return parse_problem(*owned, context.get());
  if (pipeline) gst_object_ref_sink(pipeline.get());
  return pipeline;
}

void configure(GstElement* element, const CameraSource& source) {
  if (!source.device.empty()) return g_object_set(element, "device", source.device.c_str(), nullptr);
  const CameraUrl url = split_url(source.url);
  g_object_set(element, "location", url.location.c_str(), nullptr);
  if (!url.user.empty())
    g_object_set(element, "user-id", url.user.c_str(), "user-pw", url.password.c_str(), nullptr);
  if (source.url.starts_with("rtsp"))
    g_object_set(element, "latency", static_cast<guint>(source.latency_ms), nullptr);
}

}  // namespace

Result<CameraPipeline> camera_pipeline(const CameraSource& source) {
  if (!start_problem().empty()) return Problem{{.key = "camera"}, start_problem()};
  auto pipeline = parsed(whole_text(source));
  if (!pipeline) return pipeline.problems();
  if (!GST_IS_PIPELINE(pipeline->get())) return Problem{{.key = "pipeline"}, "is not one pipeline"};
  CameraPipeline made{.pipeline = std::move(*pipeline), .sink = {}, .source = {}};
  auto* const bin = GST_BIN(made.pipeline.get());
  made.sink.reset(gst_bin_get_by_name(bin, kSinkName));
  if (!GST_IS_APP_SINK(made.sink.get())) return Problem{{.key = "pipeline"}, "does not end in video"};
  limit_jpeg_size(bin, kSideMax_px);
  if (source.pipeline.empty()) {
    made.source.reset(gst_bin_get_by_name(bin, kSourceName));
    configure(made.source.get(), source);
  }
  return made;
}

}  // namespace aisle
