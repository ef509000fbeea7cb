#include "examples/cli/program.h"

int main(int argc, char** argv) { return gable::run_program(argc, argv); }
