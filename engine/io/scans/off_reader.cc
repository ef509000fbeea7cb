#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/off_reader.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <climits>

namespace gable {
namespace {

/// The keyword says what follows a point's coordinates. Returns whether normals do; what remains of
/// the text starts with the counts, which some programs write right behind the keyword.
bool read_keyword(std::string_view* text, const std::string& path) {
  TextCursor cursor(*text, path, '#');
  cursor.find_word();
  std::string_view rest = cursor.rest();
  bool normals = false;
  if (rest.starts_with("ST")) rest.remove_prefix(2);
  if (rest.starts_with("C")) rest.remove_prefix(1);
  if (rest.starts_with("N")) {
    rest.remove_prefix(1);
    normals = true;
  }
  if (rest.starts_with("4OFF") || rest.starts_with("nOFF") || rest.starts_with("4nOFF")) {
    refuse_scan(path, "has points of other than three dimensions", "export three");
  }
  if (!rest.starts_with("OFF")) {
    refuse_scan(path, "is no OFF file: it does not start with OFF", "check the extension");
  }
  rest.remove_prefix(3);
  TextCursor after(rest, path, '#');
  if (after.find_word_in_line() && after.rest().starts_with("BINARY")) {
    refuse_scan(path, "is a binary OFF file", "export it as ascii OFF or as PLY");
  }
  *text = rest;
  return normals;
}

}  // namespace

ScanFile read_off(std::string_view bytes, const std::string& path) {
  std::string_view text = bytes;
  const bool normals = read_keyword(&text, path);
  // From the start of the file, so that messages count lines from there.
  TextCursor cursor(bytes, path, '#');
  cursor.skip(bytes.size() - text.size());
  const int64_t num_points = cursor.integer("the number of points");
  const int64_t num_facets = cursor.integer("the number of facets");
  cursor.skip_line();
  // A point takes at least "0 0 0\n", a facet "0\n".
  if (num_points < 0 || num_points > INT_MAX || num_facets < 0 || num_facets > INT_MAX ||
      num_points * 6 + num_facets * 2 > static_cast<int64_t>(cursor.bytes_left()) + 1) {
    refuse_scan(path,
                "announces " + std::to_string(num_points) + " points and " +
                    std::to_string(num_facets) + " facets, more than the file can hold",
                "the file is truncated or damaged, export it again");
  }

  Scan scan;
  scan.points.resize(num_points);
  if (normals) scan.normals.resize(num_points);
  for (int64_t i = 0; i < num_points; ++i) {
    for (int k = 0; k < 3; ++k) scan.points[i][k] = cursor.number("a coordinate");
    if (normals) {
      for (int k = 0; k < 3; ++k) {
        scan.normals[i][k] = static_cast<float>(cursor.number("a normal"));
      }
    }
    cursor.skip_line();
  }
  std::vector<int> corners;
  for (int64_t i = 0; i < num_facets; ++i) {
    const int64_t size = cursor.integer("a number of corners");
    if (size < 0 || size * 2 > static_cast<int64_t>(cursor.bytes_left()) + 1) {
      cursor.refuse("a facet has more corners than the file can hold");
    }
    corners.resize(size);
    for (int& corner : corners) {
      const int64_t index = cursor.integer("a point of a facet");
      if (index < 0 || index >= num_points) cursor.refuse("a facet uses a point that is not there");
      corner = static_cast<int>(index);
    }
    scan.facets.add(corners);
    cursor.skip_line();
  }
  return finish_scan(std::move(scan), path);
}

}  // namespace gable
