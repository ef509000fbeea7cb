#pragma once

#include <string>

namespace gable {

/// Text with the five characters that HTML reserves replaced.
std::string html_escaped(const std::string& text);

}  // namespace gable
