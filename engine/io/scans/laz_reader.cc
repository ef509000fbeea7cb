#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/laz_reader.h>

#ifdef GABLE_WITH_LASZIP

#include <laszip/laszip_api.h>

#include <climits>
#include <sstream>

namespace gable {
namespace {

/// LASzip's reader, closed on every way out.
class LazReader {
 public:
  LazReader(std::string_view bytes, const std::string& path)
      : path_(path), stream_(std::string(bytes)) {
    require(laszip_create(&reader_));
    laszip_BOOL compressed = 0;
    require(laszip_open_reader_stream(reader_, stream_, &compressed));
    is_open_ = true;
  }
  ~LazReader() {
    if (is_open_) laszip_close_reader(reader_);
    if (reader_) laszip_destroy(reader_);
  }
  LazReader(const LazReader&) = delete;
  LazReader& operator=(const LazReader&) = delete;

  laszip_POINTER get() const { return reader_; }
  void require(laszip_I32 result) const {
    if (result == 0) return;
    laszip_CHAR* reason = nullptr;
    if (reader_) laszip_get_error(reader_, &reason);
    std::string line = reason ? reason : "unknown error";
    for (char& c : line) {
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    refuse_scan(path_, "LASzip cannot read it (" + line + ")");
  }

 private:
  const std::string& path_;
  std::istringstream stream_;
  laszip_POINTER reader_ = nullptr;
  bool is_open_ = false;
};

}  // namespace

ScanFile read_laz(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with("LASF")) {
    refuse_scan(path, "is no LAZ file: it does not start with LASF", "check the extension");
  }
  const LazReader reader(bytes, path);
  laszip_header* header = nullptr;
  reader.require(laszip_get_header_pointer(reader.get(), &header));
  laszip_point* record = nullptr;
  reader.require(laszip_get_point_pointer(reader.get(), &record));
  const laszip_U64 count = header->number_of_point_records > 0
                               ? header->number_of_point_records
                               : header->extended_number_of_point_records;
  if (count > INT_MAX) refuse_scan(path, "announces more points than a scan may have");
  Scan scan;
  std::vector<int>& classes = scan.labels["class"];
  // No reserve: compressed, any number of points might be true.
  for (laszip_U64 i = 0; i < count; ++i) {
    Eigen::Vector3d point;
    reader.require(laszip_read_point(reader.get()));
    reader.require(laszip_get_coordinates(reader.get(), point.data()));
    scan.points.push_back(point);
    classes.push_back(header->point_data_format > 5 ? int{record->extended_classification}
                                                    : int{record->classification});
  }
  return finish_scan(std::move(scan), path);
}

}  // namespace gable

#else

namespace gable {

ScanFile read_laz(std::string_view, const std::string& path) {
  refuse_scan(path, "is LAZ, which this gable is built without",
              "convert it to LAS, or rebuild gable with LASzip");
}

}  // namespace gable

#endif
