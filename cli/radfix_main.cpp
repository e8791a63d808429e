#include "cli/program.h"
#include "cli/radfix.h"

int main(int argc, char** argv) { return rad::cli::run_program("radfix", &rad::cli::run_radfix, argc, argv); }
