#pragma once

namespace gable {

/// The program `gable`: parses the command line, runs the command it names and returns an exit code
/// (see ExitCode). Whatever goes wrong becomes one line on stderr that starts with "gable: ".
int run_program(int argc, char** argv);

}  // namespace gable
