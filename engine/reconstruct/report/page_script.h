#pragma once

namespace gable {

/// Script of the report's page: sorts the table and the pictures by a clicked column.
extern const char* const kPageScript;

}  // namespace gable
