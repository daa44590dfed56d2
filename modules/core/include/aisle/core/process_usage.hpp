#pragma once

namespace aisle {

/// Processor time of this process so far, user and system [s].
double process_cpu_s();

/// Processor time of the calling thread so far, user and system [s].
double thread_cpu_s();

/// Peak memory (resident set size) of this process so far [MB, 10^6 bytes].
double process_peak_rss_mb();

}  // namespace aisle
