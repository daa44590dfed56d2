#include "trial_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kJournalFormat = "aisle.trial";
constexpr int kJournalVersion = 1;
constexpr std::size_t kJournalBytesMax = std::size_t{1} << 30;

/// FNV-1a of the running program: two builds that differ in anything differ in it.
std::string build_of_program() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte)
    hash = (hash ^ static_cast<unsigned char>(*byte)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
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

}  // namespace

Result<TrialJournal> TrialJournal::open(const TrialOptions& options) {
  if (options.out.empty()) return TrialJournal({});
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error) return Problem{{options.out.string()}, "cannot be made: " + error.message()};
  TrialJournal journal(options.out / "missions.jsonl");
  const std::string name = journal.path_.string();
  const int mode = O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK;
  journal.descriptor_ = ::open(name.c_str(), mode, 0666);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (journal.descriptor_ < 0)
    return Problem{{name}, fmt::format("cannot be opened: {}", std::strerror(errno))};
  if (::flock(journal.descriptor_, LOCK_EX | LOCK_NB) != 0)
    return Problem{{name}, "is being written by another trial"};
  if (options.force && ::ftruncate(journal.descriptor_, 0) != 0)
    return Problem{{name}, fmt::format("cannot be emptied: {}", std::strerror(errno))};
  const Json header = header_of(options);
  const auto text = read_whole_file(journal.path_, kJournalBytesMax);
  if (!text) return text.problems();
  Problems problems = text->empty() ? journal.write(header) : journal.read(header, *text);
  if (!problems.empty()) return problems;
  return journal;
}

TrialJournal::TrialJournal(TrialJournal&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_of_another_build_(other.is_of_another_build_),
      kept_(std::move(other.kept_)) {}

TrialJournal::~TrialJournal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// Takes the missions of whole lines; what a killed program left of its last line is cut off.
Problems TrialJournal::read(const Json& header, const std::string& text) {
  const std::size_t whole = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
  std::istringstream lines(text.substr(0, whole));
  long number = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json said = Json::parse(line, nullptr, false);
    const Place place{path_.string(), ++number};
    if (number == 1) {
      if (!said.is_object() || said.value("format", Json()) != kJournalFormat)
        return {{place, "is no journal of a trial: choose another --out, or --force to replace it"}};
      if (!is_same_trial(said, header))
        return {{place,
                 fmt::format("holds the missions of {} from seed {} on: choose another --out, or --force to "
                             "replace them",
                             said.value("command", Json()).dump(), said.value("first_seed", Json()).dump())}};
      is_of_another_build_ = said.value("build", Json()) != header["build"];
      continue;
    }
    const bool is_mission = said.is_object() && said.contains("mission") && said["mission"].is_string() &&
                            said.contains("record") && said["record"].is_object();
    if (!is_mission) return {{place, "is no mission's record"}};
    kept_[said["mission"].get<std::string>()] = said["record"];
  }
  if (whole == 0) return write(header);
  if (::ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    return {{{path_.string()}, fmt::format("cannot be cut to whole lines: {}", std::strerror(errno))}};
  return {};
}

Problems TrialJournal::write(const Json& line) const {
  const std::string text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  const ssize_t written = ::write(descriptor_, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size()) && ::fdatasync(descriptor_) == 0) return {};
  return {{{path_.string()}, fmt::format("cannot be written: {}", std::strerror(errno))}};
}

Problems TrialJournal::add(const std::string& name, const Json& record) {
  if (path_.empty()) return {};
  return write({{"mission", name}, {"record", record}});
}

}  // namespace aisle
