#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/text_cursor.h>
#include <gable/engine/io/scans/xyz_reader.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

bool starts_comment(std::string_view text) { return text.starts_with("//"); }

/// Moves to the next row and says whether there is one.
bool find_row(TextCursor* cursor) {
  while (cursor->find_word()) {
    if (!starts_comment(cursor->rest())) return true;
    cursor->skip_line();
  }
  return false;
}

/// Moves over a first row that names the columns.
void skip_column_names(TextCursor* cursor) {
  if (!find_row(cursor)) return;
  TextCursor ahead = *cursor;
  double ignored;
  while (ahead.find_word_in_line()) {
    if (parse_number(ahead.word(), &ignored)) return;
  }
  cursor->skip_line();
}

int count_columns(TextCursor cursor) {
  int columns = 0;
  for (; cursor.find_word_in_line(); ++columns) cursor.word();
  return columns;
}

/// The normals of a file that does not say whether it has some must all be unit.
bool is_unit(const Eigen::Vector3f& normal) { return std::abs(normal.norm() - 1.0f) <= 1e-2f; }

}  // namespace

ScanFile read_xyz(std::string_view bytes, const std::string& path, XyzColumns meaning) {
  TextCursor cursor(bytes, path, '#');
  skip_column_names(&cursor);
  if (!find_row(&cursor)) refuse_scan(path, "holds no points", "give a scan with points");
  const int columns = count_columns(cursor);
  const int needed = meaning == XyzColumns::kNormals ? 6 : 3;
  if (columns < needed) {
    cursor.refuse("has " + std::to_string(columns) + " columns where at least " +
                  std::to_string(needed) + " are due");
  }
  bool normals = columns >= 6;
  Scan scan;
  while (find_row(&cursor)) {
    int column = 0;
    const auto next = [&](const char* what) {
      if (!cursor.find_word_in_line()) {
        cursor.refuse("has " + std::to_string(column) + " columns, the first row has " +
                      std::to_string(columns));
      }
      ++column;
      return cursor.number(what);
    };
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) point[k] = next("a coordinate");
    scan.points.push_back(point);
    if (normals) {
      Eigen::Vector3f normal;
      for (int k = 0; k < 3; ++k) normal[k] = static_cast<float>(next("a normal"));
      scan.normals.push_back(normal);
      if (meaning == XyzColumns::kUnknown && !is_unit(normal)) {
        normals = false;
        scan.normals = {};
      }
    }
    for (; cursor.find_word_in_line(); ++column) cursor.word();
    if (column != columns) {
      cursor.refuse("has " + std::to_string(column) + " columns, the first row has " +
                    std::to_string(columns));
    }
  }
  return finish_scan(std::move(scan), path);
}

ScanFile read_pwn(std::string_view bytes, const std::string& path) {
  TextCursor cursor(bytes, path, '#');
  if (!cursor.find_word()) refuse_scan(path, "holds no points", "give a scan with points");
  if (count_columns(cursor) != 1) return read_xyz(bytes, path, XyzColumns::kNormals);
  const int64_t count = cursor.integer("the number of points");
  // A point and its normal take at least "0 0 0\n" each.
  if (count < 0 || count > std::numeric_limits<int>::max() ||
      count * 12 > static_cast<int64_t>(cursor.bytes_left())) {
    refuse_scan(path, "announces " + std::to_string(count) + " points, more than the file can hold",
                "the file is truncated or damaged, export it again");
  }
  Scan scan;
  scan.points.resize(count);
  scan.normals.resize(count);
  for (Eigen::Vector3d& point : scan.points) {
    for (int k = 0; k < 3; ++k) point[k] = cursor.number("a coordinate");
  }
  for (Eigen::Vector3f& normal : scan.normals) {
    for (int k = 0; k < 3; ++k) normal[k] = static_cast<float>(cursor.number("a normal"));
  }
  if (cursor.find_word()) {
    cursor.refuse("has more numbers than the " + std::to_string(count) +
                  " points that the first line announces");
  }
  return finish_scan(std::move(scan), path);
}

}  // namespace gable
