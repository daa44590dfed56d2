#pragma once

#include <functional>

#include "aisle/trials/trial_options.hpp"
#include "verb.hpp"

/// The verb `trial`, whose options go to `chosen` instead of being run.
void add_trial_verb(CLI::App& app, Work& work, const std::function<void(const aisle::TrialOptions&)>& chosen);

/// --jobs of verbs that run missions.
const CLI::Option* add_jobs(CLI::App& verb, int& jobs);
