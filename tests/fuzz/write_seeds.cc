// write_seeds FOLDER: the seed corpus of every reader, FOLDER/<reader>/<number>.

#include <filesystem>
#include <fstream>
#include <map>

#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

std::map<std::string, std::vector<std::string>> seeds() {
  const Scan cloud = sample_cloud(), mesh = sample_mesh();
  std::map<std::string, std::vector<std::string>> out;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    out["ply"].push_back(ply_file(cloud, format));
    out["ply"].push_back(ply_file(mesh, format));
  }
  out["xyz"] = {xyz_file(cloud, false), xyz_file(cloud, true), "x,y,z\n1,2,3\n",
                "// x y z r g b\n1 2 3 9 9 9\nnan 0 0 9 9 9\n"};
  out["pwn"] = {pwn_file(cloud), xyz_file(cloud, true)};
  out["off"] = {off_file(mesh), off_file(cloud), "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"};
  out["obj"] = {obj_file(mesh), obj_file(cloud), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 \\\n -1\n"};
  for (const int format : {0, 1, 2, 3, 4, 5}) out["las"].push_back(las_file(cloud, 2, format));
  for (const int format : {1, 6, 7, 8, 9, 10}) out["las"].push_back(las_file(cloud, 4, format));
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    out["pcd"].push_back(pcd_file(cloud, data));
  }
  return out;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const auto& [reader, files] : gable::seeds()) {
    const auto folder = std::filesystem::path(argv[1]) / reader;
    std::filesystem::create_directories(folder);
    for (size_t i = 0; i < files.size(); ++i) {
      std::ofstream(folder / std::to_string(i), std::ios::binary) << files[i];
    }
  }
}
