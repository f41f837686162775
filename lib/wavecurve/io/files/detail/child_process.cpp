#include "wavecurve/io/files/detail/child_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "wavecurve/io/files/detail/unfinished.hpp"

extern char** environ;

namespace wavecurve::io {

namespace {

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

void check(int error) {
  if (error != 0) fail(error, "cannot prepare a child process");
}

/// Two ends: ours and the child's.
using Ends = std::array<OpenFile, 2>;

/// For what the child reads. Other than a pipe, a socket can be told not to raise a signal in us if
/// the child has died.
Ends make_socket() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    fail(errno, "cannot make a socket");
  }
  return {OpenFile(ends[0]), OpenFile(ends[1])};
}

Ends make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail(errno, "cannot make a pipe");
  return {OpenFile(ends[0]), OpenFile(ends[1])};
}

/// The standard streams and the directory of a child.
class Actions {
 public:
  Actions() { check(::posix_spawn_file_actions_init(&actions_)); }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;

  void set(int stream, const OpenFile& descriptor) {
    check(descriptor.is_open()
              ? ::posix_spawn_file_actions_adddup2(&actions_, descriptor.number(), stream)
              : ::posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDONLY, 0));
  }
  void stand_in(const std::filesystem::path& directory) {
    if (directory.empty()) return;
    check(::posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str()));
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// A process group of its own, and signals as a program expects them, whatever we do with ours.
class Attributes {
 public:
  Attributes() {
    check(::posix_spawnattr_init(&attributes_));
    sigset_t none, pipe;
    ::sigemptyset(&none);
    ::sigemptyset(&pipe);
    ::sigaddset(&pipe, SIGPIPE);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &pipe);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> child_environment(const std::vector<std::string>& added) {
  std::vector<std::string> all = added;
  all.emplace_back("LC_ALL=C");
  const auto is_set = [&](const std::string& entry) {
    const std::string name = entry.substr(0, entry.find('=') + 1);
    return std::ranges::any_of(all, [&](const auto& other) { return other.starts_with(name); });
  };
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!is_set(*entry)) all.emplace_back(*entry);
  }
  return all;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildSetting& setting)
    : name_(command.at(0)) {
  Ends input, out = make_pipe(), err = make_pipe();
  if (setting.has_input) input = make_socket();
  input_ = std::move(input[0]);
  out_ = std::move(out[0]);
  err_ = std::move(err[0]);
  start(command, setting, std::move(input[1]), std::move(out[1]), std::move(err[1]));
}

void ChildProcess::start(std::vector<std::string> command, const ChildSetting& setting,
                         OpenFile input, OpenFile out, OpenFile err) {
  Actions actions;
  actions.set(STDIN_FILENO, input);
  actions.set(STDOUT_FILENO, out);
  actions.set(STDERR_FILENO, err);
  if (setting.file != nullptr) actions.set(3, *setting.file);
  actions.stand_in(setting.directory);
  const Attributes attributes;
  std::vector<std::string> variables = child_environment(setting.variables);
  Unfinished unfinished;
  const int error = ::posix_spawnp(&process_, command[0].c_str(), actions.get(), attributes.get(),
                                   pointers(command).data(), pointers(variables).data());
  if (error != 0) {
    process_ = 0;
    fail(error, "cannot start " + name_);
  }
  unfinished.add(process_);
}

ChildProcess::~ChildProcess() {
  if (process_ == 0) return;
  ::kill(-process_, SIGKILL);
  try {
    wait();
  } catch (const std::system_error&) {  // nobody is there to be waited for
  }
}

bool ChildProcess::write(std::string_view bytes) {
  while (!bytes.empty() && input_.is_open()) bytes.remove_prefix(exchange(bytes));
  return input_.is_open();
}

int ChildProcess::finish() {
  input_.close();
  while (out_.is_open() || err_.is_open()) exchange({});
  return wait();
}

/// Waits until something can be read or written, and does it. How many bytes were written.
std::size_t ChildProcess::exchange(std::string_view bytes) {
  pollfd states[3] = {{out_.number(), POLLIN, 0},
                      {err_.number(), POLLIN, 0},
                      {bytes.empty() ? -1 : input_.number(), POLLOUT, 0}};
  while (::poll(states, std::size(states), -1) < 0) {
    if (errno != EINTR) fail(errno, "cannot wait for " + name_);
  }
  take(out_, states[0], out_text_);
  take(err_, states[1], err_text_);
  if (states[2].revents == 0) return 0;
  const ssize_t sent =
      ::send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent >= 0) return static_cast<std::size_t>(sent);
  if (errno != EINTR && errno != EAGAIN) input_.close();
  return 0;
}

void ChildProcess::take(OpenFile& stream, const pollfd& state, std::string& text) {
  if (state.revents == 0) return;
  std::array<char, 65536> part;
  const ssize_t count = ::read(stream.number(), part.data(), part.size());
  if (count < 0 && errno == EINTR) return;
  if (count < 0) fail(errno, "cannot read what " + name_ + " prints");
  if (count == 0) return stream.close();
  text.append(part.data(), static_cast<std::size_t>(count));
  if (text.size() > most_output) {
    throw std::runtime_error(name_ + " prints more than " + std::to_string(most_output) + " bytes");
  }
}

int ChildProcess::wait() {
  // It keeps its number until it is forgotten in Unfinished, so that no other process is killed for it.
  siginfo_t info{};
  while (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT) != 0 &&
         errno == EINTR) {
  }
  Unfinished unfinished;
  unfinished.forget(process_);
  int status = 0;
  const pid_t child = std::exchange(process_, 0);
  if (::waitpid(child, &status, 0) < 0) fail(errno, "cannot wait for " + name_);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace wavecurve::io
