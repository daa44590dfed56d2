#pragma once
/// For loops over the lanes of a packet, written for the compiler to turn into vector instructions. Both
/// versions of a kernel give the same bits, as nothing is contracted or reordered.

#ifdef __clang__  // Callers in other sources do not find the versions that clang 14 makes.
#define AISLE_KERNEL
#else
#define AISLE_KERNEL __attribute__((target_clones("avx2", "default")))
#endif
#define AISLE_INLINE [[gnu::always_inline]] inline
