#include "session_index.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>
#include <utility>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kMetadata = "metadata.yaml";
constexpr const char* kIndex = ".aisle-sessions.json";
constexpr int kVersion = 1;
constexpr std::size_t kIndexMax_bytes = std::size_t{64} << 20;

long long changed_ns(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  if (error) return 0;
  const auto system = std::chrono::file_clock::to_sys(time).time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(system).count();
}

/// Sizes and times of a session's files; empty where there is no session. Changes when the session does.
std::string state_of(const fs::path& session) {
  std::error_code error;
  if (!fs::exists(session / kMetadata, error)) return {};
  std::string state;
  for (fs::directory_iterator at(session, error), end; !error && at != end; at.increment(error)) {
    std::error_code unknown;
    const auto bytes = at->file_size(unknown);
    if (!unknown)
      state += fmt::format("{} {} {};", at->path().filename().string(), bytes, changed_ns(at->path()));
  }
  return state;
}

/// Null where the session cannot be read.
OrderedJson row_of(const fs::path& session) {
  const auto outline = outline_session(session);
  if (!outline) return nullptr;
  std::error_code error;
  const fs::path file = session / outline->file;
  const auto bytes = fs::file_size(file, error);
  OrderedJson row = {{"name", session.filename().string()}, {"file", outline->file},
                     {"duration_s", outline->duration_s},   {"messages", outline->messages},
                     {"bytes", error ? 0 : bytes},          {"recorded_s", changed_ns(file) / 1'000'000'000}};
  if (const auto cycles = SessionCycles::open(session)) {
    row["navigator"] = cycles->origin().navigator;
    row["simulated"] = cycles->origin().simulated;
    row["route"] = cycles->origin().route;
  }
  return row;
}

}  // namespace

OrderedJson SessionIndex::rows() {
  if (!std::exchange(is_loaded_, true)) load();
  std::map<std::string, Entry> present;
  bool has_changed = false;
  std::error_code error;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    std::string state = state_of(at->path());
    if (state.empty()) continue;
    const auto known = entries_.find(name);
    if (known != entries_.end() && known->second.state == state) {
      present[name] = std::move(known->second);
    } else {
      present[name] = {std::move(state), row_of(at->path())};
      has_changed = true;
    }
  }
  has_changed |= present.size() != entries_.size();
  entries_ = std::move(present);
  if (has_changed) save();
  OrderedJson rows = OrderedJson::array();
  for (const auto& [name, entry] : entries_) {
    if (!entry.row.is_null()) rows.push_back(entry.row);
  }
  return rows;
}

/// An index that is missing, damaged or of another version is made again.
void SessionIndex::load() {
  if (folder_.empty()) return;
  const auto text = read_whole_file(folder_ / kIndex, kIndexMax_bytes);
  if (!text) return;
  const auto json = OrderedJson::parse(*text, nullptr, false);
  const auto is_text = [](const OrderedJson& value) { return value.is_string(); };
  if (!json.is_object() || !json.contains("version") || json["version"] != kVersion) return;
  if (!json.contains("sessions") || !json["sessions"].is_object()) return;
  for (const auto& [name, entry] : json["sessions"].items()) {
    if (!entry.is_object() || !entry.contains("state") || !is_text(entry["state"]) || !entry.contains("row"))
      continue;
    const OrderedJson& row = entry["row"];
    if (row.is_null() || row.is_object()) entries_[name] = {entry["state"].get<std::string>(), row};
  }
}

/// Where the folder cannot be written to, the list is quick only as long as the program runs.
void SessionIndex::save() const {
  OrderedJson sessions = OrderedJson::object();
  for (const auto& [name, entry] : entries_) sessions[name] = {{"state", entry.state}, {"row", entry.row}};
  const OrderedJson json = {{"version", kVersion}, {"sessions", std::move(sessions)}};
  (void)write_whole_file(folder_ / kIndex, json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
}

}  // namespace aisle
