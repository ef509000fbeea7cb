#include <cpl_vsi.h>
#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/readable.h>

#include <cerrno>
#include <cstring>

namespace gable {

void require_readable(const std::string& path) {
  const GdalMessages messages;
  VSIStatBufL stat;
  if (VSIStatL(path.c_str(), &stat) != 0) {
    throw Error(ExitCode::kNoInput, path + ": no such file; check the path");
  }
  if (VSI_ISDIR(stat.st_mode)) {
    throw Error(ExitCode::kNoInput, path + ": is a folder; give a file in it");
  }
  errno = 0;
  VSILFILE* file = VSIFOpenL(path.c_str(), "rb");
  if (!file) {
    throw Error(ExitCode::kNoInput,
                path + ": cannot be opened: " + std::strerror(errno ? errno : EIO));
  }
  VSIFCloseL(file);
}

}  // namespace gable
