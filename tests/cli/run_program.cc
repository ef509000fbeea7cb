#include "cli/run_program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace gable {
namespace {

std::string quoted(const std::string& argument) {
  std::string result = "'";
  for (const char c : argument) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

std::string read_and_remove(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::remove(path.c_str());
  return text;
}

std::string temporary_file() {
  std::string path = std::string(P_tmpdir) + "/gable_run_XXXXXX";
  const int file = mkstemp(path.data());
  if (file >= 0) close(file);
  return path;
}

ProgramRun run_command(std::string command, const std::vector<std::string>& arguments) {
  const std::string out = temporary_file();
  const std::string err = temporary_file();
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " >" + quoted(out) + " 2>" + quoted(err) + " </dev/null";
  const int status = std::system(command.c_str());
  ProgramRun run;
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  run.out = read_and_remove(out);
  run.err = read_and_remove(err);
  return run;
}

}  // namespace

ProgramRun run_gable(const std::vector<std::string>& arguments) {
  return run_command(quoted(GABLE_PROGRAM), arguments);
}

ProgramRun run_gable_for(double seconds, const std::string& signal,
                         const std::vector<std::string>& arguments) {
  return run_command("timeout --foreground --preserve-status -s " + signal + " " +
                         std::to_string(seconds) + " " + quoted(GABLE_PROGRAM),
                     arguments);
}

int num_lines(const std::string& text) {
  int lines = 0;
  for (const char c : text) lines += c == '\n';
  return lines + (!text.empty() && text.back() != '\n');
}

}  // namespace gable
