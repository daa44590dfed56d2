#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

/// The work that the command line asks for; the verb's parser sets it.
using Work = std::function<aisle::Result<aisle::Outcome>(aisle::Console&)>;

void add_compare_verb(CLI::App& app, Work& work);
void add_connect_verb(CLI::App& app, Work& work);
void add_convert_verb(CLI::App& app, Work& work);
void add_localise_verb(CLI::App& app, Work& work);
void add_map_verb(CLI::App& app, Work& work);
void add_sim_verb(CLI::App& app, Work& work);
void add_maze_verb(CLI::App& app, Work& work);
void add_merge_verbs(CLI::App& app, Work& work);
void add_session_verbs(CLI::App& app, Work& work);
void add_detect_verb(CLI::App& app, Work& work);
void add_calibrate_verb(CLI::App& app, Work& work);
void add_doctor_verb(CLI::App& app, Work& work);
void add_drive_verb(CLI::App& app, Work& work);
void add_explore_verb(CLI::App& app, Work& work);
void add_fleet_verb(CLI::App& app, Work& work);
void add_guide_verbs(CLI::App& app, Work& work);
void add_import_verb(CLI::App& app, Work& work);
void add_learning_verbs(CLI::App& app, Work& work);
void add_live_verb(CLI::App& app, Work& work);
void add_park_verb(CLI::App& app, Work& work);
void add_reproduce_verb(CLI::App& app, Work& work);
void add_show_verbs(CLI::App& app, Work& work);
void add_study_verb(CLI::App& app, Work& work);
void add_trial_verb(CLI::App& app, Work& work);

/// The verbs below `aisle sim`.
void add_sim_log_verb(CLI::App& sim, Work& work);
void add_sim_render_verb(CLI::App& sim, Work& work);
void add_sim_show_verb(CLI::App& sim, Work& work);

/// Adds --params, --set and --print-params to a verb. `chosen` runs when the verb is used without
/// --print-params.
void add_parameter_options(CLI::App& verb, aisle::ParameterSources& sources, aisle::Outcome (*list)(),
                           Work& work, const std::function<void()>& chosen);
