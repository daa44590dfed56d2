#include "http_request_handler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "aisle/live/building_versions.hpp"
#include "web_address.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kSessions = "/sessions/";
constexpr std::string_view kBuildings = "/buildings/";
/// Files of the page whose names change with their content.
constexpr std::string_view kNamedByContent = "assets/";
constexpr const char* kNoPage =
    "The page is not built. In the source tree:\n\n    cd web && npm ci && npm run build\n\n"
    "Foxglove and other programs can connect to this address all the same.\n";

HttpReply json_reply(unsigned status, const OrderedJson& json) {
  return {.status = status, .body = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace)};
}

HttpReply file_reply(const fs::path& folder, std::string_view path) {
  std::error_code error;
  const auto file = file_below(folder, path);
  if (folder.empty() || !file || !fs::is_regular_file(*file, error))
    return http_problem(404, "there is no such file");
  return {.media_type = media_type(*file), .body = {}, .file = *file};
}

/// The file that the page's build has compressed, if there is one.
void prefer_gzip(HttpReply& reply) {
  fs::path compressed = *reply.file;
  compressed += ".gz";
  std::error_code error;
  if (!fs::is_regular_file(compressed, error)) return;
  reply.file = std::move(compressed);
  reply.is_gzip = true;
}

/// Changes when the file does.
std::string tag_of(const fs::path& file) {
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  const auto time = error ? fs::file_time_type() : fs::last_write_time(file, error);
  return error ? std::string() : fmt::format("\"{:x}-{:x}\"", bytes, time.time_since_epoch().count());
}

/// The names of a folder's entries, sorted.
template <class Name>
OrderedJson names_in(const fs::path& folder, Name name_of) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::string name = name_of(*at);
    if (is_plain_name(name)) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string session_name(const fs::directory_entry& entry) {
  std::error_code error;
  return fs::exists(entry.path() / "metadata.yaml", error) ? entry.path().filename().string() : "";
}

std::string building_name(const fs::directory_entry& entry) {
  return entry.path().extension() == ".json" ? entry.path().stem().string() : "";
}

}  // namespace

HttpReply http_problem(unsigned status, const std::string& what) {
  return json_reply(status, {{"problems", {what}}});
}

HttpRequestHandler::HttpRequestHandler(LiveFolders folders, std::string version)
    : folders_(std::move(folders)), version_(std::move(version)) {}

bool HttpRequestHandler::brings_building(std::string_view method, std::string_view target) {
  return method == "POST" && path_of(target).starts_with(kBuildings);
}

HttpReply HttpRequestHandler::answer(const HttpQuestion& question) const {
  const std::string_view path = path_of(question.target);
  const bool is_posted = brings_building(question.method, question.target);
  if (question.method != "GET" && question.method != "HEAD" && !is_posted)
    return http_problem(405, "only GET, and POST of buildings");
  if (path == "/healthz") return json_reply(200, {{"ok", true}, {"version", version_}});
  const bool is_kept = path.starts_with(kSessions) || path.starts_with(kBuildings);
  if (!is_kept) return page(question, path);
  if (!question.knows_token) return http_problem(401, "the token is missing or wrong");
  if (path.starts_with(kSessions)) return sessions(path.substr(kSessions.size()));
  return buildings(question, path.substr(kBuildings.size()));
}

HttpReply HttpRequestHandler::page(const HttpQuestion& question, std::string_view path) const {
  const std::string_view within = path.starts_with('/') ? path.substr(1) : path;
  HttpReply reply = file_reply(folders_.web, within.empty() ? "index.html" : within);
  if (within.empty() && reply.status == 404)
    return {.media_type = "text/plain; charset=utf-8", .body = kNoPage};
  if (reply.status != 200) return reply;
  reply.is_for_ever = within.starts_with(kNamedByContent);
  if (question.takes_gzip) prefer_gzip(reply);
  reply.tag = tag_of(*reply.file);
  if (!reply.tag.empty() && question.known_tags.find(reply.tag) != std::string_view::npos) {
    reply.status = 304;
    reply.file.reset();
  }
  return reply;
}

HttpReply HttpRequestHandler::sessions(std::string_view path) const {
  if (path.empty()) return json_reply(200, {{"sessions", names_in(folders_.sessions, session_name)}});
  return file_reply(folders_.sessions, path);
}

HttpReply HttpRequestHandler::buildings(const HttpQuestion& question, std::string_view path) const {
  if (question.method == "POST") return keep_building(question, path);
  if (path.empty()) return json_reply(200, {{"buildings", names_in(folders_.buildings, building_name)}});
  return file_reply(folders_.buildings, path);
}

HttpReply HttpRequestHandler::keep_building(const HttpQuestion& question, std::string_view name) const {
  if (!question.has_lease) return http_problem(403, "needs the driver's lease, as X-Aisle-Lease");
  if (folders_.buildings.empty())
    return http_problem(404, "the server was started without a folder of buildings");
  const auto kept = keep_building_version(folders_.buildings, name, question.body);
  if (kept) return json_reply(201, {{"building", *kept}});
  OrderedJson problems = OrderedJson::array();
  for (const Problem& problem : kept.problems()) problems.push_back(to_string(problem));
  return json_reply(422, {{"problems", std::move(problems)}});
}

}  // namespace aisle
