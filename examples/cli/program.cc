#include "examples/cli/program.h"

#include <gable/engine/error.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <opencv2/core.hpp>
#include <string>

#include "examples/cli/annotate_command.h"
#include "examples/cli/common_options.h"
#include "examples/cli/evaluate_command.h"
#include "examples/cli/evaluate_detectors_command.h"
#include "examples/cli/interrupt.h"
#include "examples/cli/label_command.h"
#include "examples/cli/reconstruct_command.h"
#include "examples/cli/refine_command.h"
#include "examples/cli/shapes_command.h"
#include "examples/cli/synthesize_command.h"

namespace gable {
namespace {

constexpr const char* kDescription =
    "Compact, semantic, watertight house models from height images.\n"
    "Lengths and heights are in metres, angles in degrees.";

constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 an input is missing, 4 an input is unusable,\n"
    "5 an output cannot be written, 70 a defect of gable, 130 interrupted.";

int fail(ExitCode code, const std::string& line) {
  std::cerr << "gable: " << line << std::endl;
  return static_cast<int>(code);
}

std::string on_one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

int run_program(int argc, char** argv) {
  const Interrupt interrupt;  // before anything starts a thread
  cv::setNumThreads(1);       // buildings are spread over threads, not what is done for each
  CLI::App app{kDescription, "gable"};
  app.set_version_flag("--version", "gable " GABLE_VERSION, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.footer(kFooter);
  app.require_subcommand(1);
  const CommandContext context{interrupt.token()};
  add_synthesize_command(&app, context);
  add_reconstruct_command(&app, context);
  add_refine_command(&app, context);
  add_evaluate_command(&app, context);
  add_evaluate_detectors_command(&app, context);
  add_annotate_command(&app, context);
  add_shapes_command(&app, context);
  add_label_command(&app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return fail(ExitCode::kUsage, on_one_line(error.what()) + " (see gable --help)");
  } catch (const Error& error) {
    return fail(error.code(), on_one_line(error.what()));
  } catch (const std::exception& error) {
    return fail(ExitCode::kInternal,
                "internal error, please report it: " + on_one_line(error.what()));
  }
  return static_cast<int>(ExitCode::kOk);
}

}  // namespace gable
