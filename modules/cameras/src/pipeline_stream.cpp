#include "pipeline_stream.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsink.h>
#include <gst/video/video.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "camera_url.hpp"

namespace aisle {
namespace {

constexpr std::size_t kImageBytesMax = std::size_t{64} << 20;  // a JPEG of 8192 x 8192 pixels has less
constexpr double kAgeMax_s = 10;
constexpr std::size_t kReasonMax = 200;

std::string reason_of(GstMessage* message) {
  GError* error = nullptr;
  gchar* details = nullptr;
  gst_message_parse_error(message, &error, &details);
  const GstOwned<GError> owned_error(error);
  const GstOwned<gchar> owned_details(details);
  std::string reason = error->message;
  while (reason.ends_with('.')) reason.pop_back();
  // The first line of the details is about GStreamer's sources; the last one knows the cause.
  std::string_view cause = details ? details : "";
  const auto line = cause.rfind('\n');
  cause = line == std::string_view::npos ? "" : cause.substr(line + 1);
  cause = cause.substr(0, cause.find(", URL:"));
  if (!cause.empty() && cause.size() < kReasonMax) reason += fmt::format(" ({})", cause);
  return without_secrets(reason);
}

/// "needs ..." if the message is about a decoder that is not installed.
std::optional<std::string> missing_decoder(GstMessage* message) {
  const GstStructure* facts = gst_message_get_structure(message);
  if (!facts || !gst_structure_has_name(facts, "missing-plugin")) return std::nullopt;
  const gchar* name = gst_structure_get_string(facts, "name");
  return fmt::format("needs GStreamer's {}: apt-get install gstreamer1.0-libav", name ? name : "decoder");
}

/// Rows without the padding that GStreamer has behind each.
std::optional<Image> copied(GstSample* sample, int channels) {
  GstVideoInfo info;
  GstVideoFrame frame;
  const GstCaps* caps = gst_sample_get_caps(sample);
  GstBuffer* buffer = gst_sample_get_buffer(sample);
  if (!caps || !buffer || !gst_video_info_from_caps(&info, caps) ||
      !gst_video_frame_map(&frame, &info, buffer, GST_MAP_READ))
    return std::nullopt;
  Image image(GST_VIDEO_FRAME_WIDTH(&frame), GST_VIDEO_FRAME_HEIGHT(&frame), channels);
  const auto* pixels = static_cast<const std::uint8_t*>(GST_VIDEO_FRAME_PLANE_DATA(&frame, 0));
  for (int v = 0; v < image.height_px; ++v)
    std::copy_n(pixels + std::ptrdiff_t{v} * GST_VIDEO_FRAME_PLANE_STRIDE(&frame, 0), image.row_bytes(),
                image.row(v));
  gst_video_frame_unmap(&frame);
  return image;
}

}  // namespace

Result<std::unique_ptr<ImageStream>> PipelineStream::open(const CameraSource& source) {
  auto parts = camera_pipeline(source);
  if (!parts) return parts.problems();
  return std::unique_ptr<ImageStream>(new PipelineStream(std::move(*parts), source.is_colour));
}

PipelineStream::PipelineStream(CameraPipeline parts, bool is_colour)
    : parts_(std::move(parts)), is_colour_(is_colour) {
  const GstOwned<GstClock> monotonic(gst_system_clock_obtain());
  gst_pipeline_use_clock(GST_PIPELINE(parts_.pipeline.get()), monotonic.get());
  if (parts_.source) count_bytes();
}

PipelineStream::~PipelineStream() {
  gst_element_set_state(parts_.pipeline.get(), GST_STATE_NULL);
}

/// A server that never ends an image must not fill the memory.
void PipelineStream::count_bytes() {
  const GstOwned<GstPad> pad(gst_element_get_static_pad(parts_.source.get(), "src"));
  if (!pad) return;  // rtspsrc: RTP ends its images itself
  const auto count = [](GstPad*, GstPadProbeInfo* info, gpointer bytes) {
    auto& since_image = *static_cast<std::atomic<std::size_t>*>(bytes);
    since_image += gst_buffer_get_size(GST_PAD_PROBE_INFO_BUFFER(info));
    return since_image > kImageBytesMax ? GST_PAD_PROBE_DROP : GST_PAD_PROBE_OK;
  };
  gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_BUFFER, count, &bytes_since_image_, nullptr);
}

void PipelineStream::start() {
  // What is not live, such as a file in a user's pipeline, is shown at its own pace.
  const bool is_live =
      gst_element_set_state(parts_.pipeline.get(), GST_STATE_PAUSED) == GST_STATE_CHANGE_NO_PREROLL;
  g_object_set(parts_.sink.get(), "sync", static_cast<gboolean>(!is_live), nullptr);
  gst_element_set_state(parts_.pipeline.get(), GST_STATE_PLAYING);
}

StreamNews PipelineStream::wait(double longest_s) {
  auto* sink = GST_APP_SINK(parts_.sink.get());
  const auto longest_ns = static_cast<GstClockTime>(longest_s * static_cast<double>(GST_SECOND));
  if (const GstOwned<GstSample> sample(gst_app_sink_try_pull_sample(sink, longest_ns)); sample)
    return image_of(sample.get());
  if (bytes_since_image_ > kImageBytesMax) return StreamEnd{"sends an image without an end"};
  if (auto why = trouble()) return StreamEnd{std::move(*why)};
  if (gst_app_sink_is_eos(sink)) return StreamEnd{"has ended its images"};
  return NothingYet{};
}

StreamNews PipelineStream::image_of(GstSample* sample) {
  bytes_since_image_ = 0;
  auto pixels = copied(sample, is_colour_ ? 3 : 1);
  if (!pixels) return RefusedImage{"an image that cannot be read"};
  return StreamedImage{std::move(*pixels), stamp_s(sample)};
}

/// The moment that the source stamped the image with; now, if it makes no sense.
double PipelineStream::stamp_s(GstSample* sample) const {
  const double now_s = clock_.now_s();
  const GstClockTime since_start = gst_segment_to_running_time(
      gst_sample_get_segment(sample), GST_FORMAT_TIME, GST_BUFFER_PTS(gst_sample_get_buffer(sample)));
  if (!GST_CLOCK_TIME_IS_VALID(since_start)) return now_s;
  // The pipeline's clock is SteadyClock's: Linux's CLOCK_MONOTONIC.
  const GstClockTime stamp = gst_element_get_base_time(parts_.pipeline.get()) + since_start;
  const double stamp_s = static_cast<double>(stamp) / static_cast<double>(GST_SECOND);
  return stamp_s <= now_s && stamp_s > now_s - kAgeMax_s ? stamp_s : now_s;
}

/// Why no more images will come, as far as GStreamer has said so.
std::optional<std::string> PipelineStream::trouble() const {
  const GstOwned<GstBus> bus(gst_element_get_bus(parts_.pipeline.get()));
  while (const GstOwned<GstMessage> message{gst_bus_pop(bus.get())}) {
    if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) return reason_of(message.get());
    if (auto missing = missing_decoder(message.get())) return missing;
  }
  return std::nullopt;
}

}  // namespace aisle
