#include "aisle/commands/doctor.hpp"
#include "verb.hpp"

using namespace aisle;

void add_doctor_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("doctor", "check this machine, and say what is missing and what to do about it");
  verb->fallthrough();
  add_examples(*verb, {"aisle doctor", "aisle doctor --json"});
  verb->callback([&work] { work = [](Console&) { return run_doctor(); }; });
}
