#include <gable/engine/io/report_folder.h>
#include <gtest/gtest.h>

#include <vector>

#include "engine/io/scratch.h"

namespace gable {
namespace {

TEST(ReportFolder, IsMadeAndFilled) {
  const ScratchFolder scratch;
  const std::vector<ReportFile> files{{"a.png", std::string("\0\1", 2)}, {"index.html", "<p>"}};
  const std::string folder = scratch.path("deep/report");
  write_report(folder, files);
  write_report(folder, files);
  EXPECT_EQ(file_bytes(folder + "/a.png"), files[0].bytes);
  EXPECT_EQ(file_bytes(folder + "/index.html"), "<p>");
}

TEST(ReportFolder, NamesAFolderThatCannotBeMade) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("file", "no folder");
  for (const std::string& folder : {file, file + "/report"}) {
    const Error error = error_of(
        [&] {
          write_report(folder, std::vector<ReportFile>{{"a", "b"}});
        },
        file);
    EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
  }
}

}  // namespace
}  // namespace gable
