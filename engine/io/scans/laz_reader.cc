#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/laz_reader.h>

#ifdef GABLE_WITH_LASZIP

#include <gable/engine/io/scans/las_header.h>
#include <gable/engine/io/scans/las_reader.h>
#include <gable/engine/io/scans/scalar_type.h>
#include <laszip/laszip_api.h>

#include <climits>
#include <sstream>

namespace gable {
namespace {

/// LASzip is not proof against truncated files. Their end holds the table of chunks, whose place
/// stands before the first point or, where that could not be written, in the last bytes.
void require_chunk_table(std::string_view bytes, const LasHeader& header, const std::string& path) {
  const auto offset_at = [&](size_t at) { return load_little<int64_t>(bytes.data() + at); };
  int64_t table = -1;
  if (header.first >= 8 && header.first + 16 <= bytes.size()) {
    table = offset_at(header.first);
    if (table == -1) table = offset_at(bytes.size() - 8);
  }
  const auto first = static_cast<int64_t>(header.first) + 8;
  if (table < first || table > static_cast<int64_t>(bytes.size()) - 8) {
    refuse_scan(path, "its compressed points end too early",
                "the file is truncated or damaged, export it again");
  }
}

/// LASzip's reader of a file in memory.
class LazPoints {
 public:
  LazPoints(std::string_view bytes, const std::string& path)
      : path_(path), stream_(std::string(bytes)) {
    laszip_create(&reader_);
  }
  ~LazPoints() {
    laszip_close_reader(reader_);  // an error where it is not open, which changes nothing
    laszip_destroy(reader_);
  }
  LazPoints(const LazPoints&) = delete;
  LazPoints& operator=(const LazPoints&) = delete;

  void open() {
    laszip_BOOL compressed = 0;
    require(laszip_open_reader_stream(reader_, stream_, &compressed));
    require(laszip_get_point_pointer(reader_, &record_));
  }
  void next(LasPoint* point, bool extended) {
    require(laszip_read_point(reader_));
    require(laszip_get_coordinates(reader_, point->position.data()));
    point->classification = extended ? record_->extended_classification : record_->classification;
    point->withheld =
        extended ? (record_->extended_classification_flags & 4) != 0 : record_->withheld_flag != 0;
  }

 private:
  void require(laszip_I32 result) const {
    if (result == 0) return;
    laszip_CHAR* reason = nullptr;
    laszip_get_error(reader_, &reason);
    refuse_scan(path_, std::string("LASzip cannot read it: ") + (reason ? reason : "unknown"));
  }

  const std::string& path_;
  std::istringstream stream_;
  laszip_POINTER reader_ = nullptr;
  laszip_point* record_ = nullptr;
};

}  // namespace

void visit_laz_points(std::string_view bytes, const std::string& path,
                      const std::function<void(const LasPoint&)>& visit) {
  const LasHeader header = read_las_header(bytes, path);
  require_chunk_table(bytes, header, path);
  LazPoints points(bytes, path);
  points.open();
  LasPoint point;
  for (size_t i = 0; i < header.count; ++i) {
    points.next(&point, header.format > 5);
    visit(point);
  }
}

ScanFile read_laz(std::string_view bytes, const std::string& path) {
  const LasHeader header = read_las_header(bytes, path);
  if (!header.compressed) return read_las(bytes, path);
  if (header.count > INT_MAX) refuse_scan(path, "announces more points than a scan may have");
  Scan scan;
  std::vector<int>& classes = scan.labels["class"];
  // Without reserving: a compressed file of any size might hold any number of points.
  visit_laz_points(bytes, path, [&](const LasPoint& point) {
    scan.points.push_back(point.position);
    classes.push_back(point.classification);
  });
  return finish_scan(std::move(scan), path);
}

}  // namespace gable

#else

namespace gable {
namespace {

[[noreturn]] void refuse_laz(const std::string& path) {
  refuse_scan(path, "is LAZ, which this gable is built without",
              "convert it to LAS, or rebuild gable with LASzip");
}

}  // namespace

ScanFile read_laz(std::string_view, const std::string& path) { refuse_laz(path); }

void visit_laz_points(std::string_view, const std::string& path,
                      const std::function<void(const LasPoint&)>&) {
  refuse_laz(path);
}

}  // namespace gable

#endif
