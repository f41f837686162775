#include "wavecurve/io/files/detail/run_program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ;

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

/// A file without a name, which is gone when it is closed.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile(), std::fclose) {
    if (!file_) throw std::system_error(errno, std::generic_category(), "cannot make a file");
  }
  int descriptor() const { return fileno(file_.get()); }
  std::string text() const {
    std::rewind(file_.get());
    std::string text;
    std::array<char, 65536> part;
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file_.get())) {
      text.append(part.data(), count);
    }
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// The standard streams and the directory of a child.
class ChildSetup {
 public:
  ChildSetup(const Scratch& out, const Scratch& err, const fs::path& directory) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, out.descriptor(), 1);
    posix_spawn_file_actions_adddup2(&actions_, err.descriptor(), 2);
    if (!directory.empty()) {
      posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
    }
  }
  ~ChildSetup() { posix_spawn_file_actions_destroy(&actions_); }
  ChildSetup(const ChildSetup&) = delete;
  ChildSetup& operator=(const ChildSetup&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
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

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& command, const fs::path& directory,
                       const std::vector<std::string>& environment) {
  const Scratch out, err;
  const ChildSetup setup(out, err, directory);
  std::vector<std::string> arguments = command, variables = child_environment(environment);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0].c_str(), setup.actions(), nullptr,
                                 pointers(arguments).data(), pointers(variables).data());
  if (error != 0) {
    throw std::system_error(error, std::generic_category(), "cannot start " + command[0]);
  }
  const int exit_code = wait_for(child);
  return {exit_code, out.text(), err.text()};
}

std::string output_of(const std::vector<std::string>& command, const fs::path& directory,
                      const std::vector<std::string>& environment) {
  ProgramRun run = run_program(command, directory, environment);
  if (run.exit_code == 0) return std::move(run.out);
  constexpr std::size_t end_of_complaint = 600;
  std::string complaint = run.err.empty() ? run.out : run.err;
  if (complaint.size() > end_of_complaint) {
    complaint = "..." + complaint.substr(complaint.size() - end_of_complaint);
  }
  std::string line;
  for (const std::string& word : command) line += (line.empty() ? "" : " ") + word;
  throw std::runtime_error(line + " failed: " + complaint);
}

}  // namespace wavecurve::io
