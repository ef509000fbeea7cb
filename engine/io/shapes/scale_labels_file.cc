#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/readable.h>
#include <gable/engine/io/shapes/scale_labels_file.h>

#include <climits>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace gable {
namespace {

using Json = nlohmann::json;

constexpr char kFormat[] = "gable scale labels";
constexpr int kMostScales = 62;

void require(bool holds, const std::string& problem) {
  if (!holds) throw std::runtime_error(problem);
}

int integer(const Json& json, int64_t low, int64_t high, const std::string& what) {
  require(
      json.is_number_integer() && json.get<int64_t>() >= low && json.get<int64_t>() <= high,
      what + " is no whole number in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
  return json.get<int>();
}

ScanScaleLabels scan_labels(const Json& json, int num_scales) {
  ScanScaleLabels scan;
  scan.file = json.at("file").get<std::string>();
  const std::string who = scan.file + ": ";
  scan.labels.num_configurations =
      integer(json.at("configurations"), 1, INT_MAX, who + "\"configurations\"");
  const Json& first = json.at("first");
  require(
      first.is_array() && static_cast<int>(first.size()) == num_scales,
      who + "\"first\" has not one number for each of " + std::to_string(num_scales) + " scales");
  int least = 0;
  for (const Json& value : first) {
    least = integer(value, least, scan.labels.num_configurations, who + "a number of \"first\"");
    scan.labels.first.push_back(least);
  }
  const auto source = json.at("source").get<std::string>();
  require(source == "known" || source == "proposed",
          who + "\"source\" is neither known nor proposed");
  scan.known = source == "known";
  return scan;
}

}  // namespace

void write_scale_labels(const std::string& path, const ScaleLabelsFile& file) {
  std::string text = "{\"format\":\"" + std::string(kFormat) + "\",\"version\":1,\"scales\":";
  append_number(file.num_scales, &text);
  text += ",\n\"scans\":[";
  for (size_t i = 0; i < file.scans.size(); ++i) {
    const ScanScaleLabels& scan = file.scans[i];
    text += i == 0 ? "\n" : ",\n";
    // Names of files may hold any bytes; JSON takes those that are no UTF-8 as U+FFFD.
    text += "{\"file\":" + Json(scan.file).dump(-1, ' ', false, Json::error_handler_t::replace) +
            ",\"configurations\":";
    append_number(scan.labels.num_configurations, &text);
    text += ",\"first\":";
    append_numbers(scan.labels.first, &text);
    text += std::string(",\"source\":\"") + (scan.known ? "known" : "proposed") + "\"}";
  }
  write_file_atomically(path, text + "]}\n");
}

ScaleLabelsFile read_scale_labels(const std::string& path) {
  require_readable(path);
  std::ifstream stream(path, std::ios::binary);
  ScaleLabelsFile file;
  try {
    const Json json = Json::parse(stream);
    require(json.is_object() && json.value("format", "") == kFormat, "is no file of scale labels");
    require(json.at("version") == 1, "is of another version of gable");
    file.num_scales = integer(json.at("scales"), 1, kMostScales, "\"scales\"");
    require(json.at("scans").is_array(), "\"scans\" is no list");
    for (const Json& scan : json.at("scans")) {
      file.scans.push_back(scan_labels(scan, file.num_scales));
    }
  } catch (const std::exception& error) {
    throw Error(
        ExitCode::kBadInput,
        path + ": " + error.what() + "; correct it or write it anew with gable shapes annotate");
  }
  return file;
}

std::string name_in_labels(const std::string& scan, const std::string& labels) {
  namespace fs = std::filesystem;
  const auto place = [](const fs::path& path) {
    std::error_code none;  // what does not exist yet has a place as well
    return fs::weakly_canonical(fs::absolute(path, none), none);
  };
  return place(scan).lexically_proximate(place(labels).parent_path()).generic_string();
}

}  // namespace gable
