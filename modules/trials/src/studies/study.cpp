#include "aisle/trials/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "recorded_trial.hpp"
#include "studies/significance.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMoreThanChance = 0.05;
constexpr const char* kWentWell = "went_well";

/// One figure of a variant's missions, by their names.
using Values = std::map<std::string, double>;

struct VariantRun {
  std::string name;
  std::map<std::string, Json> records;
  std::size_t not_taught = 0;

  std::size_t missions() const { return records.size(); }
};

/// A variant against the first one, in one figure.
struct Comparison {
  std::size_t variant = 0;
  std::string figure;
  std::vector<double> differences;  ///< of the missions that both have
  double p = 1;
  double p_adjusted = 1;

  bool is_more_than_chance() const { return p_adjusted < kMoreThanChance; }
};

/// The part of a record that holds its figures: the last drive's, where a mission has several.
const Json& figures_in(const Json& record) {
  if (record.contains("drives") && !record["drives"].empty()) return figures_in(record["drives"].back());
  return record.contains("run") ? record["run"] : record;
}

/// "localisation.lateral_m" or a plain key.
std::optional<double> figure_of(const Json& record, const std::string& figure) {
  if (figure == kWentWell) return record.value("ok", false) ? 1 : 0;
  const Json* at = &figures_in(record);
  for (std::size_t begin = 0; begin <= figure.size();) {
    const std::size_t dot = std::min(figure.find('.', begin), figure.size());
    const std::string key = figure.substr(begin, dot - begin);
    if (!at->is_object() || !at->contains(key)) return std::nullopt;
    at = &(*at)[key];
    begin = dot + 1;
  }
  if (at->is_boolean()) return at->get<bool>() ? 1 : 0;
  return at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
}

void add_figure_names(const Json& json, const std::string& prefix, std::set<std::string>& names) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) add_figure_names(value, prefix + key + ".", names);
    if (value.is_number() || value.is_boolean()) names.insert(prefix + key);
  }
}

Values values_of(const VariantRun& run, const std::string& figure) {
  Values values;
  for (const auto& [mission, record] : run.records) {
    if (const auto value = figure_of(record, figure)) values.emplace(mission, *value);
  }
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double chance_of(const std::string& figure, const std::vector<double>& differences) {
  if (figure != kWentWell) return sign_flip_p(differences);
  const auto differing = [&](double by) {
    return static_cast<std::size_t>(std::count(differences.begin(), differences.end(), by));
  };
  return mcnemar_p(differing(-1), differing(1));
}

Comparison compared(const std::vector<VariantRun>& runs, std::size_t variant, const std::string& figure) {
  Comparison comparison{.variant = variant, .figure = figure, .differences = {}};
  const Values first = values_of(runs.front(), figure), present = values_of(runs[variant], figure);
  for (const auto& [mission, value] : present) {
    if (const auto other = first.find(mission); other != first.end())
      comparison.differences.push_back(value - other->second);
  }
  comparison.p = chance_of(figure, comparison.differences);
  return comparison;
}

std::vector<Comparison> compare_all(const std::vector<VariantRun>& runs,
                                    const std::vector<std::string>& figures) {
  std::vector<Comparison> comparisons;
  std::vector<double> p;
  for (std::size_t variant = 1; variant < runs.size(); ++variant) {
    for (const std::string& figure : figures) {
      comparisons.push_back(compared(runs, variant, figure));
      p.push_back(comparisons.back().p);
    }
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].p_adjusted = adjusted[i];
  return comparisons;
}

Json json_of(const Confidence& interval) {
  return {rounded(interval.low, 5), rounded(interval.high, 5)};
}

Json json_of(const Comparison& comparison) {
  return {{"missions_in_both", comparison.differences.size()},
          {"mean_difference", rounded(mean_of(comparison.differences), 6)},
          {"interval_95", json_of(bootstrap_interval(comparison.differences))},
          {"p", rounded(comparison.p, 5)},
          {"p_adjusted", rounded(comparison.p_adjusted, 5)},
          {"more_than_chance", comparison.is_more_than_chance()}};
}

std::size_t well_in(const VariantRun& run) {
  return static_cast<std::size_t>(
      std::count_if(run.records.begin(), run.records.end(),
                    [](const auto& mission) { return mission.second.value("ok", false); }));
}

Json json_of(const VariantRun& run, const std::vector<std::string>& figures) {
  Json json = {{"name", run.name},
               {"missions", run.missions()},
               {"not_taught", run.not_taught},
               {"went_well", well_in(run)},
               {"share_interval_95", json_of(wilson_interval(well_in(run), run.missions()))}};
  for (const std::string& figure : figures) {
    if (figure == kWentWell) continue;
    std::vector<double> values;
    for (const auto& [mission, value] : values_of(run, figure)) values.push_back(value);
    json["figures"][figure] = {{"missions", values.size()},
                               {"mean", rounded(mean_of(values), 6)},
                               {"interval_95", json_of(bootstrap_interval(values))}};
  }
  return json;
}

std::string text_of(const VariantRun& run, const Json& json) {
  const Confidence share = wilson_interval(well_in(run), run.missions());
  std::string text = fmt::format("{}: {} of {} went well ({:.0f} to {:.0f} %)\n", run.name, well_in(run),
                                 run.missions(), 100 * share.low, 100 * share.high);
  if (run.not_taught > 0) text += fmt::format("  {} could not be taught\n", run.not_taught);
  const Json figures = json.value("figures", Json::object());
  for (const auto& [figure, value] : figures.items())
    text += fmt::format("  {}: {:.4g} ({:.4g} to {:.4g})\n", figure, value["mean"].get<double>(),
                        value["interval_95"][0].get<double>(), value["interval_95"][1].get<double>());
  return text;
}

std::string text_of(const Comparison& comparison) {
  return fmt::format("  {} against the first: {:+.4g}, p = {:.3g}: {}\n", comparison.figure,
                     mean_of(comparison.differences), comparison.p_adjusted,
                     comparison.is_more_than_chance() ? "more than chance" : "may be chance");
}

/// A figure that no mission of any variant has.
Problems check_figures(const std::vector<VariantRun>& runs, const std::vector<std::string>& figures) {
  std::set<std::string> known;
  for (const VariantRun& run : runs) {
    for (const auto& [mission, record] : run.records) add_figure_names(figures_in(record), "", known);
  }
  Problems problems;
  for (const std::string& figure : figures) {
    if (figure != kWentWell && !known.contains(figure))
      problems.push_back(
          {{"figures"}, fmt::format("'{}' is in no mission: there are {}", figure, fmt::join(known, ", "))});
  }
  return problems;
}

/// Missions whose route could not be taught say nothing of the variant.
VariantRun variant_run(const std::string& name, const TrialRecords& ran) {
  VariantRun run{.name = name, .records = {}};
  for (const auto& [mission, record] : ran.records) {
    if (record.contains("not_taught"))
      ++run.not_taught;
    else
      run.records.emplace(mission, record);
  }
  return run;
}

Outcome outcome_of(const Study& study, const std::vector<VariantRun>& runs,
                   const std::vector<std::string>& figures) {
  const std::vector<Comparison> comparisons = compare_all(runs, figures);
  Outcome outcome{.verb = "study"};
  outcome.figures = {{"simulated", true}, {"trial", study.trial}, {"seeds", study.seeds}};
  outcome.text =
      fmt::format("simulated: aisle trial {} --seeds {}, with 95 % intervals\n", study.trial, study.seeds);
  for (std::size_t variant = 0; variant < runs.size(); ++variant) {
    Json json = json_of(runs[variant], figures);
    outcome.text += text_of(runs[variant], json);
    for (const Comparison& comparison : comparisons) {
      if (comparison.variant != variant) continue;
      json["against_first"][comparison.figure] = json_of(comparison);
      outcome.text += text_of(comparison);
    }
    outcome.figures["variants"].push_back(std::move(json));
  }
  return outcome;
}

}  // namespace

Result<Outcome> run_study(const StudyOptions& options, Console& console) {
  std::vector<VariantRun> runs;
  std::vector<std::string> unfinished;
  for (std::size_t i = 0; i < options.trials.size(); ++i) {
    const std::string& name = options.study.variants[i].name;
    const auto ran = run_recorded_trial(options.trials[i], console);
    if (!ran) return ran.problems();
    if (ran->records.was_interrupted) throw Interrupted();
    if (ran->records.records.size() < ran->records.wanted) unfinished.push_back(name);
    runs.push_back(variant_run(name, ran->records));
  }
  if (!options.trials.front().process.is_first())
    return Outcome{.verb = "study", .is_printed_elsewhere = true};
  std::vector<std::string> figures = {kWentWell};
  figures.insert(figures.end(), options.study.figures.begin(), options.study.figures.end());
  if (Problems problems = check_figures(runs, figures); !problems.empty()) return problems;
  Outcome outcome = outcome_of(options.study, runs, figures);
  outcome.ok = unfinished.empty();
  if (!unfinished.empty()) {
    outcome.figures["unfinished"] = unfinished;
    outcome.text += fmt::format("not all missions ended in: {}; the same command tries these again\n",
                                fmt::join(unfinished, ", "));
  }
  return outcome;
}

}  // namespace aisle
