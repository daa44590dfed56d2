#include "trial_journal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <exception>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace aisle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kJournalFormat = "aisle.trial";
constexpr int kJournalVersion = 1;
constexpr std::size_t kJournalBytesMax = std::size_t{1} << 30;

// Bytes whose locks say what the processes of a trial do, far beyond the journal's end.
constexpr off_t kOpenByte = off_t{1} << 40;  // who has the journal open shares it
constexpr off_t kAppendByte = kOpenByte + 1;
constexpr off_t kFirstMissionByte = kOpenByte + 2;

constexpr std::uint64_t kMissionBytes = std::uint64_t{1} << 40;

/// FNV-1a.
class Hash {
 public:
  void add(char byte) { value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U; }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// By its name: processes with other seeds number their missions otherwise.
off_t byte_of(const std::string& mission) {
  Hash hash;
  for (const char byte : mission) hash.add(byte);
  return kFirstMissionByte + static_cast<off_t>(hash.value() % kMissionBytes);
}

/// A hash of the running program: two builds that differ in anything differ in it.
std::string build_of_program() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  Hash hash;
  for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte) hash.add(*byte);
  return fmt::format("{:016x}", hash.value());
}

Json header_of(const TrialOptions& options) {
  return {{"format", kJournalFormat},
          {"version", kJournalVersion},
          {"command", fmt::format("aisle trial {}", fmt::join(options.words, " "))},
          {"first_seed", options.first_seed},
          {"build", build_of_program()}};
}

/// Whether the missions of both are of one trial: of the same options, whatever build ran them.
bool is_same_trial(Json header, Json other) {
  header.erase("build");
  other.erase("build");
  return header == other;
}

Problem no_journal(const Place& place) {
  return {place, "is no journal of a trial: choose another --out, or --force to replace it"};
}

}  // namespace

Result<TrialJournal> TrialJournal::open(const TrialOptions& options) {
  TrialJournal journal;
  if (options.out.empty()) return journal;
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error) return Problem{{options.out.string()}, "cannot be made: " + error.message()};
  journal.header_ = header_of(options);
  if (Problems problems = journal.enter(options); !problems.empty()) return problems;
  return journal;
}

/// Opens the file, and reads what it holds.
Problems TrialJournal::enter(const TrialOptions& options) {
  do {  // the last process to leave a journal without a line removes it
    file_.reset();
    auto file = SharedFile::open(options.out / "missions.jsonl");
    if (!file) return file.problems();
    file_.emplace(std::move(file).value());
    if (Problems problems = file_->wait_for_lock(kOpenByte, SharedFile::Lock::kShared); !problems.empty())
      return problems;
  } while (file_->is_replaced());
  if (options.force) {
    const auto is_alone = file_->lock(kOpenByte, SharedFile::Lock::kExclusive);
    if (!is_alone) return is_alone.problems();
    if (!*is_alone)
      return {{{path().string()}, "is being written by another trial, which --force would undo"}};
    if (Problems problems = file_->truncate(0); !problems.empty()) return problems;
    if (const auto shared = file_->lock(kOpenByte, SharedFile::Lock::kShared); !shared)
      return shared.problems();
  }
  if (Problems problems = read_news(); !problems.empty()) return problems;
  const auto size = file_->size();
  if (!size) return size.problems();
  if (read_lines_ == 0 && *size > 0) return {no_journal({path().string()})};
  kept_ = records_.size();
  is_entered_ = true;
  return {};
}

TrialJournal::~TrialJournal() {
  try {
    leave();
  } catch (const std::exception&) {  // for want of memory: an empty journal stays
  }
}

/// The last to leave a journal without a line removes it.
void TrialJournal::leave() {
  if (!file_) return;
  const auto is_alone = file_->lock(kOpenByte, SharedFile::Lock::kExclusive);
  const auto size = file_->size();
  if (is_alone && *is_alone && size && *size == 0) {
    std::error_code error;
    fs::remove(path(), error);
  }
}

/// Takes in the whole lines that were added since, by anybody. A line without its end is being written, or
/// its writer was killed.
Problems TrialJournal::read_news() {
  const auto bytes = file_->read_from(read_bytes_, kJournalBytesMax);
  if (!bytes) return bytes.problems();
  std::size_t begin = 0;
  for (std::size_t end = bytes->find('\n'); end != std::string::npos; end = bytes->find('\n', begin)) {
    ++read_lines_;
    if (Problems problems = take_line(bytes->substr(begin, end - begin)); !problems.empty()) return problems;
    begin = end + 1;
  }
  read_bytes_ += static_cast<off_t>(begin);
  return {};
}

Problems TrialJournal::take_line(const std::string& line) {
  const Json said = Json::parse(line, nullptr, false);
  if (read_lines_ == 1) return take_header(said);
  const auto holds = [&](const char* key, Json::value_t type) {
    return said.is_object() && said.contains(key) && said[key].type() == type;
  };
  if (!holds("mission", Json::value_t::string))
    return {{{path().string(), read_lines_}, "is no mission's record"}};
  const auto name = said["mission"].get<std::string>();
  if (holds("record", Json::value_t::object)) {
    records_[name] = said["record"];
  } else if (!holds("died", Json::value_t::string)) {
    return {{{path().string(), read_lines_}, "is no mission's record"}};
  } else if (is_entered_) {
    deaths_[name] = said["died"].get<std::string>();
  }
  return {};
}

Problems TrialJournal::take_header(const Json& said) {
  const Place place{path().string(), 1};
  if (!said.is_object() || said.value("format", Json()) != kJournalFormat) return {no_journal(place)};
  if (!is_same_trial(said, header_))
    return {
        {place, fmt::format("holds the missions of {} from seed {} on: choose another --out, or --force to "
                            "replace them",
                            said.value("command", Json()).dump(), said.value("first_seed", Json()).dump())}};
  is_of_another_build_ = said.value("build", Json()) != header_["build"];
  return {};
}

Result<MissionClaim> TrialJournal::claim(const std::string& name) {
  if (has_ended(name)) return MissionClaim::kEnded;
  if (!file_) return MissionClaim::kGranted;
  const auto is_granted = file_->lock(byte_of(name), SharedFile::Lock::kExclusive);
  if (!is_granted) return is_granted.problems();
  if (!*is_granted) return MissionClaim::kRefused;
  // Its last holder may have added it between the last look at the news and the lock.
  if (Problems problems = read_news(); !problems.empty()) return problems;
  if (!has_ended(name)) return MissionClaim::kGranted;
  file_->unlock(byte_of(name));
  return MissionClaim::kEnded;
}

Problems TrialJournal::add(const std::string& name, const Json& record) {
  if (file_) return append(name, {{"mission", name}, {"record", record}});
  records_.emplace(name, record);
  return {};
}

Problems TrialJournal::add_death(const std::string& name, const std::string& died_of) {
  if (file_) return append(name, {{"mission", name}, {"died", died_of}});
  deaths_.emplace(name, died_of);
  return {};
}

/// Adds a line, and the header before the first one. What a killed process left of its last line is cut off.
Problems TrialJournal::append(const std::string& name, const Json& line) {
  const auto text_of = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  };
  Problems problems = file_->wait_for_lock(kAppendByte, SharedFile::Lock::kExclusive);
  if (problems.empty()) problems = read_news();
  if (problems.empty()) problems = file_->truncate(read_bytes_);
  if (problems.empty()) problems = file_->append((read_lines_ == 0 ? text_of(header_) : "") + text_of(line));
  if (problems.empty()) problems = read_news();
  file_->unlock(kAppendByte);
  file_->unlock(byte_of(name));
  return problems;
}

}  // namespace aisle
