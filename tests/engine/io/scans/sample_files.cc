#include "engine/io/scans/sample_files.h"

#include <glog/logging.h>

#include <cmath>
#include <cstdint>
#include <sstream>

namespace gable {
namespace {

template <typename Vector>
std::string words(const Vector& v) {
  std::ostringstream text;
  text.precision(17);
  text << v[0] << ' ' << v[1] << ' ' << v[2];
  return text.str();
}

const std::vector<int>& plane(const Scan& scan) { return scan.labels.at("plane"); }

/// LZF that is correct, not small: runs of one byte become copies, the rest literals.
std::string compress_lzf(std::string_view input) {
  std::string output;
  size_t begin = 0;
  const auto literals = [&](size_t end) {
    while (begin < end) {
      const size_t length = std::min<size_t>(32, end - begin);
      output += static_cast<char>(length - 1);
      output += input.substr(begin, length);
      begin += length;
    }
  };
  for (size_t i = 1; i < input.size();) {
    size_t run = 0;
    while (i + run < input.size() && run < 264 && input[i + run] == input[i - 1]) ++run;
    if (run < 3) {
      ++i;
      continue;
    }
    literals(i);
    const size_t length = run - 2;
    output += static_cast<char>(std::min<size_t>(length, 7) << 5);
    if (length >= 7) output += static_cast<char>(length - 7);
    output += '\0';
    begin = i += run;
  }
  literals(input.size());
  return output;
}

}  // namespace

Scan sample_cloud() {
  Scan scan;
  scan.points = {{0, 0, 0}, {2, 0, 0.5}, {2, 1.5, -1}, {0, 1.5, 0.25}, {-3.25, 4, 8}};
  scan.normals = {{0, 0, 1}, {0.6f, 0.8f, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0.6f, -0.8f}};
  scan.labels["plane"] = {0, 1, -1, 2, 7};
  return scan;
}

Scan sample_mesh() {
  Scan scan = sample_cloud();
  scan.facets.add(std::vector{0, 1, 2});
  scan.facets.add(std::vector{0, 2, 3, 4});
  scan.labels["plane"] = {3, -1};
  return scan;
}

std::string ply_file(const Scan& scan, const std::string& format) {
  std::string text = "ply\nformat " + format + " 1.0\ncomment a sample\nelement vertex " +
                     std::to_string(scan.points.size()) +
                     "\nproperty double x\nproperty float y\nproperty float z\n"
                     "property uchar red\nproperty float nx\nproperty float ny\n"
                     "property double nz\n";
  if (!scan.is_mesh()) text += "property short plane\n";
  text += "element camera 1\nproperty list ushort float view\nproperty int width\n";
  if (scan.is_mesh()) {
    text += "element face " + std::to_string(scan.facets.size()) +
            "\nproperty list uchar uint vertex_indices\nproperty int plane\n";
  }
  text += "end_header\n";
  const bool ascii = format == "ascii";
  const auto order = format == "binary_big_endian" ? std::endian::big : std::endian::little;
  const auto put = [&](auto value) {
    if (ascii) {
      std::ostringstream word;
      word << +value << ' ';
      text += word.str();
    } else {
      append_bytes(value, &text, order);
    }
  };
  for (size_t i = 0; i < scan.points.size(); ++i) {
    put(scan.points[i].x());
    put(static_cast<float>(scan.points[i].y()));
    put(static_cast<float>(scan.points[i].z()));
    put(uint8_t{200});
    put(scan.normals[i].x());
    put(scan.normals[i].y());
    put(static_cast<double>(scan.normals[i].z()));
    if (!scan.is_mesh()) put(static_cast<int16_t>(plane(scan)[i]));
    if (ascii) text += '\n';
  }
  put(uint16_t{2});
  put(0.5f);
  put(-1.5f);
  put(int32_t{640});
  if (ascii) text += '\n';
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    put(static_cast<uint8_t>(scan.facets[f].size()));
    for (const int corner : scan.facets[f]) put(static_cast<uint32_t>(corner));
    put(int32_t{plane(scan)[f]});
    if (ascii) text += '\n';
  }
  return text;
}

std::string xyz_file(const Scan& scan, bool normals) {
  std::string text;
  for (size_t i = 0; i < scan.points.size(); ++i) {
    text += words(scan.points[i]);
    if (normals) text += ' ' + words(scan.normals[i]);
    text += '\n';
  }
  return text;
}

std::string pwn_file(const Scan& scan) {
  std::string text = std::to_string(scan.points.size()) + '\n';
  for (const auto& p : scan.points) text += words(p) + '\n';
  for (const auto& n : scan.normals) text += words(n) + '\n';
  return text;
}

std::string off_file(const Scan& scan) {
  std::string text = "CNOFF # a sample\n# counts\n" + std::to_string(scan.points.size()) + ' ' +
                     std::to_string(scan.facets.size()) + " 0\n\n";
  for (size_t i = 0; i < scan.points.size(); ++i) {
    text += words(scan.points[i]) + ' ' + words(scan.normals[i]) + " 255 0 0 255\n";
  }
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    text += std::to_string(scan.facets[f].size());
    for (const int corner : scan.facets[f]) text += ' ' + std::to_string(corner);
    text += " 3 0.5 0.5 0.5\n";
  }
  return text;
}

std::string obj_file(const Scan& scan) {
  std::string text = "# a sample\nmtllib sample.mtl\no sample\n";
  for (const auto& p : scan.points) text += "v " + words(p) + '\n';
  text += "vt 0 0\n";
  for (const auto& n : scan.normals) text += "vn " + words(n) + '\n';
  text += "usemtl red\ns off\n";
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    text += 'f';
    for (const int corner : scan.facets[f]) {
      const std::string number = std::to_string(corner + 1);
      text += ' ' + number + (f % 2 == 0 ? "//" : "/1/") + number;
    }
    text += '\n';
  }
  return text;
}

std::string las_file(const Scan& scan, int minor, int point_format) {
  constexpr int kSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const auto count = static_cast<uint32_t>(scan.points.size());
  const size_t header_size = minor < 3 ? 227 : minor == 3 ? 235 : 375;
  const size_t size = kSizes[point_format] + 3;  // with three extra bytes
  const double scale = 0.25, offset = 100.0;
  std::string bytes(header_size + 5, '\0');
  const auto put = [&bytes](size_t at, auto value) {
    std::string raw;
    append_bytes(value, &raw);
    bytes.replace(at, raw.size(), raw);
  };
  bytes.replace(0, 4, "LASF");
  put(24, uint8_t{1});
  put(25, static_cast<uint8_t>(minor));
  put(94, static_cast<uint16_t>(header_size));
  put(96, static_cast<uint32_t>(header_size + 5));
  put(104, static_cast<uint8_t>(point_format));
  put(105, static_cast<uint16_t>(size));
  if (point_format < 6) put(107, count);
  if (minor == 4) put(247, uint64_t{count});
  for (int k = 0; k < 3; ++k) {
    put(131 + 8 * k, scale);
    put(155 + 8 * k, offset);
  }
  for (size_t i = 0; i < scan.points.size(); ++i) {
    std::string record(size, '\0');
    for (int k = 0; k < 3; ++k) {
      std::string raw;
      append_bytes(static_cast<int32_t>(std::lround((scan.points[i][k] - offset) / scale)), &raw);
      record.replace(4 * k, 4, raw);
    }
    const auto value = static_cast<char>(std::max(0, plane(scan)[i]));
    if (point_format < 6) {
      record[15] = static_cast<char>(value | 0x20);  // a key point
    } else {
      record[16] = value;
    }
    bytes += record;
  }
  return bytes;
}

std::string pcd_file(const Scan& scan, const std::string& data) {
  const std::string count = std::to_string(scan.points.size());
  std::string text =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z _ rgb normal_x normal_y normal_z plane\nSIZE 8 4 4 1 4 4 4 4 2\n"
      "TYPE F F F U U F F F I\nCOUNT 1 1 1 3 1 1 1 1 1\nWIDTH " +
      count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
  if (data == "ascii") {
    for (size_t i = 0; i < scan.points.size(); ++i) {
      text += words(scan.points[i]) + " 0 0 0 16711680 " + words(scan.normals[i]) + ' ' +
              std::to_string(plane(scan)[i]) + '\n';
    }
    return text;
  }
  std::vector<std::string> fields(9);
  std::string records;
  for (size_t i = 0; i < scan.points.size(); ++i) {
    std::vector<std::string> values(9);
    append_bytes(scan.points[i].x(), &values[0]);
    for (int k = 1; k < 3; ++k) append_bytes(static_cast<float>(scan.points[i][k]), &values[k]);
    values[3] = std::string(3, '\0');
    append_bytes(uint32_t{16711680}, &values[4]);
    for (int k = 0; k < 3; ++k) append_bytes(scan.normals[i][k], &values[5 + k]);
    append_bytes(static_cast<int16_t>(plane(scan)[i]), &values[8]);
    for (size_t f = 0; f < 9; ++f) {
      records += values[f];
      fields[f] += values[f];
    }
  }
  if (data == "binary") return text + records;
  std::string by_field;
  for (const std::string& field : fields) by_field += field;
  const std::string compressed = compress_lzf(by_field);
  append_bytes(static_cast<uint32_t>(compressed.size()), &text);
  append_bytes(static_cast<uint32_t>(by_field.size()), &text);
  return text + compressed;
}

std::string with(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  CHECK(at != std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace gable
