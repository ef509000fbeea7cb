#pragma once

#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// Makes roofs simpler where the penalised cost says so: a hip whose ends are short becomes a
/// gable, a ridge that hardly rises a flat roof, without refining. Returns how many changed.
int simplify_roofs(const HeightImage& image, const PenaltyOptions& penalty, House* house);

}  // namespace gable
