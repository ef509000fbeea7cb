#pragma once

#include <span>

namespace gable {

/// How far two labelings of the same elements agree: the adjusted Rand index (Hubert and Arabie
/// 1985, eq. 5), 1 for the same partition, 0 on average for independent ones. Over pairs of
/// elements: (both together - expected) / (mean of together in either - expected). Labels are any
/// numbers; elements of one number, -1 too, are one class. 1 where both are one class, or both have
/// every element alone, or there is no element. Sizes must be equal.
double adjusted_rand_index(std::span<const int> a, std::span<const int> b);

}  // namespace gable
