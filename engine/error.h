#pragma once

#include <stdexcept>
#include <string>

namespace gable {

/// Exit codes of the program, documented in the README. Also carried by Error for embedders.
enum class ExitCode {
  kOk = 0,
  kUsage = 2,        ///< unknown option, missing argument, value outside its range
  kNoInput = 3,      ///< an input file does not exist or cannot be opened
  kBadInput = 4,     ///< an input file is not what it should be (format, CRS, no data, no overlap)
  kCannotWrite = 5,  ///< an output cannot be written (no such folder, no permission, full disk)
  kInternal = 70,    ///< a defect of gable itself
  kInterrupted = 130,  ///< stopped by Ctrl-C or a termination signal; no output was written, but
                       ///< for the windows that a folder of models has
};

/// Bad input or an output that cannot be written: one line that names the file and the remedy.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace gable
