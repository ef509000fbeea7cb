#pragma once

#include <gable/engine/scales/train_scales.h>

#include <string>

namespace gable {

/// How well a trained model labels what it was trained on and the rest: accuracies, per scale the
/// median distances of its beginnings, and the confusion of the labels.
std::string training_text(const ScaleTraining& training);

/// A card for a trained model (Markdown): what it was trained on, how, and how good it is. The same
/// training gives the same bytes.
std::string model_card(const ScaleTraining& training, const ScaleTrainingOptions& options);

}  // namespace gable
