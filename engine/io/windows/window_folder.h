#pragma once

#include <gable/engine/io/models/model_writer.h>
#include <gable/engine/io/windows/window_manifest.h>

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace gable {

/// A folder of models, one CityJSONSeq file per window, and `manifest.json`, which says what they
/// were made of and which windows are done. A window's file appears when it is complete, then the
/// manifest is replaced: a run may end at any moment, and the next one goes on with the windows
/// that are not done. Windows without buildings have no file. All files have the same first line.
class WindowFolder {
 public:
  /// `manifest` with no window done. Where `resume`, the windows that the folder has are kept, and
  /// what an earlier run left unfinished is removed. Throws Error: kCannotWrite; kUsage, with the
  /// remedy, where the folder has models and not `resume`, or models of something else, or where
  /// another run is at work in it.
  WindowFolder(const std::string& folder, WindowManifest manifest,
               const ModelWriterOptions& options, bool resume);
  ~WindowFolder();
  WindowFolder(const WindowFolder&) = delete;
  WindowFolder& operator=(const WindowFolder&) = delete;

  const WindowManifest& manifest() const { return manifest_; }
  /// Whether the window is done; by its place in the manifest.
  bool is_done(size_t window) const { return manifest_.windows[window].done; }

  /// Adds a building to the window that is being worked on. Throws Error (kCannotWrite).
  void append(size_t window, const Building& building, const BuildingModel& model);
  /// The window has all its buildings; `counts` says what was left out. Throws Error
  /// (kCannotWrite).
  void finish(size_t window, const ManifestWindow& counts);

 private:
  void lock();
  void take_over(bool resume);
  void remove_unfinished() const;
  void write_manifest() const;
  std::string path_of(const std::string& name) const;

  std::string folder_;
  WindowManifest manifest_;
  ModelWriterOptions options_;
  int lock_ = -1;
  std::unique_ptr<ModelWriter> writer_;      ///< of the window that is being worked on
  std::map<std::string, size_t> buildings_;  ///< of this window, by status
};

}  // namespace gable
