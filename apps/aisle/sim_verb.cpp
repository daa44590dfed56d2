#include "examples.hpp"
#include "verb.hpp"

void add_sim_verb(CLI::App& app, Work& work) {
  CLI::App* sim = app.add_subcommand("sim", "show worlds and simulate sensors");
  sim->require_subcommand(1);
  sim->fallthrough();
  add_sim_log_verb(*sim, work);
  add_sim_render_verb(*sim, work);
  add_sim_show_verb(*sim, work);
  add_examples(*sim,
               {"aisle sim show small-office --svg plan.svg", "aisle sim render small-office -o view.png"});
}
