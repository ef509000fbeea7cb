// Whole tiles: runs that are killed at random moments and resumed against one that is not, and the
// memory and time of reconstruction on rasters of growing size and with growing numbers of houses.
// Runs the program gable beside this one, in a folder that it makes and removes.
//   gable_check_tiles [kills] [seed] [cells along a side of the largest raster] [folder]

#include <gable/engine/io/raster/raster_writer.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/village.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace gable {
namespace {

namespace fs = std::filesystem;

struct Run {
  bool finished = false;
  double seconds = 0.0;
  double peak_mib = 0.0;
};

std::string program() { return fs::read_symlink("/proc/self/exe").parent_path() / "gable"; }

/// Runs gable; kills it after `seconds`, where that is not negative.
Run run_gable(std::vector<std::string> arguments, double seconds = -1.0) {
  arguments.insert(arguments.begin(), program());
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const Stopwatch watch;
  const pid_t child = fork();
  if (child == 0) {
    execv(pointers.front(), pointers.data());
    _exit(127);
  }
  if (seconds >= 0.0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    kill(child, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  Run run;
  run.finished = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  run.seconds = 1e-3 * watch.ms();
  run.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return run;
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(stream), {}};
  }
  return files;
}

Village village_of(int count) {
  VillageOptions options;
  options.count = count;
  options.seed = 7;
  return synthesize_village(options);
}

/// Kills runs at random moments and resumes them; those that end before are begun anew.
bool check_kills(const fs::path& folder, int num_kills, uint64_t seed) {
  const Village village = village_of(24);
  const Crs crs = crs_from_text("EPSG:27700");
  write_raster(folder / "dsm.tif", village.dsm, crs);
  write_raster(folder / "dtm.tif", village.dtm, crs);
  const auto arguments = [&](const std::string& output) {
    return std::vector<std::string>{
        "reconstruct", folder / "dsm.tif", "--dtm", folder / "dtm.tif",  "--window", "96",
        "--quiet",     "--resume",         "-o",    folder / output / ""};
  };
  const Run undisturbed = run_gable(arguments("undisturbed"));
  const auto files = files_of(folder / "undisturbed");
  bool same = undisturbed.finished;
  Random random(seed);
  int killed = 0, resumed = 0;
  while (same && killed < num_kills) {
    const bool finished =
        run_gable(arguments("killed"), random.uniform(0.0, 0.6 * undisturbed.seconds)).finished;
    if (finished) {
      ++resumed;
      same = files_of(folder / "killed") == files;
      fs::remove_all(folder / "killed");
    } else {
      ++killed;
    }
  }
  same = same && run_gable(arguments("killed")).finished && files_of(folder / "killed") == files;
  std::printf("killed %d times and resumed, to the end %d times: %zu files, %s\n", killed,
              resumed + 1, files.size(), same ? "the same bytes" : "OTHER BYTES");
  return same;
}

/// A gently sloping, slightly rough plain with copies of a village on it.
HeightRaster plain_with(const Village& village, int cells, int copies) {
  const Grid& part = village.dsm.grid;
  HeightRaster raster({part.north_west, part.gsd, cells, cells}, 0.0f);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const int noise = (row * 7919 + col * 104729) % 101;
      raster.at(row, col) = 20.0f + 0.002f * static_cast<float>(row) + 0.0005f * noise;
    }
  }
  const int across = static_cast<int>(std::ceil(std::sqrt(copies)));
  for (int k = 0; k < copies; ++k) {
    const int row0 = cells / across * (k / across), col0 = cells / across * (k % across);
    for (int row = 0; row < std::min(part.rows, cells - row0); ++row) {
      for (int col = 0; col < std::min(part.cols, cells - col0); ++col) {
        raster.at(row0 + row, col0 + col) = village.dsm.at(row, col);
      }
    }
  }
  return raster;
}

bool check_memory(const fs::path& folder, int most_cells) {
  constexpr double kMostMib = 1024.0;
  const Village village = village_of(25);
  const Crs crs = crs_from_text("EPSG:27700");
  bool within = true;
  std::printf("%8s %8s %10s %10s\n", "cells", "houses", "seconds", "peak MiB");
  for (const auto& [cells, copies] : {std::pair{most_cells / 4, 1},
                                      {most_cells / 2, 1},
                                      {most_cells, 1},
                                      {most_cells, 4},
                                      {most_cells, 16}}) {
    write_raster(folder / "plain.tif", plain_with(village, cells, copies), crs);
    fs::remove_all(folder / "plain");
    const Run run =
        run_gable({"reconstruct", folder / "plain.tif", "--quiet", "-o", folder / "plain" / ""});
    std::printf("%8d %8d %10.1f %10.0f%s\n", cells, 25 * copies, run.seconds, run.peak_mib,
                run.finished ? "" : "  FAILED");
    std::fflush(stdout);
    within = within && run.finished && run.peak_mib < kMostMib;
  }
  return within;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  const int num_kills = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto seed = static_cast<uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const int cells = argc > 3 ? std::atoi(argv[3]) : 10000;
  const std::filesystem::path parent =
      argc > 4 ? std::filesystem::path(argv[4]) : std::filesystem::temp_directory_path();
  const std::filesystem::path folder = parent / ("gable-check-tiles-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const bool same = num_kills == 0 || gable::check_kills(folder, num_kills, seed);
  const bool within = cells == 0 || gable::check_memory(folder, cells);
  std::filesystem::remove_all(folder);
  return same && within ? 0 : 1;
}
