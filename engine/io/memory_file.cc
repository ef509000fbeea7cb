#include <cpl_vsi.h>
#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/memory_file.h>
#include <gdal_priv.h>

#include <atomic>

namespace gable {
namespace {

/// GDAL's memory files share one name space in the process.
std::string fresh_name(const std::string& extension) {
  static std::atomic<unsigned> counter{0};
  return "/vsimem/gable-" + std::to_string(counter++) + extension;
}

}  // namespace

MemoryFile::MemoryFile(const std::string& extension) : name_(fresh_name(extension)) {}

MemoryFile::~MemoryFile() { VSIUnlink(name_.c_str()); }

void MemoryFile::close_and_write(GDALDataset* dataset, const std::string& path) {
  close(dataset, path);
  AtomicFile file(path);
  write(&file);
  file.commit();
}

void MemoryFile::close_and_write(GDALDataset* dataset, AtomicFile* file) {
  close(dataset, file->path());
  write(file);
}

void MemoryFile::close(GDALDataset* dataset, const std::string& path) {
  const GdalMessages messages;
  GDALClose(dataset);
  if (messages.failed()) {
    throw Error(ExitCode::kInternal, path + ": could not be composed" + messages.suffix());
  }
}

void MemoryFile::write(AtomicFile* file) {
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
  if (!bytes) throw Error(ExitCode::kInternal, file->path() + ": could not be composed");
  file->write({reinterpret_cast<const char*>(bytes), static_cast<size_t>(size)});
}

}  // namespace gable
