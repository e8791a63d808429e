#include "cli/program.h"

#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <vector>

#include "cli/exit_code.h"

namespace rad::cli {

int run_program(const char* name, Run run, int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
    return run(args, std::cout, std::cerr, terminal_of_process());
  } catch (const std::bad_alloc&) {
    std::cerr << name << ": out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
  }
  return kUsage;
}

}  // namespace rad::cli
