#pragma once

#include <gable/engine/detectors/detector_nets.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gable {

/// Networks for as many threads as ask at once. The first instance is loaded at the start, so that
/// a file that is missing or damaged is known before any work is done; others when all are lent.
class DetectorPool {
 public:
  /// Throws Error as DetectorNets does.
  explicit DetectorPool(const std::string& folder);

  /// An instance of one thread's own until it is dropped; the pool must outlive it.
  class Loan {
   public:
    Loan(DetectorPool* pool, std::unique_ptr<DetectorNets> nets)
        : pool_(pool), nets_(std::move(nets)) {}
    ~Loan() {
      if (nets_) pool_->give_back(std::move(nets_));
    }
    Loan(Loan&&) noexcept = default;
    Loan& operator=(Loan&&) = delete;

    DetectorNets* get() const { return nets_.get(); }

   private:
    DetectorPool* pool_;
    std::unique_ptr<DetectorNets> nets_;
  };

  /// Any thread may ask. Throws Error where a further instance cannot be loaded.
  Loan lend();

 private:
  void give_back(std::unique_ptr<DetectorNets> nets);

  const std::string folder_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<DetectorNets>> free_;
};

}  // namespace gable
