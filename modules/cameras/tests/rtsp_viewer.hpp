#pragma once

#include <gst/app/gstappsink.h>
#include <gst/app/gstappsrc.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "aisle/core/image.hpp"
#include "gst_pointers.hpp"
#include "local_server.hpp"

namespace aisle {

/// Packs images into RTP as RFC 2435 says.
class RtpJpeg {
 public:
  explicit RtpJpeg(const Image& like) {
    gst_init(nullptr, nullptr);
    // Several packets an image, as from any real camera: a single one is not yet taken for a sender.
    const std::string text =
        "appsrc name=in format=time caps=video/x-raw,format=GRAY8,framerate=10/1,width=" +
        std::to_string(like.width_px) + ",height=" + std::to_string(like.height_px) +
        " ! videoconvert ! video/x-raw,format=I420 ! jpegenc quality=95 ! rtpjpegpay "
        "pt=26 mtu=300 ! appsink name=out sync=false";
    pipeline_.reset(gst_parse_launch(text.c_str(), nullptr));
    in_.reset(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "in"));
    out_.reset(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "out"));
    gst_element_set_state(pipeline_.get(), GST_STATE_PLAYING);
  }
  RtpJpeg(const RtpJpeg&) = delete;
  RtpJpeg& operator=(const RtpJpeg&) = delete;
  ~RtpJpeg() { gst_element_set_state(pipeline_.get(), GST_STATE_NULL); }

  /// The packets of one image, each behind its four bytes of interleaving.
  std::string packets(const Image& image) {
    GstBuffer* raw = gst_buffer_new_memdup(image.bytes.data(), image.bytes.size());
    GST_BUFFER_PTS(raw) = images_++ * GST_SECOND / 10;
    gst_app_src_push_buffer(GST_APP_SRC(in_.get()), raw);
    std::string interleaved;
    for (bool is_last = false; !is_last;) {
      const std::string packet = next_packet();
      is_last = (packet.at(1) & 0x80) != 0;  // RTP's marker
      const auto size = packet.size();
      interleaved += {'$', 0, static_cast<char>(size >> 8), static_cast<char>(size & 0xff)};
      interleaved += packet;
    }
    return interleaved;
  }

 private:
  std::string next_packet() {
    const GstOwned<GstSample> sample(
        gst_app_sink_try_pull_sample(GST_APP_SINK(out_.get()), kPatience.count() * GST_SECOND));
    if (!sample) throw std::runtime_error("no packet");
    GstBuffer* buffer = gst_sample_get_buffer(sample.get());
    std::string packet(gst_buffer_get_size(buffer), '\0');
    gst_buffer_extract(buffer, 0, packet.data(), packet.size());
    return packet;
  }

  GstOwned<GstElement> pipeline_;
  GstOwned<GstElement> in_;
  GstOwned<GstElement> out_;
  GstClockTime images_ = 0;
};

/// Somebody who has asked a camera for its stream by RTSP, with RTP in the same connection.
class RtspViewer {
 public:
  RtspViewer(Socket socket, const Image& like) : socket_(std::move(socket)), rtp_(like) {
    while (!is_playing_) answer(socket_.read_request());
  }

  bool show(const Image& image) { return socket_.write(rtp_.packets(image)); }

 private:
  void answer(const std::string& request) {
    if (request.empty()) throw std::runtime_error("the viewer has gone");
    const std::string sdp =
        "v=0\r\no=- 0 0 IN IP4 127.0.0.1\r\ns=test\r\nt=0 0\r\na=control:*\r\n"
        "m=video 0 RTP/AVP 26\r\nc=IN IP4 127.0.0.1\r\na=control:track\r\n";
    const auto begin = request.find("CSeq:");
    std::string reply = "RTSP/1.0 200 OK\r\n" + request.substr(begin, request.find("\r\n", begin) - begin);
    if (request.starts_with("DESCRIBE"))
      reply += "\r\nContent-Type: application/sdp\r\nContent-Length: " + std::to_string(sdp.size()) +
               "\r\n\r\n" + sdp;
    else if (request.starts_with("SETUP"))
      reply += "\r\nSession: 1\r\nTransport: RTP/AVP/TCP;unicast;interleaved=0-1\r\n\r\n";
    else if (request.starts_with("OPTIONS"))
      reply += "\r\nPublic: OPTIONS, DESCRIBE, SETUP, PLAY, TEARDOWN\r\n\r\n";
    else
      reply += "\r\nSession: 1\r\n\r\n";
    socket_.write(reply);
    is_playing_ = request.starts_with("PLAY");
  }

  Socket socket_;
  RtpJpeg rtp_;
  bool is_playing_ = false;
};

}  // namespace aisle
