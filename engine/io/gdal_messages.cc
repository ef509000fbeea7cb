#include <cpl_error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gdal.h>

#include <algorithm>
#include <mutex>

namespace gable {
namespace {

void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* message) {
  if (level == CE_Debug) return;
  static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->add(level >= CE_Failure, message);
}

}  // namespace

GdalMessages::GdalMessages() {
  CPLPushErrorHandlerEx(collect, this);
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
}

GdalMessages::~GdalMessages() { CPLPopErrorHandler(); }

void GdalMessages::add(bool failure, const char* message) {
  if (!failure || failed_) return;
  failed_ = true;
  text_ = message;
  std::replace(text_.begin(), text_.end(), '\n', ' ');
}

}  // namespace gable
