#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/lzf.h>
#include <gable/engine/io/scans/pcd_header.h>
#include <gable/engine/io/scans/pcd_reader.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <algorithm>
#include <array>
#include <bit>

namespace gable {
namespace {

constexpr std::array<const char*, 6> kSlots = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};

const PcdField* find_field(const PcdHeader& header, std::string_view name) {
  for (const PcdField& field : header.fields) {
    if (field.name == name && field.count > 0) return &field;
  }
  return nullptr;
}

/// The fields that a scan has a place for, and these places.
class Fields {
 public:
  Fields(const PcdHeader& header, const std::string& path, Scan* scan) : scan_(*scan) {
    for (size_t k = 0; k < kSlots.size(); ++k) slots_[k] = find_field(header, kSlots[k]);
    for (int k = 0; k < 3; ++k) {
      if (!slots_[k]) {
        refuse_scan(path, std::string("has no field ") + kSlots[k], "export coordinates as x y z");
      }
    }
    has_normals_ = slots_[3] && slots_[4] && slots_[5];
    scan_.points.resize(header.num_points);
    if (has_normals_) scan_.normals.resize(header.num_points);
    for (const PcdField& field : header.fields) {
      const bool is_slot = std::find(slots_.begin(), slots_.end(), &field) != slots_.end();
      if (is_slot || !is_integer(field.type) || field.count != 1) continue;
      if (field.name == "rgb" || field.name == "rgba" || field.name == "_") continue;
      const auto [label, is_new] = scan_.labels.try_emplace(field.name);
      if (!is_new) continue;
      label->second.resize(header.num_points);
      labels_.emplace_back(&field, &label->second);
    }
  }

  /// Takes point i; `value(field)` is the first value of a field.
  template <typename Value>
  void take(size_t i, const Value& value) {
    for (int k = 0; k < 3; ++k) scan_.points[i][k] = value(*slots_[k]);
    for (int k = 0; k < 3 && has_normals_; ++k) {
      scan_.normals[i][k] = static_cast<float>(value(*slots_[3 + k]));
    }
    for (const auto& [field, values] : labels_) (*values)[i] = label_of(value(*field));
  }

 private:
  Scan& scan_;
  std::array<const PcdField*, 6> slots_{};
  bool has_normals_ = false;
  std::vector<std::pair<const PcdField*, std::vector<int>*>> labels_;
};

[[noreturn]] void refuse_count(const PcdHeader& header, const std::string& path) {
  refuse_scan(
      path,
      "announces " + std::to_string(header.num_points) + " points, more than the file can hold",
      "the file is truncated or damaged, export it again");
}

Scan read_ascii(const PcdHeader& header, std::string_view bytes, const std::string& path) {
  // A word takes at least two bytes; the last one may lack its end.
  const size_t held = (bytes.size() - header.size + 1) / (2 * header.num_columns);
  if (header.num_points > held) {
    refuse_count(header, path);
  }
  Scan scan;
  Fields fields(header, path, &scan);
  TextCursor cursor(bytes, path, '#');
  cursor.skip(header.size);
  std::vector<bool> is_first(header.num_columns);
  for (const PcdField& field : header.fields) {
    if (field.count > 0) is_first[field.column] = true;
  }
  std::vector<double> row(header.num_columns);
  for (size_t i = 0; i < header.num_points; ++i) {
    for (size_t column = 0; column < row.size(); ++column) {
      if (is_first[column]) {
        row[column] = cursor.number("a value");
      } else {
        cursor.word();
      }
    }
    fields.take(i, [&](const PcdField& field) { return row[field.column]; });
  }
  return scan;
}

/// Points one after the other, or, `by_field`, all values of the first field first.
Scan read_binary(const PcdHeader& header, std::string_view bytes, bool by_field,
                 const std::string& path) {
  if (header.num_points > bytes.size() / header.point_size) {
    refuse_count(header, path);
  }
  constexpr bool kSwapped = std::endian::native == std::endian::big;
  Scan scan;
  Fields fields(header, path, &scan);
  for (size_t i = 0; i < header.num_points; ++i) {
    fields.take(i, [&](const PcdField& field) {
      const size_t at = by_field ? field.offset * header.num_points + i * field.size()
                                 : i * header.point_size + field.offset;
      return load_scalar(field.type, bytes.data() + at, kSwapped);
    });
  }
  return scan;
}

std::string decompress(const PcdHeader& header, std::string_view bytes, const std::string& path) {
  if (bytes.size() < 8) refuse_scan(path, "ends where its compressed data begins");
  const size_t compressed = load_little<uint32_t>(bytes.data());
  const size_t size = load_little<uint32_t>(bytes.data() + 4);
  if (compressed > bytes.size() - 8 || header.num_points > size / header.point_size) {
    refuse_count(header, path);
  }
  std::string plain;
  if (!decompress_lzf(bytes.substr(8, compressed), size, &plain)) {
    refuse_scan(path, "its compressed data is damaged", "export it again");
  }
  return plain;
}

}  // namespace

ScanFile read_pcd(std::string_view bytes, const std::string& path) {
  const PcdHeader header = read_pcd_header(bytes, path);
  const std::string_view body = bytes.substr(header.size);
  switch (header.data) {
    case PcdData::kAscii:
      return finish_scan(read_ascii(header, bytes, path), path);
    case PcdData::kBinary:
      return finish_scan(read_binary(header, body, false, path), path);
    default:
      return finish_scan(read_binary(header, decompress(header, body, path), true, path), path);
  }
}

}  // namespace gable
