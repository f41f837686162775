#include "tools/ending.hpp"

#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <string_view>
#include <unistd.h>

#include "wavecurve/io/files/detail/unfinished.hpp"

namespace wavecurve::tools {

namespace {

[[noreturn]] void die_by(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t set;
  ::sigemptyset(&set);
  ::sigaddset(&set, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::kill(::getpid(), signal);
  ::_exit(128 + signal);  // the first process of a container does not die by signals
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The signals that tell the program to end. What is ignored (as nohup does) stays ignored.
sigset_t& ending_signals() {
  static sigset_t& set = *new sigset_t;
  return set;
}

/// A terminal has echoed ^C into a line that may hold a status as well.
void say_interrupted() {
  constexpr std::string_view line = "\nwavecurve: interrupted\n";
  const std::string_view text = line.substr(::isatty(STDERR_FILENO) != 0 ? 0 : 1);
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody is there to read it
}

void* wait_for_the_end(void*) {
  int signal = 0;
  while (::sigwait(&ending_signals(), &signal) != 0) {
  }
  io::Unfinished all;
  all.abandon();
  if (signal == SIGINT) say_interrupted();
  die_by(signal);
}

void watch_signals() {
  ::sigemptyset(&ending_signals());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) ::sigaddset(&ending_signals(), signal);
  }
  // All threads that come inherit this, and only the waiting one takes a signal.
  ::pthread_sigmask(SIG_BLOCK, &ending_signals(), nullptr);
  pthread_t thread;
  if (::pthread_create(&thread, nullptr, wait_for_the_end, nullptr) == 0) {
    ::pthread_detach(thread);
  } else {  // signals then end the program at once, and the next run tidies up
    ::pthread_sigmask(SIG_UNBLOCK, &ending_signals(), nullptr);
  }
}

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The least of the closed numbers is taken. What is written to the output must not pass for
    // written, but messages may be lost.
    ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace

void prepare_for_ending() {
  open_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);  // ignored, it would hide how child processes end
  watch_signals();
}

void die_of_broken_pipe() { die_by(SIGPIPE); }

bool is_output_pipe_broken() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

}  // namespace wavecurve::tools
