#pragma once

#include <string>
#include <utility>

#include "aisle/core/image.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "local_server.hpp"

namespace aisle {

/// Somebody who has asked a camera for its MJPEG stream, as the camera sees them.
class MjpegViewer {
 public:
  explicit MjpegViewer(Socket socket) : socket_(std::move(socket)), request_(socket_.read_request()) {
    answer("200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=frame", "");
  }

  /// One that gets another answer, and no stream.
  MjpegViewer(Socket socket, const std::string& head, const std::string& body)
      : socket_(std::move(socket)), request_(socket_.read_request()) {
    answer(head + "\r\nContent-Length: " + std::to_string(body.size()), body);
  }

  const std::string& request() const { return request_; }

  bool show(const Image& image) const { return show_jpeg(jpeg_bytes(image, 95)); }
  bool show_jpeg(const std::string& jpeg) const { return begin_image(jpeg.size()) && write(jpeg + "\r\n"); }
  bool begin_image(std::size_t size) const {
    return write("--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(size) +
                 "\r\n\r\n");
  }
  bool write(const std::string& bytes) const { return socket_.write(bytes); }

 private:
  void answer(const std::string& head, const std::string& body) const {
    write("HTTP/1.1 " + head + "\r\nConnection: close\r\n\r\n" + body);
  }

  Socket socket_;
  std::string request_;
};

}  // namespace aisle
