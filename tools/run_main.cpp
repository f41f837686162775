#include "tools/run_main.hpp"

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/commands/terminal.hpp"
#include "tools/ending.hpp"
#include "tools/out_of_memory.hpp"

namespace wavecurve::tools {

namespace {

int complain(std::string_view message, ExitCode code) {
  print_message(message);
  return code;
}

/// The exit code of a program whose output cannot be written.
int cannot_print() {
  if (is_output_pipe_broken()) die_of_broken_pipe();
  return complain("cannot write to the standard output", environment_failed);
}

/// The exit code that the commands leave, or that of help and version.
int parse(CLI::App& app, int argc, char** argv, const ExitCode& exit_code) try {
  app.parse(argc, argv);
  return exit_code;
} catch (const CLI::Success& help_or_version) {
  return app.exit(help_or_version);
}

int run(int argc, char** argv, DefineCommands define) {
  CLI::App app;
  ExitCode exit_code = done;
  define(app, exit_code);
  const int code = parse(app, argc, argv, exit_code);
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return cannot_print();
  return code;
}

/// What happens as an exit code, where there is memory enough to say it.
int say_what_happens(int argc, char** argv, DefineCommands define) {
  try {
    return run(argc, argv, define);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (wavecurve --help lists the commands)",
                    bad_input);
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return cannot_print();
    return complain(error.what(), environment_failed);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), bad_input);
  } catch (const std::domain_error& error) {
    return complain(error.what(), bad_input);
  } catch (const std::exception& error) {
    return complain(error.what(), environment_failed);
  }
}

}  // namespace

int run_main(int argc, char** argv, DefineCommands define) {
  prepare_for_ending();
  try {
    return say_what_happens(argc, argv, define);
  } catch (const std::bad_alloc&) {
    say_out_of_memory();
    return environment_failed;
  }
}

}  // namespace wavecurve::tools
