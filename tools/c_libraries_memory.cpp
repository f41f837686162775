#include "tools/c_libraries_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <libxml/xmlmemory.h>

#include "wavecurve/certified/flint.hpp"

#include "tools/out_of_memory.hpp"

namespace wavecurve::tools {

namespace {

void* given(void* memory) noexcept {
  if (memory == nullptr) end_out_of_memory();
  return memory;
}

// No request is for nothing, for which malloc may return a null pointer without any want.
void* allocate(std::size_t size) noexcept {
  return given(std::malloc(std::max(size, std::size_t{1})));
}

void* allocate_zeros(std::size_t count, std::size_t size) noexcept {
  return given(std::calloc(std::max(count, std::size_t{1}), std::max(size, std::size_t{1})));
}

void* reallocate(void* old, std::size_t size) noexcept {
  return given(std::realloc(old, std::max(size, std::size_t{1})));
}

void* reallocate_sized(void* old, std::size_t /*old_size*/, std::size_t size) noexcept {
  return reallocate(old, size);
}

void release(void* memory) noexcept { std::free(memory); }

void release_sized(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

char* copy_text(const char* text) noexcept {
  const std::size_t size = std::strlen(text) + 1;
  return static_cast<char*>(std::memcpy(allocate(size), text, size));
}

}  // namespace

void end_where_c_libraries_lack_memory() {
  mp_set_memory_functions(allocate, reallocate_sized, release_sized);
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, release);
  xmlMemSetup(release, allocate, reallocate, copy_text);
}

}  // namespace wavecurve::tools
