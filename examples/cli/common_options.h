#pragma once

#include <CLI/CLI.hpp>
#include <stop_token>

namespace gable {

/// Options that every command has.
struct CommonOptions {
  int threads = 0;  ///< 0: one per core
  bool quiet = false;

  /// The number of threads to start, at least 1.
  int num_threads() const;
};

/// What a command is given besides its own options.
struct CommandContext {
  std::stop_token stop;  ///< requested on Ctrl-C
};

/// Adds --threads and --quiet to a command.
void add_common_options(CLI::App* command, CommonOptions* options);

}  // namespace gable
