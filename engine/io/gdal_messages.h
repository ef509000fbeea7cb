#pragma once

#include <string>

namespace gable {

/// While it lives, GDAL's messages on this thread are kept here instead of going to stderr. The
/// first one also registers GDAL's drivers, once for the process. Objects nest like scopes.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// Whether GDAL reported a failure (not only warnings).
  bool failed() const { return failed_; }
  /// The first failure's text on one line, or "".
  const std::string& text() const { return text_; }
  /// " (text)" for the end of a message of our own, or "".
  std::string suffix() const { return text_.empty() ? "" : " (" + text_ + ")"; }

  /// Called by GDAL.
  void add(bool failure, const char* message);

 private:
  bool failed_ = false;
  std::string text_;
};

}  // namespace gable
