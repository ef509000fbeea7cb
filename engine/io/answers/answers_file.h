#pragma once

#include <gable/engine/house_answer.h>

#include <string>

namespace gable {

/// Writes the editable list of buildings: every member on a line of its own. Throws Error
/// (kCannotWrite).
void write_answers(const std::string& path, const HouseAnswers& answers);

/// Reads the list as somebody edited it. Only what cannot be understood is refused here; whether an
/// answer makes a building is for `annotated_from_answer`. Throws Error: kNoInput where the file
/// cannot be opened; kBadInput, naming the building and the member.
HouseAnswers read_answers(const std::string& path);

}  // namespace gable
