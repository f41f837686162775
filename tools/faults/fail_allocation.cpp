// A library to be preloaded (LD_PRELOAD) that refuses memory to a program, as a full machine would.
//
//   FAIL_ALLOCATION=N     refuses request number N, counted from 1 over all threads
//   FAIL_ALLOCATION=N+    refuses it and all after it
//   COUNT_ALLOCATIONS=F   writes the number of requests into the file F when the program ends
//
// Requests are calls of malloc, calloc, realloc, aligned_alloc, memalign and posix_memalign from the
// time on when this library is initialised; they are passed on to the functions of glibc that stand
// behind these. Programs that the program starts are left alone.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
// glibc's own, by the names that it keeps for libraries like this one.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

std::atomic<bool> counts = false;
std::atomic<unsigned long> requests = 0;
unsigned long first_refused = 0;
bool refuses_all_after = false;
const char* count_file = nullptr;

bool is_refused() {
  if (!counts) return false;
  const unsigned long request = ++requests;
  const bool refused = first_refused > 0 &&
                       (refuses_all_after ? request >= first_refused : request == first_refused);
  if (refused) errno = ENOMEM;
  return refused;
}

__attribute__((constructor)) void start() {
  if (const char* text = std::getenv("FAIL_ALLOCATION")) {
    char* end = nullptr;
    first_refused = std::strtoul(text, &end, 10);
    refuses_all_after = std::strcmp(end, "+") == 0;
  }
  count_file = std::getenv("COUNT_ALLOCATIONS");
  unsetenv("LD_PRELOAD");
  counts = true;
}

__attribute__((destructor)) void finish() {
  counts = false;
  if (count_file == nullptr) return;
  if (std::FILE* file = std::fopen(count_file, "w")) {
    std::fprintf(file, "%lu\n", requests.load());
    std::fclose(file);
  }
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return is_refused() ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t count, std::size_t size) {
  return is_refused() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  return is_refused() ? nullptr : __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return is_refused() ? nullptr : __libc_memalign(alignment, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  return is_refused() ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  if (is_refused()) return ENOMEM;
  void* const memory = __libc_memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *result = memory;
  return 0;
}
}
