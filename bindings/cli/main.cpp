// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"

int main(int argc, char** argv) { return rhexis::cli::run_program(argc, argv); }
