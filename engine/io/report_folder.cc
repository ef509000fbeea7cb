#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/report_folder.h>

#include <filesystem>
#include <system_error>

namespace gable {

void write_report(const std::string& folder, std::span<const ReportFile> files) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw Error(ExitCode::kCannotWrite, folder + ": cannot be written: " + error.message());
  }
  for (const ReportFile& file : files) {
    write_file_atomically((std::filesystem::path(folder) / file.name).string(), file.bytes);
  }
}

}  // namespace gable
