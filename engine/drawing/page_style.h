#pragma once

namespace gable {

/// Style sheet of a report's page: `section`s and `figure`s as cards, tables of figures, pictures
/// in a grid.
extern const char* const kPageStyle;

}  // namespace gable
