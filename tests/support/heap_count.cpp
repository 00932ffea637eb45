#include "tests/support/heap_count.h"

#include <atomic>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__clang__)
#define ROVER_HEAP_OF_ITS_OWN 1
#endif

namespace {

std::atomic<long> asked{0};

}  // namespace

#ifndef ROVER_HEAP_OF_ITS_OWN

// What glibc calls its own.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

// In place of the C library's, for the whole program.
void* malloc(std::size_t size) {
    ++asked;
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    ++asked;
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    ++asked;
    return __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++asked;
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    ++asked;
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? 12 : 0;  // ENOMEM
}
}

#endif

namespace testsupport {

long heapCount() {
    return asked;
}

bool heapIsCounted() {
#ifdef ROVER_HEAP_OF_ITS_OWN
    return false;
#else
    return true;
#endif
}

}  // namespace testsupport
