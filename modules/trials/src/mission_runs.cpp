#include "mission_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "mission_worker.hpp"
#include "trial_journal.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLook_ms = 100;  // between two looks at the progress, which may interrupt

class MissionRuns {
 public:
  MissionRuns(const TrialOptions& options, const TrialMissions& missions, TrialJournal journal,
              Console& console)
      : missions_(missions), journal_(std::move(journal)), console_(console) {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    jobs_ = options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : cores;
  }

  Problems run() {
    take_kept();
    try {
      while (next_mission() || is_any_busy()) {
        if (Problems problems = hand_out(); !problems.empty()) return problems;
        if (Problems problems = wait(); !problems.empty()) return problems;
      }
    } catch (const Interrupted&) {
      was_interrupted_ = true;
    }
    return {};
  }

  TrialRecords records() && {
    TrialRecords records{.records = {}, .failed = {}, .died = std::move(died_), .wanted = missions_.count};
    records.was_interrupted = was_interrupted_;
    records.records.reserve(records_.size());
    for (auto& [mission, record] : records_) {
      if (!record.value("ok", false)) records.failed.push_back(missions_.name(mission));
      records.records.push_back(std::move(record));
    }
    return records;
  }

 private:
  void take_kept() {
    for (std::size_t mission = 0; mission < missions_.count; ++mission) {
      const auto kept = journal_.kept().find(missions_.name(mission));
      if (kept != journal_.kept().end()) records_.emplace(mission, kept->second);
    }
    if (records_.empty()) return;
    console_.warn(fmt::format("{}: {} missions were run before{}", journal_.path().string(), records_.size(),
                              journal_.is_of_another_build() ? ", by another build of the program" : ""));
  }

  /// The next that was not run before.
  std::optional<std::size_t> next_mission() {
    while (next_ < missions_.count && records_.contains(next_)) ++next_;
    return next_ < missions_.count ? std::optional(next_) : std::nullopt;
  }

  bool is_any_busy() const {
    return std::any_of(workers_.begin(), workers_.end(),
                       [](const MissionWorker& worker) { return worker.mission().has_value(); });
  }

  /// Gives each worker that waits a mission, and starts workers as long as there are missions for them.
  Problems hand_out() {
    for (MissionWorker& worker : workers_) {
      if (!worker.mission() && next_mission()) worker.begin(next_++);
    }
    while (workers_.size() < jobs_ && next_mission()) {
      auto worker = MissionWorker::start(missions_);
      if (!worker) return worker.problems();
      worker->begin(next_++);
      workers_.push_back(std::move(*worker));
    }
    return {};
  }

  /// Until a worker says something, or for kLook_ms.
  Problems wait() {
    std::vector<pollfd> descriptors;
    descriptors.reserve(workers_.size());
    for (const MissionWorker& worker : workers_) descriptors.push_back({worker.descriptor(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), kLook_ms);
    console_.progress.report("missions", records_.size() + died_.size(), missions_.count);
    for (MissionWorker& worker : workers_) {
      const std::optional<std::size_t> mission = worker.mission();
      const std::optional<WorkerAnswer> end = worker.take(console_);
      if (!end || !mission) continue;
      if (Problems problems = keep(*mission, *end); !problems.empty()) return problems;
    }
    std::erase_if(workers_, [](const MissionWorker& worker) { return worker.is_dead(); });
    return {};
  }

  Problems keep(std::size_t mission, const WorkerAnswer& end) {
    if (!end.problems.empty()) return end.problems;
    const std::string name = missions_.name(mission);
    if (!end.died_of.empty()) {
      died_.push_back(fmt::format("{}: {}", name, end.died_of));
      return {};
    }
    records_.emplace(mission, end.record);
    return journal_.add(name, end.record);
  }

  const TrialMissions& missions_;
  TrialJournal journal_;
  Console& console_;
  std::size_t jobs_ = 1;
  std::vector<MissionWorker> workers_;
  std::size_t next_ = 0;
  std::map<std::size_t, Json> records_;
  std::vector<std::string> died_;
  bool was_interrupted_ = false;
};

}  // namespace

TrialMissions per_seed(const TrialOptions& options,
                       std::function<Result<nlohmann::ordered_json>(std::uint64_t seed, Console&)> run) {
  const std::uint64_t first = options.first_seed;
  return {.count = options.seeds(),
          .name = [first](std::size_t mission) { return fmt::format("seed {}", first + mission); },
          .run = [first, run = std::move(run)](std::size_t mission,
                                               Console& console) { return run(first + mission, console); }};
}

Result<TrialRecords> run_missions(const TrialOptions& options, const TrialMissions& missions,
                                  Console& console) {
  auto journal = TrialJournal::open(options);
  if (!journal) return journal.problems();
  MissionRuns runs(options, missions, std::move(*journal), console);
  if (Problems problems = runs.run(); !problems.empty()) return problems;
  return std::move(runs).records();
}

void TrialRecords::report(const TrialOptions& options, Outcome& outcome) const {
  if (!died.empty()) outcome.figures["died"] = died;
  if (was_interrupted) outcome.figures["interrupted"] = true;
  outcome.ok = outcome.ok && died.empty() && !was_interrupted;
  if (!options.out.empty()) outcome.files["missions"] = (options.out / "missions.jsonl").string();
  for (const std::string& one : died) outcome.text += fmt::format("died: {}\n", one);
  if (!failed.empty())
    outcome.text += fmt::format("failed: {}; one again: aisle trial {} --seeds SEED\n",
                                fmt::join(failed, ", "), fmt::join(options.words, " "));
  if (was_interrupted)
    outcome.text += fmt::format("interrupted: {} of {} missions ended{}\n", records.size(), wanted,
                                options.out.empty() ? "" : "; the same command goes on from there");
}

}  // namespace aisle
