#pragma once

#include <string>

class GDALDataset;

namespace gable {

class AtomicFile;

/// A file that GDAL writes into memory, so that it reaches the disk whole or not at all.
class MemoryFile {
 public:
  /// `extension` with its dot; GDAL's drivers look at it.
  explicit MemoryFile(const std::string& extension);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// The name for GDAL.
  const std::string& name() const { return name_; }

  /// Closes the dataset that was written under name() and puts its bytes on disk, atomically.
  /// Throws Error (kCannotWrite), or kInternal where GDAL could not write into memory.
  void close_and_write(GDALDataset* dataset, const std::string& path);
  /// The same into a file that is open already, which is left to be committed.
  void close_and_write(GDALDataset* dataset, AtomicFile* file);
  /// Writes what GDAL has put into memory without a dataset.
  void write(AtomicFile* file);

 private:
  /// `path` is for messages.
  void close(GDALDataset* dataset, const std::string& path);

  std::string name_;
};

}  // namespace gable
