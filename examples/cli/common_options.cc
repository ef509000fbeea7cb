#include "examples/cli/common_options.h"

#include <algorithm>
#include <thread>

namespace gable {

int CommonOptions::num_threads() const {
  if (threads > 0) return threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void add_common_options(CLI::App* command, CommonOptions* options) {
  command->add_option("--threads", options->threads, "Threads; 0: one per core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Print nothing but errors and results");
}

}  // namespace gable
