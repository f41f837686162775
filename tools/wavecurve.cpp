#include "tools/commands/all_commands.hpp"
#include "tools/run_main.hpp"

int main(int argc, char** argv) {
  return wavecurve::tools::run_main(argc, argv, wavecurve::tools::define_program);
}
