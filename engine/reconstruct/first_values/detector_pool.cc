#include <gable/engine/reconstruct/first_values/detector_pool.h>

namespace gable {

DetectorPool::DetectorPool(const std::string& folder) : folder_(folder) {
  free_.push_back(std::make_unique<DetectorNets>(folder));
}

DetectorPool::Loan DetectorPool::lend() {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      std::unique_ptr<DetectorNets> nets = std::move(free_.back());
      free_.pop_back();
      return {this, std::move(nets)};
    }
  }
  return {this, std::make_unique<DetectorNets>(folder_)};
}

void DetectorPool::give_back(std::unique_ptr<DetectorNets> nets) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(nets));
}

}  // namespace gable
