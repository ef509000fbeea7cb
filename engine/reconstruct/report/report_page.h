#pragma once

#include <gable/engine/reconstruct/report/house_entry.h>

#include <string>
#include <vector>

namespace gable {

/// The report's page: summary, histogram of the mean absolute difference, a table that can be
/// sorted, and the pictures. It needs nothing but the pictures beside it. Entries are shown in the
/// order given.
std::string report_page(const std::vector<HouseEntry>& entries);

}  // namespace gable
