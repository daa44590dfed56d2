#include "mission_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <optional>
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
      : missions_(missions),
        journal_(std::move(journal)),
        console_(console),
        only_(options.only),
        jobs_(static_cast<std::size_t>(options.jobs > 0 ? options.jobs : jobs_by_default(options.process))) {
    for (std::size_t mission = 0; mission < missions_.count; ++mission) {
      if (is_wanted(missions_.name(mission))) waiting_.push_back(mission);
    }
    wanted_ = waiting_.size();
  }

  Problems run() {
    if (wanted_ == 0)
      return {
          {{"--only"},
           fmt::format("is none of this trial's missions, the first of which is '{}'", missions_.name(0))}};
    if (journal_.kept() > 0)
      console_.warn(fmt::format("{}: {} missions were run before{}", journal_.path().string(),
                                journal_.kept(),
                                journal_.is_of_another_build() ? ", by another build of the program" : ""));
    try {
      while (!waiting_.empty() || busy() > 0) {
        if (Problems problems = hand_out(); !problems.empty()) return problems;
        if (Problems problems = listen(); !problems.empty()) return problems;
      }
    } catch (const Interrupted&) {
      was_interrupted_ = true;
    }
    return {};
  }

  TrialRecords records() const {
    TrialRecords records{.records = {}, .failed = {}, .died = {}, .wanted = wanted_};
    records.was_interrupted = was_interrupted_;
    for (std::size_t mission = 0; mission < missions_.count; ++mission) {
      const std::string name = missions_.name(mission);
      if (!is_wanted(name)) continue;
      if (const auto record = journal_.records().find(name); record != journal_.records().end()) {
        if (!record->second.value("ok", false)) records.failed.push_back(name);
        records.records.emplace_back(name, record->second);
      } else if (const auto death = journal_.deaths().find(name); death != journal_.deaths().end()) {
        records.died.push_back(fmt::format("{}: {}", name, death->second));
      }
    }
    return records;
  }

 private:
  /// Processes that share a trial share the machine, too.
  static int jobs_by_default(const TrialProcess& process) { return process.count > 1 ? 1 : usable_cores(); }

  bool is_wanted(const std::string& name) const { return only_.empty() || name == only_; }

  std::size_t busy() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(),
                      [](const MissionWorker& worker) { return worker.mission().has_value(); }));
  }

  /// Claims the first mission that waits and that no other process runs. What others run keeps waiting: they
  /// may die.
  Result<std::optional<std::size_t>> claim_next() {
    for (std::size_t tried = waiting_.size(); tried > 0; --tried) {
      const std::size_t mission = waiting_.front();
      waiting_.pop_front();
      const auto claim = journal_.claim(missions_.name(mission));
      if (!claim) return claim.problems();
      if (*claim == MissionClaim::kGranted) return std::optional(mission);
      if (*claim == MissionClaim::kRefused) waiting_.push_back(mission);
    }
    return std::optional<std::size_t>();
  }

  /// Gives each worker that waits a mission, and starts workers as long as there are missions for them.
  Problems hand_out() {
    const auto is_free = [](const MissionWorker& worker) { return !worker.mission(); };
    while (true) {
      auto worker = std::find_if(workers_.begin(), workers_.end(), is_free);
      if (worker == workers_.end() && workers_.size() >= jobs_) return {};
      const auto mission = claim_next();
      if (!mission) return mission.problems();
      if (!*mission) return {};
      if (worker == workers_.end()) {
        auto started = MissionWorker::start(missions_);
        if (!started) return started.problems();
        worker = workers_.insert(worker, std::move(*started));
      }
      worker->begin(**mission);
    }
  }

  /// Until a worker says something, or for kLook_ms.
  Problems listen() {
    std::vector<pollfd> descriptors;
    descriptors.reserve(workers_.size());
    for (const MissionWorker& worker : workers_) descriptors.push_back({worker.descriptor(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), kLook_ms);
    console_.progress.report(label(), wanted_ - waiting_.size() - busy(), wanted_);
    for (MissionWorker& worker : workers_) {
      const std::optional<std::size_t> mission = worker.mission();
      const std::optional<WorkerAnswer> end = worker.take(console_);
      if (!end || !mission) continue;
      if (Problems problems = keep(*mission, *end); !problems.empty()) return problems;
    }
    std::erase_if(workers_, [](const MissionWorker& worker) { return worker.is_dead(); });
    return {};
  }

  /// What the progress is called: with the last mission that did not go well.
  std::string label() const {
    return last_bad_.empty() ? "missions" : fmt::format("missions ({} failed)", last_bad_);
  }

  Problems keep(std::size_t mission, const WorkerAnswer& end) {
    if (!end.problems.empty()) return end.problems;
    const std::string name = missions_.name(mission);
    if (!end.died_of.empty() || !end.record.value("ok", false)) last_bad_ = name;
    return end.died_of.empty() ? journal_.add(name, end.record) : journal_.add_death(name, end.died_of);
  }

  const TrialMissions& missions_;
  TrialJournal journal_;
  Console& console_;
  std::string only_;  ///< name of the one wanted; empty: all are
  std::size_t jobs_;
  std::vector<MissionWorker> workers_;
  std::deque<std::size_t> waiting_;  ///< missions that have not ended and that do not run here
  std::size_t wanted_ = 0;
  std::string last_bad_;
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
  if (options.process.count > 1 && options.out.empty())
    return Problem{{"--out"},
                   fmt::format("is missing: the {} processes of this trial share its missions through "
                               "a directory that all of them reach",
                               options.process.count)};
  if (options.process.count > 1 && options.force)
    return Problem{{"--force"},
                   "would let each process of this trial throw away what the others have run: "
                   "remove the missions before"};
  auto journal = TrialJournal::open(options);
  if (!journal) return journal.problems();
  MissionRuns runs(options, missions, std::move(*journal), console);
  if (Problems problems = runs.run(); !problems.empty()) return problems;
  return runs.records();
}

void TrialRecords::report(const TrialOptions& options, Outcome& outcome) const {
  if (!died.empty()) outcome.figures["died"] = died;
  if (was_interrupted) outcome.figures["interrupted"] = true;
  outcome.ok = outcome.ok && died.empty() && !was_interrupted;
  if (!options.out.empty()) outcome.files["missions"] = (options.out / "missions.jsonl").string();
  for (const std::string& one : died) outcome.text += fmt::format("died: {}\n", one);
  if (!failed.empty())
    outcome.text += fmt::format("failed: {}; the first again: aisle trial {} --seeds {}..{} --only '{}'\n",
                                fmt::join(failed, ", "), fmt::join(options.words, " "), options.first_seed,
                                options.last_seed, failed.front());
  if (was_interrupted)
    outcome.text += fmt::format("interrupted: {} of {} missions ended{}\n", records.size(), wanted,
                                options.out.empty() ? "" : "; the same command goes on from there");
}

}  // namespace aisle
