#include "tools/c_libraries_memory.hpp"
#include "tools/commands/all_commands.hpp"
#include "tools/run_main.hpp"

int main(int argc, char** argv) {
  wavecurve::tools::end_where_c_libraries_lack_memory();
  return wavecurve::tools::run_main(argc, argv, wavecurve::tools::define_program);
}
