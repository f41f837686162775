#include "tools/run_main.hpp"

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tools/out_of_memory.hpp"

namespace wavecurve::tools {

namespace {

/// One line on the error stream, whatever the message holds.
int complain(std::string message, ExitCode code) {
  for (char& c : message) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  std::fprintf(stderr, "wavecurve: %s\n", message.c_str());
  return code;
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
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return complain("cannot write to the standard output", environment_failed);
  }
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
  try {
    return say_what_happens(argc, argv, define);
  } catch (const std::bad_alloc&) {
    say_out_of_memory();
    return environment_failed;
  }
}

}  // namespace wavecurve::tools
