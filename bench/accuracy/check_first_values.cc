// What the sources of first values are worth on annotated real houses: the classical search, the
// detectors and the structural scales alone, each without one, and all together. Prints of each the
// foundation accuracy with its confusion matrix, the mean distances from the heights and the time
// per building on one thread.
//   gable_check_first_values ANNOTATIONS DETECTORS DSM [--dtm FILE] [--footprints FILE]
//       [--weight W]... [--skip P] [--least-confidence C] [--finalists N]
//       [--only SOURCES] [--verbose]

#include <gable/engine/error.h>
#include <gable/engine/io/answers/annotations_file.h>
#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gable {
namespace {

struct Arguments {
  std::string annotations, detectors, dsm, dtm, footprints;
  std::vector<double> weights;
  double skip = 0.0;
  double least_confidence = DetectedValuesOptions{}.least_confidence;
  int finalists = HouseChoiceOptions{}.finalists;
  std::string only;  ///< name of a combination of sources; empty: all
  bool verbose = false;
};

/// A building of the raster that somebody annotated.
struct Subject {
  std::string id;
  HeightImage image;
  std::optional<PlanPolygon> outline;
  Foundation truth;
  DetectedValues detected;
};

/// Time of the processor, which other programs do not lengthen.
double cpu_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string name_of(Foundation foundation) { return std::string(foundation_name(foundation)); }

/// The annotation of a building, sure enough, or null.
const AnnotatedHouse* annotation_of(const AnnotatedTile& tile, const std::string& id,
                                    const HeightImage& image) {
  const AnnotatedHouse* nearest = nullptr;
  double least = 3.0;  // metres; more is another building
  for (const AnnotatedHouse& house : tile.houses) {
    if (house.id == id) {
      nearest = &house;
      break;
    }
    const double distance = (house.center - image.origin.head<2>()).norm();
    if (distance < least) {
      least = distance;
      nearest = &house;
    }
  }
  return nearest && nearest->confidence != Confidence::kLow ? nearest : nullptr;
}

std::vector<Subject> subjects_of(const Arguments& arguments) {
  const AnnotatedTile tile = read_annotations(arguments.annotations);
  const RasterFile dsm(arguments.dsm, {});
  std::optional<RasterFile> dtm;
  if (!arguments.dtm.empty()) dtm.emplace(arguments.dtm, RasterFileOptions{});
  TileInput input{&dsm, dtm ? &*dtm : nullptr, nullptr, nullptr};
  FootprintFile footprints;
  if (!arguments.footprints.empty()) {
    footprints = read_footprints(arguments.footprints, dsm.crs(), dsm.grid());
    input.footprints = &footprints.footprints;
  }
  DetectorNets nets(arguments.detectors);
  DetectedValuesOptions options;
  options.least_confidence = arguments.least_confidence;
  std::vector<Subject> subjects;
  double ms = 0.0;
  visit_tile(input, {}, {}, {},
             [&](const std::string& id, const PlanPolygon* outline, TileBuilding* building) {
               const AnnotatedHouse* house = annotation_of(tile, id, building->image);
               if (!house) return;
               Subject subject{id, building->image, {}, house->foundation, {}};
               if (outline) subject.outline = *outline;
               const double start = cpu_ms();
               subject.detected = detect_values(subject.image, &nets, options);
               ms += cpu_ms() - start;
               subjects.push_back(std::move(subject));
             });
  int right = 0, right_house = 0, houses = 0;
  for (const Subject& s : subjects) {
    const auto& p = s.detected.foundation;
    right += std::max_element(p.begin(), p.end()) - p.begin() == static_cast<int>(s.truth);
    if (s.truth == Foundation::kC) continue;
    ++houses;
    right_house +=
        std::max_element(p.begin(), p.end() - 1) - p.begin() == static_cast<int>(s.truth);
  }
  const double n = static_cast<double>(subjects.size());
  std::printf(
      "%zu houses of high or medium confidence; classifier alone: %.1f %% of all, "
      "%.1f %% of the %d within the grammar; %.1f ms each\n",
      subjects.size(), 100.0 * right / n, 100.0 * right_house / std::max(houses, 1), houses,
      ms / n);
  return subjects;
}

/// Which sources are asked.
struct Sources {
  const char* name;
  bool classical, detectors, scales;
};

constexpr Sources kSources[] = {{"classical", true, false, false},
                                {"detectors", false, true, false},
                                {"scales", false, false, true},
                                {"classical, detectors", true, true, false},
                                {"classical, scales", true, false, true},
                                {"detectors, scales", false, true, true},
                                {"all", true, true, true}};

void compare(const Sources& sources, const std::vector<Subject>& subjects, BuildingOptions options,
             bool verbose) {
  options.choice.classical = sources.classical;
  options.scales = sources.scales;
  int confusion[kNumFoundations][kNumFoundationTypes] = {};
  int right = 0, right_house = 0, houses = 0, extrusions = 0;
  int from[kNumValueSources] = {};
  std::vector<double> mads;
  const double start = cpu_ms();
  for (const Subject& s : subjects) {
    const DetectValues source = [&](const HeightImage&) { return s.detected; };
    const ReconstructedBuilding made =
        reconstruct_building(s.id, s.image, s.outline ? &*s.outline : nullptr, options,
                             sources.detectors ? source : DetectValues{});
    const Foundation found = made.building.house ? made.building.house->foundation : Foundation::kC;
    ++confusion[static_cast<int>(s.truth)][static_cast<int>(found)];
    // What has more than three blocks is C to annotators.
    right += found == s.truth || (found == Foundation::kMany && s.truth == Foundation::kC);
    houses += s.truth != Foundation::kC;
    right_house += s.truth != Foundation::kC && found == s.truth;
    extrusions += found == Foundation::kC;
    if (made.building.house) ++from[static_cast<int>(made.choice.best.source)];
    mads.push_back(made.building.quality.mad);
    if (verbose && found != s.truth) {
      std::printf("  %s: %s taken for %s:", s.id.c_str(), name_of(s.truth).c_str(),
                  name_of(found).c_str());
      for (const Candidate& c : made.choice.finalists) {
        std::printf(" %s=%.0f(%c)", name_of(c.house.foundation).c_str(), c.cost.total,
                    value_source_name(c.source).front());
      }
      std::printf("  P");
      for (const float p : s.detected.foundation) std::printf(" %.2f", p);
      std::printf("\n");
    }
  }
  const double ms = cpu_ms() - start;
  const double n = static_cast<double>(subjects.size());
  std::sort(mads.begin(), mads.end());
  const double mean = std::accumulate(mads.begin(), mads.end(), 0.0) / n;
  const auto under = std::lower_bound(mads.begin(), mads.end(), 0.4) - mads.begin();
  std::printf(
      "%-22s foundation %.1f %% (%.1f %% within the grammar), MAD median %.3f mean %.3f m, "
      "under 0.40 m %.1f %%, %d extrusions, winners from classical %d, detectors %d, scales %d, "
      "%.1f ms each\n",
      sources.name, 100.0 * right / n, 100.0 * right_house / std::max(houses, 1),
      mads[mads.size() / 2], mean, 100.0 * static_cast<double>(under) / n, extrusions, from[0],
      from[1], from[2], ms / n);
  std::printf("  truth \\ found   I   II  III    L    U    C    N\n");
  for (int t = 0; t < kNumFoundations; ++t) {
    std::printf("%15s", name_of(static_cast<Foundation>(t)).c_str());
    for (const int count : confusion[t]) std::printf(" %4d", count);
    std::printf("\n");
  }
  std::fflush(stdout);
}

int run(const Arguments& arguments) {
  const std::vector<Subject> subjects = subjects_of(arguments);
  if (subjects.empty()) {
    std::fprintf(stderr, "no annotated house in %s\n", arguments.dsm.c_str());
    return 1;
  }
  BuildingOptions options;
  options.choice.skipped_probability = arguments.skip;
  options.choice.finalists = arguments.finalists;
  std::vector<double> weights = arguments.weights;
  if (weights.empty()) weights = {options.choice.type_weight};
  for (const double weight : weights) {
    options.choice.type_weight = weight;
    if (weights.size() > 1) std::printf("weight of the types %g\n", weight);
    for (const Sources& sources : kSources) {
      if (!arguments.only.empty() && arguments.only != sources.name) continue;
      compare(sources, subjects, options, arguments.verbose);
    }
  }
  return 0;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  gable::Arguments arguments;
  std::vector<std::string> plain;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    const auto value = [&]() -> std::string { return i + 1 < argc ? argv[++i] : ""; };
    if (key == "--dtm") {
      arguments.dtm = value();
    } else if (key == "--footprints") {
      arguments.footprints = value();
    } else if (key == "--weight") {
      arguments.weights.push_back(std::atof(value().c_str()));
    } else if (key == "--skip") {
      arguments.skip = std::atof(value().c_str());
    } else if (key == "--least-confidence") {
      arguments.least_confidence = std::atof(value().c_str());
    } else if (key == "--finalists") {
      arguments.finalists = std::atoi(value().c_str());
    } else if (key == "--only") {
      arguments.only = value();
    } else if (key == "--verbose") {
      arguments.verbose = true;
    } else {
      plain.push_back(key);
    }
  }
  if (plain.size() != 3) {
    std::fprintf(stderr, "usage: gable_check_first_values ANNOTATIONS DETECTORS DSM [options]\n");
    return 2;
  }
  arguments.annotations = plain[0];
  arguments.detectors = plain[1];
  arguments.dsm = plain[2];
  try {
    return gable::run(arguments);
  } catch (const gable::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.code());
  }
}
