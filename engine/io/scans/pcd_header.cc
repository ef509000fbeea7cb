#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/pcd_header.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <climits>

namespace gable {
namespace {

// Far more than any point has, few enough that products of header numbers stay in range.
constexpr int64_t kMostValues = 1 << 16;

ScalarType scalar_type(const TextCursor& line, char kind, int64_t size) {
  if (kind == 'F' && size == 4) return ScalarType::kFloat32;
  if (kind == 'F' && size == 8) return ScalarType::kFloat64;
  const bool is_signed = kind == 'I';
  if (is_signed || kind == 'U') {
    if (size == 1) return is_signed ? ScalarType::kInt8 : ScalarType::kUint8;
    if (size == 2) return is_signed ? ScalarType::kInt16 : ScalarType::kUint16;
    if (size == 4) return is_signed ? ScalarType::kInt32 : ScalarType::kUint32;
    if (size == 8) return is_signed ? ScalarType::kInt64 : ScalarType::kUint64;
  }
  line.refuse("a field has a TYPE and SIZE that no number has");
}

std::vector<int64_t> rest_of_line(TextCursor* line, const char* what) {
  std::vector<int64_t> values;
  while (line->find_word_in_line()) values.push_back(line->integer(what));
  return values;
}

int64_t count_of(TextCursor* line, const char* what) {
  if (!line->find_word_in_line()) line->refuse(std::string(what) + " is missing");
  const int64_t count = line->integer(what);
  if (count < 0 || count > INT_MAX) line->refuse(std::string(what) + " is out of range");
  return count;
}

PcdData data_of(TextCursor* line) {
  const std::string_view word = line->word();
  if (word == "ascii") return PcdData::kAscii;
  if (word == "binary") return PcdData::kBinary;
  if (word == "binary_compressed") return PcdData::kCompressed;
  line->refuse("DATA is none of ascii, binary and binary_compressed");
}

/// Gives the fields their types and their places in a point.
void place_fields(const TextCursor& line, const std::vector<int64_t>& sizes,
                  const std::string& kinds, const std::vector<int64_t>& counts, PcdHeader* header) {
  const size_t num_fields = header->fields.size();
  if (num_fields == 0 || sizes.size() != num_fields || kinds.size() != num_fields ||
      (!counts.empty() && counts.size() != num_fields)) {
    line.refuse("FIELDS, SIZE, TYPE and COUNT have different lengths");
  }
  for (size_t f = 0; f < num_fields; ++f) {
    PcdField& field = header->fields[f];
    field.type = scalar_type(line, kinds[f], sizes[f]);
    const int64_t count = counts.empty() ? 1 : counts[f];
    if (count < 0 || count > kMostValues) line.refuse("COUNT is out of range");
    field.count = static_cast<size_t>(count);
    field.offset = header->point_size;
    field.column = header->num_columns;
    header->point_size += field.size();
    header->num_columns += field.count;
  }
  if (header->num_columns == 0) line.refuse("the points have no values");
}

}  // namespace

PcdHeader read_pcd_header(std::string_view bytes, const std::string& path) {
  TextCursor cursor(bytes, path, '#');
  PcdHeader header;
  std::vector<int64_t> sizes, counts;
  std::string kinds;
  int64_t width = 0, height = 1, points = -1;
  bool complete = false;
  while (!complete && cursor.find_word()) {
    const std::string_view keyword = cursor.word();
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      header.fields.clear();
      while (cursor.find_word_in_line()) {
        header.fields.emplace_back();
        header.fields.back().name = cursor.word();
      }
    } else if (keyword == "SIZE") {
      sizes = rest_of_line(&cursor, "SIZE");
    } else if (keyword == "TYPE") {
      kinds.clear();
      while (cursor.find_word_in_line()) kinds += cursor.word().front();
    } else if (keyword == "COUNT") {
      counts = rest_of_line(&cursor, "COUNT");
    } else if (keyword == "WIDTH") {
      width = count_of(&cursor, "WIDTH");
    } else if (keyword == "HEIGHT") {
      height = count_of(&cursor, "HEIGHT");
    } else if (keyword == "POINTS") {
      points = count_of(&cursor, "POINTS");
    } else if (keyword == "DATA") {
      header.data = data_of(&cursor);
      place_fields(cursor, sizes, kinds, counts, &header);
      complete = true;
    } else if (keyword != "VERSION" && keyword != "VIEWPOINT") {
      cursor.refuse("is no line of a PCD header");
    }
    cursor.skip_line();
  }
  if (!complete) refuse_scan(path, "is no PCD file: its header has no DATA", "check the extension");
  header.num_points = static_cast<size_t>(points >= 0 ? points : width * height);
  if (header.num_points > INT_MAX) refuse_scan(path, "announces too many points");
  header.size = cursor.position();
  return header;
}

}  // namespace gable
