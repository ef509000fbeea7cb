#include <fcntl.h>
#include <gable/engine/error.h>
#include <gable/engine/io/raster/scratch_heights.h>
#include <glog/logging.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

namespace gable {
namespace {

/// Stored are the bits of a height xor these, so that what was never written, zeros, is NaN.
constexpr uint32_t kNoHeight = 0x7fc00000;

int open_unnamed(const std::string& folder) {
#ifdef O_TMPFILE
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
#endif
  // Not every file system has files without a name.
  std::string name = (std::filesystem::path(folder) / ".gable-XXXXXX").string();
  const int named = ::mkstemp(name.data());
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

ScratchHeights::ScratchHeights(const Grid& grid, const Crs& crs, const std::string& path,
                               const std::string& folder)
    : grid_(grid), crs_(crs), path_(path), folder_(folder) {
  if (folder_.empty()) {
    std::error_code none;
    folder_ = std::filesystem::temp_directory_path(none).string();
    if (none) folder_ = "/tmp";
  }
  descriptor_ = open_unnamed(folder_);
  if (descriptor_ < 0) fail(errno);
  if (::ftruncate(descriptor_, place_of(grid.rows, 0)) != 0) {
    const int error_number = errno;
    ::close(descriptor_);
    fail(error_number);
  }
}

ScratchHeights::~ScratchHeights() { ::close(descriptor_); }

off_t ScratchHeights::place_of(int row, int col) const {
  return static_cast<off_t>(sizeof(uint32_t)) * (static_cast<off_t>(row) * grid_.cols + col);
}

HeightRaster ScratchHeights::read(int row0, int col0, int rows, int cols) const {
  CHECK(row0 >= 0 && col0 >= 0 && row0 + rows <= grid_.rows && col0 + cols <= grid_.cols);
  HeightRaster out(
      {grid_.north_west + grid_.gsd * Eigen::Vector2d(col0, -row0), grid_.gsd, rows, cols},
      std::numeric_limits<float>::quiet_NaN());
  std::vector<uint32_t> line(cols);
  const size_t size = line.size() * sizeof(uint32_t);
  for (int row = 0; row < rows; ++row) {
    size_t done = 0;
    while (done < size) {
      const ssize_t n = ::pread(descriptor_, reinterpret_cast<char*>(line.data()) + done,
                                size - done, place_of(row0 + row, col0) + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) fail(n < 0 ? errno : EIO);
      done += static_cast<size_t>(n);
    }
    for (int col = 0; col < cols; ++col) {
      out.at(row, col) = std::bit_cast<float>(line[col] ^ kNoHeight);
    }
  }
  return out;
}

void ScratchHeights::write(const HeightRaster& heights, int row0, int col0) {
  const int rows = heights.grid.rows, cols = heights.grid.cols;
  CHECK(row0 >= 0 && col0 >= 0 && row0 + rows <= grid_.rows && col0 + cols <= grid_.cols);
  std::vector<uint32_t> line(cols);
  const size_t size = line.size() * sizeof(uint32_t);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const float z = heights.at(row, col);
      line[col] = std::isnan(z) ? 0 : std::bit_cast<uint32_t>(z) ^ kNoHeight;
    }
    size_t done = 0;
    while (done < size) {
      const ssize_t n =
          ::pwrite(descriptor_, reinterpret_cast<const char*>(line.data()) + done, size - done,
                   place_of(row0 + row, col0) + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) fail(n < 0 ? errno : ENOSPC);
      done += static_cast<size_t>(n);
    }
  }
}

void ScratchHeights::fail(int error_number) const {
  throw Error(ExitCode::kCannotWrite,
              folder_ + ": temporary heights cannot be kept there: " + std::strerror(error_number));
}

}  // namespace gable
