#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "aisle/formats/study_file.hpp"
#include "aisle/trials/study.hpp"
#include "examples.hpp"
#include "trial_verb.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

/// What all variants of a study have in common.
struct StudyChoices {
  std::filesystem::path file;
  std::filesystem::path out;
  int jobs = 0;
  bool force = false;
};

/// The trial that a command line asks for. Problem: it asks for none.
Result<TrialOptions> trial_of(const Study& study, const StudyVariant& variant, const StudyChoices& choices) {
  CLI::App app("", "aisle");
  Work no_work;
  std::optional<TrialOptions> trial;
  add_trial_verb(app, no_work, [&](const TrialOptions& options) { trial = options; });
  try {
    app.parse(fmt::format("trial {} {} --seeds {}", study.trial, variant.words, study.seeds));
  } catch (const CLI::ParseError& error) {
    return Problem{{choices.file.string(), 0, variant.name}, error.what()};
  }
  if (!trial) return Problem{{choices.file.string(), 0, variant.name}, "is no trial that can be run"};
  if (!trial->out.empty() || trial->jobs != 0 || trial->force)
    return Problem{{choices.file.string(), 0, variant.name},
                   "has --out, --jobs or --force, which are the study's"};
  trial->out = choices.out / directory_of(variant);
  trial->jobs = choices.jobs;
  trial->force = choices.force;
  return std::move(*trial);
}

Result<Outcome> run_study_file(const StudyChoices& choices, Console& console) {
  auto study = read_study(choices.file);
  if (!study) return study.problems();
  StudyOptions options{.study = std::move(*study), .trials = {}};
  Problems problems;
  for (const StudyVariant& variant : options.study.variants) {
    auto trial = trial_of(options.study, variant, choices);
    if (trial)
      options.trials.push_back(std::move(*trial));
    else
      problems.insert(problems.end(), trial.problems().begin(), trial.problems().end());
  }
  if (!problems.empty()) return problems;
  return run_study(options, console);
}

}  // namespace

void add_study_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "study", "run a trial in several variants and say whether they differ by more than chance");
  verb->fallthrough();
  add_examples(*verb, {"aisle study speeds.yaml --out out/speeds"});
  auto choices = std::make_shared<StudyChoices>();
  verb->add_option("FILE", choices->file, "study file (YAML): the trial, its seeds, and its variants")
      ->required();
  verb->add_option(
          "-o,--out", choices->out,
          "directory that keeps each variant's missions as they end; the same command goes on from there")
      ->required();
  add_jobs(*verb, choices->jobs);
  verb->add_flag("--force", choices->force, "replace the missions that --out holds");
  verb->callback(
      [=, &work] { work = [choices](Console& console) { return run_study_file(*choices, console); }; });
}
