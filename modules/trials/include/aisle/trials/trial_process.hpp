#pragma once

#include <cstddef>

namespace aisle {

/// One of several processes that were started together to run one trial: by `mpirun`, or by `srun`.
struct TrialProcess {
  std::size_t rank = 0;   ///< 0 prints the outcome
  std::size_t count = 1;  ///< 1: this process is alone

  bool is_first() const { return rank == 0; }
};

/// What the starter says in the environment of its processes (Open MPI, PMI, Slurm).
TrialProcess trial_process_from_environment();

/// Cores that this process may run on; at least 1.
int usable_cores();

}  // namespace aisle
