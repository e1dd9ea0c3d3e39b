#pragma once

// LOOKOUT_VECTOR_CLONES before a function makes one more copy of it for processors with 256-bit vectors,
// chosen when the program is loaded. It has no fused multiply-add, so both copies give the same bits.
// Sanitizers do not bear such functions.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LOOKOUT_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define LOOKOUT_VECTOR_CLONES
#endif
