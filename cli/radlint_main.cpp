#include "cli/program.h"
#include "cli/radlint.h"

int main(int argc, char** argv) { return rad::cli::run_program("radlint", &rad::cli::run_radlint, argc, argv); }
