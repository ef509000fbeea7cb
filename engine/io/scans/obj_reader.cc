#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/obj_reader.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <charconv>
#include <climits>

namespace gable {
namespace {

constexpr int kNone = -1;

/// What the lines say, before normals are the points'.
struct Lines {
  Scan scan;
  std::vector<Eigen::Vector3f> normals;
  std::vector<int> corner_normals;  ///< per corner of all facets: its normal, or kNone
};

/// A 1-based or negative index in front of `text`, as one from 0; moves `text` behind it.
int read_index(const TextCursor& line, std::string_view* text, size_t count) {
  int64_t index = 0;
  const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), index);
  if (error != std::errc()) line.refuse("a corner of a facet is no index");
  text->remove_prefix(stop - text->data());
  const int64_t from_zero = index > 0 ? index - 1 : index + static_cast<int64_t>(count);
  if (index == 0 || from_zero < 0 || from_zero > INT_MAX) {
    line.refuse("a facet uses a point that is not there");
  }
  return static_cast<int>(from_zero);
}

/// a, a/b, a//c or a/b/c.
void read_corner(const TextCursor& line, std::string_view word, std::vector<int>* corners,
                 Lines* lines) {
  corners->push_back(read_index(line, &word, lines->scan.points.size()));
  int normal = kNone;
  const size_t second = word.find('/', word.empty() ? 0 : 1);
  if (!word.empty() && word[0] != '/') line.refuse("a corner of a facet is no index");
  if (second != std::string_view::npos && second + 1 < word.size()) {
    word.remove_prefix(second + 1);
    normal = read_index(line, &word, lines->normals.size());
  }
  lines->corner_normals.push_back(normal);
}

Lines read_lines(std::string_view bytes, const std::string& path) {
  Lines lines;
  TextCursor cursor(bytes, path, '#');
  std::vector<int> corners;
  for (; cursor.find_word(); cursor.skip_line()) {
    const std::string_view keyword = cursor.word();
    const auto next = [&](const char* what) {
      if (!cursor.find_word_in_line()) cursor.refuse(std::string(what) + " is missing");
      return cursor.number(what);
    };
    if (keyword == "v") {
      Eigen::Vector3d point;
      for (int k = 0; k < 3; ++k) point[k] = next("a coordinate");
      lines.scan.points.push_back(point);
    } else if (keyword == "vn") {
      Eigen::Vector3f normal;
      for (int k = 0; k < 3; ++k) normal[k] = static_cast<float>(next("a normal"));
      lines.normals.push_back(normal);
    } else if (keyword == "f") {
      corners.clear();
      while (cursor.find_word_in_line()) {
        const std::string_view word = cursor.word();
        if (word == "\\") {  // the line goes on in the next
          cursor.skip_line();
          continue;
        }
        read_corner(cursor, word, &corners, &lines);
      }
      lines.scan.facets.add(corners);
    }
  }
  return lines;
}

/// The mean normal of every point's corners; none at all where no corner has one.
std::vector<Eigen::Vector3f> point_normals(const Lines& lines, const std::string& path) {
  const Scan& scan = lines.scan;
  if (!scan.is_mesh()) {
    return lines.normals.size() == scan.points.size() ? lines.normals
                                                      : std::vector<Eigen::Vector3f>();
  }
  if (lines.normals.empty()) return {};
  std::vector<Eigen::Vector3f> normals(scan.points.size(), Eigen::Vector3f::Zero());
  size_t i = 0;
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    for (const int corner : scan.facets[f]) {
      const int normal = lines.corner_normals[i++];
      if (normal == kNone || static_cast<size_t>(corner) >= normals.size()) continue;
      if (static_cast<size_t>(normal) >= lines.normals.size()) {
        refuse_scan(
            path, "facet " + std::to_string(f + 1) + " uses a normal that the file does not have");
      }
      normals[corner] += lines.normals[normal];
    }
  }
  return normals;
}

}  // namespace

ScanFile read_obj(std::string_view bytes, const std::string& path) {
  Lines lines = read_lines(bytes, path);
  lines.scan.normals = point_normals(lines, path);
  return finish_scan(std::move(lines.scan), path);
}

}  // namespace gable
