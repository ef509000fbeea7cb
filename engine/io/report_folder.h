#pragma once

#include <gable/engine/drawing/report_file.h>

#include <span>
#include <string>

namespace gable {

/// Writes a report into a folder, made where it is missing, in the order given: a page comes after
/// what it shows. Every file appears complete or not at all. Throws Error (kCannotWrite).
void write_report(const std::string& folder, std::span<const ReportFile> files);

}  // namespace gable
