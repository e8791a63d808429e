// The languages of the shells. Only completion.cpp includes it.
#pragma once

#include <string>

#include "cli/completion.h"

namespace rad::cli {

std::string bash_completion(const CompletedProgram& program);
std::string zsh_completion(const CompletedProgram& program);
std::string fish_completion(const CompletedProgram& program);

}  // namespace rad::cli
