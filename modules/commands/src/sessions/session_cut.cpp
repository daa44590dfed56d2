#include "aisle/commands/sessions/session_cut.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "aisle/formats/sessions/session_writer.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

struct Part {
  ros::Stamp_ns from = 0;
  ros::Stamp_ns to = 0;  ///< inclusive
};

Part part_of(const SessionSummary& summary, const SessionCutOptions& options) {
  const ros::Stamp_ns from = ros::stamp_ns(options.from_s);
  return {summary.first + from, options.to_s ? summary.first + ros::stamp_ns(*options.to_s)
                                             : std::numeric_limits<ros::Stamp_ns>::max()};
}

/// Removes an unfinished session, however its writing ends.
class NewSession {
 public:
  explicit NewSession(SessionWriter writer) : writer_(std::move(writer)) {}
  NewSession(const NewSession&) = delete;
  NewSession& operator=(const NewSession&) = delete;
  ~NewSession() {
    if (!is_whole_) writer_.discard();
  }

  SessionWriter& writer() { return writer_; }
  Problems finish() {
    Problems problems = writer_.close();
    is_whole_ = problems.empty();
    return problems;
  }

 private:
  SessionWriter writer_;
  bool is_whole_ = false;
};

/// The messages from before the part that the part needs.
class Earlier {
 public:
  void take(const SessionReader::Message& message) {
    if (message.topic.latched) messages_.emplace_back(message.topic, message.cdr);
  }

  /// Writes them with the part's first stamp.
  Problems write(SessionWriter& writer, ros::Stamp_ns stamp) {
    for (const auto& [topic, cdr] : std::exchange(messages_, {})) {
      if (Problems problems = writer.write(topic, stamp, cdr); !problems.empty()) return problems;
    }
    return {};
  }

 private:
  std::vector<std::pair<SessionTopic, std::string>> messages_;
};

Result<std::int64_t> copy_part(SessionReader& reader, const Part& part, SessionWriter& writer,
                               std::int64_t total, Progress& progress) {
  Earlier earlier;
  std::int64_t copied = 0;
  for (std::int64_t seen = 0;; ++seen) {
    progress.report("cutting", static_cast<std::size_t>(seen), static_cast<std::size_t>(total));
    const auto message = reader.next();
    if (!message) return message.problems();
    if (!message->has_value() || (*message)->stamp > part.to) return copied;
    if ((*message)->stamp < part.from) {
      earlier.take(**message);
      continue;
    }
    const auto& [topic, stamp, cdr] = **message;
    if (Problems problems = earlier.write(writer, stamp); !problems.empty()) return problems;
    if (Problems problems = writer.write(topic, stamp, cdr); !problems.empty()) return problems;
    ++copied;
  }
}

Problems check(const SessionCutOptions& options) {
  if (options.to_s && *options.to_s < options.from_s)
    return {{{"--to"}, fmt::format("{:g} s is before --from, {:g} s", *options.to_s, options.from_s)}};
  std::error_code error;
  if (fs::equivalent(options.session, options.out, error))
    return {{{options.out.string()}, "is the session that is to be cut"}};
  return {};
}

Problem nothing_in(const SessionCutOptions& options, const SessionSummary& summary) {
  return {{options.session.string()},
          fmt::format("has no message in that part; it lasts {:.3f} s", summary.duration_s())};
}

}  // namespace

Result<Outcome> run_session_cut(const SessionCutOptions& options, Console& console) {
  if (Problems problems = check(options); !problems.empty()) return problems;
  const auto summary = summarise_session(options.session);
  if (!summary) return summary.problems();
  auto reader = SessionReader::open(options.session);
  if (!reader) return reader.problems();
  if (options.from_s > summary->duration_s()) return nothing_in(options, *summary);
  auto writer = SessionWriter::create(options.out, options.force, options.storage);
  if (!writer) return writer.problems();

  NewSession cut(std::move(*writer));
  const auto copied =
      copy_part(*reader, part_of(*summary, options), cut.writer(), summary->messages, console.progress);
  if (!copied) return copied.problems();
  if (*copied == 0) return nothing_in(options, *summary);
  if (Problems problems = cut.finish(); !problems.empty()) return problems;

  Outcome outcome{.verb = "cut"};
  outcome.files["session"] = options.out.string();
  outcome.figures = {{"messages", *copied}, {"of_messages", summary->messages}};
  outcome.text = fmt::format("{} of {} messages in {}\n", *copied, summary->messages, options.out.string());
  return outcome;
}

}  // namespace aisle
