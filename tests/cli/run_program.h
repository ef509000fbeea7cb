#pragma once

#include <string>
#include <vector>

namespace gable {

/// How a run of the program ended.
struct ProgramRun {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out;
  std::string err;
};

/// Runs the built program `gable` with the given arguments and waits for its end.
ProgramRun run_gable(const std::vector<std::string>& arguments);

/// The same, but sends the program a signal ("KILL", "INT") once it has run for that many seconds;
/// where it has ended before, it is as without.
ProgramRun run_gable_for(double seconds, const std::string& signal,
                         const std::vector<std::string>& arguments);

/// Number of lines in a text; a last line without a line feed counts.
int num_lines(const std::string& text);

}  // namespace gable
