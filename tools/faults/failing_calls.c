/* A library to be loaded before all others (LD_PRELOAD): the n-th call of a kind fails.
 *
 *   FAULT_CALL     the kind, a name of `kinds` below; a shared implementation serves its variants
 *   FAULT_AT       which call of the kind fails, 1 the first; 0 none
 *   FAULT_ERROR    errno of the failure
 *   FAULT_PROGRAM  only in programs of this name; the programs that they start go untouched
 *   FAULT_NO_EXCHANGE  if set, renameat2 knows no RENAME_EXCHANGE, as on some file systems
 *   FAULT_COUNTS   file that gets a line "KIND COUNT" for each kind when the program ends
 *
 * "short" is a write of half of the bytes. What the C library does within itself is not seen.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum kind {
  k_write, k_short, k_fsync, k_rename, k_open, k_close, k_fchmod, k_chmod, k_mkstemp, k_mkdtemp,
  k_fopen, k_tmpfile, k_read, k_spawn, k_ftruncate, k_unlink, k_mkdir, k_link, k_pipe, k_socketpair,
  k_thread, kind_count
};

static const char* const kinds[kind_count] = {
    "write",   "short",     "fsync",  "rename", "open", "close", "fchmod", "chmod",     "mkstemp", "mkdtemp", "fopen",
    "tmpfile", "read",      "spawn",  "ftruncate", "unlink", "mkdir", "link", "pipe", "socketpair", "thread"};

static atomic_long counts[kind_count];
static int armed, chosen = -1, error;
static long at;

__attribute__((constructor)) static void begin(void) {
  const char* const program = getenv("FAULT_PROGRAM");
  if (program && strcmp(program, program_invocation_short_name) != 0) return;
  const char* const call = getenv("FAULT_CALL");
  for (int kind = 0; call && kind < kind_count; ++kind) {
    if (strcmp(call, kinds[kind]) == 0) chosen = kind;
  }
  at = getenv("FAULT_AT") ? atol(getenv("FAULT_AT")) : 0;
  error = getenv("FAULT_ERROR") ? atoi(getenv("FAULT_ERROR")) : EIO;
  armed = 1;
}

__attribute__((destructor)) static void end(void) {
  const char* const path = getenv("FAULT_COUNTS");
  if (!armed || !path) return;
  armed = 0;
  const int file = (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND, 0644);
  for (int kind = 0; file >= 0 && kind < kind_count; ++kind) {
    char line[64];
    const int length = snprintf(line, sizeof line, "%s %ld\n", kinds[kind], (long)counts[kind]);
    syscall(SYS_write, file, line, length);
  }
}

/* Counts the call, and says whether it is the one to fail. */
static int fails(enum kind kind) {
  if (!armed) return 0;
  const long count = atomic_fetch_add(&counts[kind], 1) + 1;
  return (int)kind == chosen && count == at;
}

#define FAIL(kind, result) \
  if (fails(kind)) {       \
    errno = error;         \
    return result;         \
  }
#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* bytes, size_t size) {
  FAIL(k_write, -1)
  if (fails(k_short) && size > 1) size /= 2;
  return NEXT(write)(file, bytes, size);
}
ssize_t read(int file, void* bytes, size_t size) {
  FAIL(k_read, -1)
  return NEXT(read)(file, bytes, size);
}
int fsync(int file) {
  FAIL(k_fsync, -1)
  return NEXT(fsync)(file);
}
int ftruncate(int file, off_t size) {
  FAIL(k_ftruncate, -1)
  return NEXT(ftruncate)(file, size);
}
int ftruncate64(int file, off64_t size) {
  FAIL(k_ftruncate, -1)
  return NEXT(ftruncate64)(file, size);
}
int fchmod(int file, mode_t mode) {
  FAIL(k_fchmod, -1)
  return NEXT(fchmod)(file, mode);
}
int close(int file) {
  const int result = NEXT(close)(file);
  FAIL(k_close, -1) /* as on a network: closed, and the error told */
  return result;
}

int rename(const char* from, const char* to) {
  FAIL(k_rename, -1)
  return NEXT(rename)(from, to);
}
int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  FAIL(k_rename, -1)
  return NEXT(renameat)(from_folder, from, to_folder, to);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  if (armed && getenv("FAULT_NO_EXCHANGE") && (flags & RENAME_EXCHANGE)) {
    errno = EINVAL;
    return -1;
  }
  FAIL(k_rename, -1)
  return NEXT(renameat2)(from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) {
  FAIL(k_unlink, -1)
  return NEXT(unlink)(path);
}
int unlinkat(int folder, const char* path, int flags) {
  FAIL(k_unlink, -1)
  return NEXT(unlinkat)(folder, path, flags);
}
int rmdir(const char* path) {
  FAIL(k_unlink, -1)
  return NEXT(rmdir)(path);
}
int remove(const char* path) {
  FAIL(k_unlink, -1)
  return NEXT(remove)(path);
}
int mkdir(const char* path, mode_t mode) {
  FAIL(k_mkdir, -1)
  return NEXT(mkdir)(path, mode);
}
int chmod(const char* path, mode_t mode) {
  FAIL(k_chmod, -1)
  return NEXT(chmod)(path, mode);
}
int link(const char* from, const char* to) {
  FAIL(k_link, -1)
  return NEXT(link)(from, to);
}

#define OPEN(name)                                   \
  int name(const char* path, int flags, ...) {       \
    mode_t mode = 0;                                 \
    va_list more;                                    \
    va_start(more, flags);                           \
    if (flags & (O_CREAT | O_TMPFILE)) mode = va_arg(more, mode_t); \
    va_end(more);                                    \
    FAIL(k_open, -1)                                 \
    return NEXT(name)(path, flags, mode);            \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                       \
  int name(int folder, const char* path, int flags, ...) { \
    mode_t mode = 0;                                       \
    va_list more;                                          \
    va_start(more, flags);                                 \
    if (flags & (O_CREAT | O_TMPFILE)) mode = va_arg(more, mode_t); \
    va_end(more);                                          \
    FAIL(k_open, -1)                                       \
    return NEXT(name)(folder, path, flags, mode);          \
  }
OPENAT(openat)
OPENAT(openat64)

FILE* fopen(const char* path, const char* mode) {
  FAIL(k_fopen, NULL)
  return NEXT(fopen)(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  FAIL(k_fopen, NULL)
  return NEXT(fopen64)(path, mode);
}
FILE* tmpfile(void) {
  FAIL(k_tmpfile, NULL)
  return NEXT(tmpfile)();
}
FILE* tmpfile64(void) {
  FAIL(k_tmpfile, NULL)
  return NEXT(tmpfile64)();
}
int mkstemp(char* name) {
  FAIL(k_mkstemp, -1)
  return NEXT(mkstemp)(name);
}
int mkstemp64(char* name) {
  FAIL(k_mkstemp, -1)
  return NEXT(mkstemp64)(name);
}
char* mkdtemp(char* name) {
  FAIL(k_mkdtemp, NULL)
  return NEXT(mkdtemp)(name);
}

/* These tell the error by what they return. */
int posix_spawn(pid_t* child, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const arguments[],
                char* const environment[]) {
  if (fails(k_spawn)) return error;
  return NEXT(posix_spawn)(child, path, actions, attributes, arguments, environment);
}
int posix_spawnp(pid_t* child, const char* path, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const arguments[],
                 char* const environment[]) {
  if (fails(k_spawn)) return error;
  return NEXT(posix_spawnp)(child, path, actions, attributes, arguments, environment);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* argument) {
  if (fails(k_thread)) return error;
  return NEXT(pthread_create)(thread, attributes, run, argument);
}
int pipe2(int ends[2], int flags) {
  FAIL(k_pipe, -1)
  return NEXT(pipe2)(ends, flags);
}
int socketpair(int domain, int type, int protocol, int ends[2]) {
  FAIL(k_socketpair, -1)
  return NEXT(socketpair)(domain, type, protocol, ends);
}
