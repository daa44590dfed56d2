#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/live/live_folders.hpp"

namespace aisle {

struct HttpQuestion {
  std::string_view method;
  std::string_view target;
  std::string_view body;
  bool knows_token = false;
  bool has_lease = false;
  bool takes_gzip = false;
  std::string_view known_tags = {};  ///< the If-None-Match header
};

struct HttpReply {
  unsigned status = 200;
  std::string media_type = "application/json";
  std::string body;
  std::optional<std::filesystem::path> file = {};  ///< the body, if there is one
  std::string tag = {};                            ///< the ETag header; empty: none
  bool is_gzip = false;
  bool is_for_ever = false;  ///< the address names this content alone
};

/// A reply with an error message.
HttpReply http_problem(unsigned status, const std::string& what);

/// Answers HTTP requests; does not use sockets.
class HttpRequestHandler {
 public:
  static constexpr std::size_t kBuildingBytesMax = std::size_t{16} << 20;

  HttpRequestHandler(LiveFolders folders, std::string version);

  /// Whether the request may have a body as large as a building file.
  static bool brings_building(std::string_view method, std::string_view target);

  HttpReply answer(const HttpQuestion& question) const;

 private:
  HttpReply page(const HttpQuestion& question, std::string_view path) const;
  HttpReply sessions(std::string_view path) const;
  HttpReply buildings(const HttpQuestion& question, std::string_view path) const;
  HttpReply keep_building(const HttpQuestion& question, std::string_view name) const;

  LiveFolders folders_;
  std::string version_;
};

}  // namespace aisle
