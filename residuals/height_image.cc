#include <gable/residuals/height_image.h>
