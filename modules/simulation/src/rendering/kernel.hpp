#pragma once
/// For loops over the lanes of a packet, written for the compiler to turn into vector instructions. Both
/// versions of a kernel give the same bits, as nothing is contracted or reordered.

#define AISLE_KERNEL __attribute__((target_clones("avx2", "default")))
#define AISLE_INLINE [[gnu::always_inline]] inline
