#include <gable/engine/error.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/parallel_ranges.h>
#include <gable/grammar/random.h>
#include <gable/training/scans/cityjson_surfaces.h>
#include <gable/training/scans/object_class.h>
#include <gable/training/scans/random_sampling.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace gable {
namespace {

/// Floors of solids lie on the ground, where no scanner sees them.
constexpr double kSeenFromAbove = -0.2;

struct MakeScansOptions {
  std::string object_class, folder, city_json;
  int count = 1;
  uint64_t seed = 1;
  int threads = 0;
  std::optional<int> points;
  std::optional<double> noise_percent, outlier_percent;
};

/// A scan to be made.
struct Recipe {
  std::string name;
  uint64_t surface_seed = 0;
  size_t building = 0;  ///< of the city model
  SampleOptions sampling;
};

std::string numbered(const std::string& stem, int number) {
  char text[32];
  std::snprintf(text, sizeof(text), "-%04d", number);
  return stem + text;
}

std::string file_stem(std::string id) {
  for (char& c : id) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  }
  return id;
}

std::vector<size_t> shuffled(size_t count, Random random) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  for (size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[random.integer(0, static_cast<int>(i) - 1)]);
  }
  return order;
}

/// A scan's recipe depends on the seed and its number alone, not on how many are made.
std::vector<Recipe> recipes_of(const MakeScansOptions& options,
                               const std::vector<BuildingSurface>& buildings) {
  Random random(options.seed);
  const std::vector<size_t> order = shuffled(buildings.size(), random.fork());
  const bool from_city = !options.city_json.empty();
  const int count =
      from_city ? std::min(options.count, static_cast<int>(buildings.size())) : options.count;
  std::vector<Recipe> recipes(count);
  for (int i = 0; i < count; ++i) {
    Random own = random.fork();
    Recipe& recipe = recipes[i];
    recipe.surface_seed = own.next();
    recipe.sampling = random_sampling(&own);
    if (options.points) recipe.sampling.num_points = *options.points;
    if (options.noise_percent) recipe.sampling.noise = *options.noise_percent / 100.0;
    if (options.outlier_percent) recipe.sampling.outlier_share = *options.outlier_percent / 100.0;
    recipe.name = numbered(options.object_class, i + 1);
    if (from_city) {
      recipe.building = order[i];
      recipe.name = file_stem(buildings[order[i]].id);
      recipe.sampling.least_normal_z = kSeenFromAbove;
    }
  }
  return recipes;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ExitCode::kCannotWrite, folder + ": " + error.message());
}

void run(const MakeScansOptions& options) {
  const auto& classes = object_classes();
  const auto made = std::find_if(classes.begin(), classes.end(), [&](const ObjectClass& c) {
    return c.name == options.object_class;
  });
  std::vector<BuildingSurface> buildings;
  if (!options.city_json.empty()) buildings = read_cityjson_surfaces(options.city_json).buildings;
  const std::vector<Recipe> recipes = recipes_of(options, buildings);
  make_folder(options.folder);
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::mutex mutex;
  std::exception_ptr failure;
  const auto make = [&](size_t begin, size_t) {
    try {
      const Recipe& recipe = recipes[begin];
      const LabelledSurface surface = buildings.empty() ? made->random_surface(recipe.surface_seed)
                                                        : buildings[recipe.building].surface;
      const std::filesystem::path file =
          std::filesystem::path(options.folder) / (recipe.name + ".ply");
      write_scan_ply(file.string(), sample_surface(surface, recipe.sampling));
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
  };
  for_ranges(recipes.size(), threads, make, 1);
  if (failure) std::rethrow_exception(failure);
  std::cout << options.folder << ": " << recipes.size() << " scans\n";
}

int run_program(int argc, char** argv) {
  CLI::App app{
      "Make scans with known planes at three structural scales (labels scale_1 to scale_3):\n"
      "clouds sampled from random objects, or from the buildings of a city model. What is not\n"
      "given is drawn anew for each scan: noise 0, 0.2, 0.5 or 1 % of the bounding box diagonal,\n"
      "outliers 0, 2 or 5 %, 30,000 to 143,000 points.",
      "gable_make_scans"};
  MakeScansOptions options;
  std::vector<std::string> names;
  for (const ObjectClass& known : object_classes()) names.push_back(known.name);
  app.add_option("class", options.object_class, "Class of objects")
      ->type_name("CLASS")
      ->required()
      ->check(CLI::IsMember(names));
  app.add_option("count", options.count, "Scans; of a city model at most as many as buildings")
      ->type_name("COUNT")
      ->required()
      ->check(CLI::Range(1, 1000000));
  app.add_option("--seed", options.seed, "The same seed gives the same files")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("-o,--output", options.folder, "Folder for the scans, binary PLY")
      ->type_name("DIR")
      ->required();
  app.add_option("--points", options.points, "Points of every scan")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000000));
  app.add_option("--noise", options.noise_percent, "Noise of every scan, % of the diagonal")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--outliers", options.outlier_percent, "Outliers of every scan, % of the points")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--cityjson", options.city_json,
                 "Buildings of this CityJSON file (levels of detail 2.2 and 1.2), in random order")
      ->type_name("FILE");
  app.add_option("--threads", options.threads, "Threads; 0: one per core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  try {
    app.parse(argc, argv);
    run(options);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "gable_make_scans: " << error.what() << std::endl;
    return static_cast<int>(ExitCode::kUsage);
  } catch (const Error& error) {
    std::cerr << "gable_make_scans: " << error.what() << std::endl;
    return static_cast<int>(error.code());
  }
  return 0;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) { return gable::run_program(argc, argv); }
