#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/ply_header.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <algorithm>
#include <climits>
#include <map>

namespace gable {
namespace {

ScalarType scalar_type(const TextCursor& line, std::string_view name) {
  static const std::map<std::string_view, ScalarType> kTypes = {
      {"char", ScalarType::kInt8},      {"int8", ScalarType::kInt8},
      {"uchar", ScalarType::kUint8},    {"uint8", ScalarType::kUint8},
      {"short", ScalarType::kInt16},    {"int16", ScalarType::kInt16},
      {"ushort", ScalarType::kUint16},  {"uint16", ScalarType::kUint16},
      {"int", ScalarType::kInt32},      {"int32", ScalarType::kInt32},
      {"uint", ScalarType::kUint32},    {"uint32", ScalarType::kUint32},
      {"float", ScalarType::kFloat32},  {"float32", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64}, {"float64", ScalarType::kFloat64},
      {"int64", ScalarType::kInt64},    {"uint64", ScalarType::kUint64},
  };
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) line.refuse("a property has no known type");
  return found->second;
}

PlyFormat read_format(TextCursor* line) {
  const std::string_view format = line->word();
  if (format == "ascii") return PlyFormat::kAscii;
  if (format == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (format == "binary_big_endian") return PlyFormat::kBigEndian;
  line->refuse("the format is none of ascii, binary_little_endian and binary_big_endian");
}

PlyProperty read_property(TextCursor* line) {
  PlyProperty property;
  std::string_view type = line->word();
  property.is_list = type == "list";
  if (property.is_list) {
    property.length_type = scalar_type(*line, line->word());
    if (!is_integer(property.length_type)) line->refuse("the length of a list is no integer");
    type = line->word();
  }
  property.type = scalar_type(*line, type);
  if (!line->find_word_in_line()) line->refuse("a property has no name");
  property.name = line->word();
  return property;
}

/// The fewest bytes an element takes.
size_t smallest_size(const PlyElement& element, PlyFormat format) {
  size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    if (format == PlyFormat::kAscii) {
      size += 2;
    } else {
      size += size_of(property.is_list ? property.length_type : property.type);
    }
  }
  return size;
}

void require_room(const PlyHeader& header, size_t num_bytes, const std::string& path) {
  size_t left = num_bytes - header.size + 1;  // the last line may lack its end
  for (const PlyElement& element : header.elements) {
    const size_t size = smallest_size(element, header.format);
    if (size == 0) continue;
    if (element.count > INT_MAX || element.count > left / size) {
      refuse_scan(path,
                  "announces " + std::to_string(element.count) + " times \"" + element.name +
                      "\", more than the file can hold",
                  "the file is truncated or damaged, export it again");
    }
    left -= element.count * size;
  }
}

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with("ply")) {
    refuse_scan(path, "is no PLY file: it does not start with ply", "check the extension");
  }
  TextCursor cursor(bytes, path);
  PlyHeader header;
  bool has_format = false;
  for (cursor.skip_line(); cursor.find_word(); cursor.skip_line()) {
    const std::string_view keyword = cursor.word();
    if (keyword == "end_header") {
      if (!has_format) cursor.refuse("the header does not tell the format");
      cursor.skip_line();
      header.size = cursor.position();
      require_room(header, bytes.size(), path);
      return header;
    }
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      header.format = read_format(&cursor);
      has_format = true;
    } else if (keyword == "element") {
      PlyElement element;
      element.name = cursor.word();
      const int64_t count = cursor.integer("the number of an element");
      if (count < 0) cursor.refuse("the number of an element is negative");
      element.count = static_cast<size_t>(count);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) cursor.refuse("a property comes before all elements");
      header.elements.back().properties.push_back(read_property(&cursor));
    } else {
      cursor.refuse("the header has an unknown line");
    }
  }
  refuse_scan(path, "ends within its header");
}

}  // namespace gable
