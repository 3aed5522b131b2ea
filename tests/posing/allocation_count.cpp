// SPDX-License-Identifier: MIT
#include "posing/allocation_count.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CROQUIS_OWN_MALLOC 0
#endif
#endif
#if !defined(CROQUIS_OWN_MALLOC)
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define CROQUIS_OWN_MALLOC 1
#else
#define CROQUIS_OWN_MALLOC 0
#endif
#endif

#if CROQUIS_OWN_MALLOC

namespace {
std::atomic<long> count{0};
}

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
void* realloc(void* memory, std::size_t size) {
  ++count;
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++count;
  return __libc_memalign(alignment, size);
}
}

namespace croquis {
long allocations_so_far() { return count; }
}  // namespace croquis

#else

namespace croquis {
long allocations_so_far() { return -1; }
}  // namespace croquis

#endif
