#pragma once

namespace gable {

/// Style sheet of the report's page.
extern const char* const kPageStyle;

/// Script of the report's page: sorts the table and the pictures by a clicked column.
extern const char* const kPageScript;

}  // namespace gable
