import math
import unittest

import numpy as np

from targets import SIGMA, house_targets, selected_maps, selected_weights


def empty_batch(count):
    return {
        "foundation": np.zeros(count, np.uint8),
        "corners": np.full((count, 12, 3), np.nan, np.float32),
        "dormers": np.full((count, 8, 2), np.nan, np.float32),
        "chimneys": np.full((count, 4, 2), np.nan, np.float32),
        "garages": np.zeros((count, 64, 64), np.uint8),
    }


def slow_map(points):
    values = np.zeros((64, 64))
    for x, y in points:
        for row in range(64):
            for col in range(64):
                squared = (col + 0.5 - x) ** 2 + (row + 0.5 - y) ** 2
                values[row, col] = max(values[row, col], math.exp(-squared / (2 * SIGMA**2)))
    return values


class TargetsTest(unittest.TestCase):
    def test_maps_are_the_highest_gaussian_of_their_points(self):
        rng = np.random.default_rng(2)
        batch = empty_batch(3)
        batch["foundation"][:] = (2, 3, 0)
        for crop in range(3):
            for slot in range(4 * crop, 12):
                batch["corners"][crop, slot] = (rng.integers(4), *rng.uniform(-3, 67, 2))
            batch["dormers"][crop, crop:4] = rng.uniform(20, 26, (4 - crop, 2))
            batch["chimneys"][crop, ::2] = rng.uniform(5, 60, (2, 2))
        batch["garages"][1, 3:9, 7:11] = 1
        maps = house_targets(batch)
        for crop in range(3):
            corners = batch["corners"][crop]
            for corner_type in range(4):
                of_type = corners[corners[:, 0] == corner_type, 1:]
                np.testing.assert_allclose(maps[crop, corner_type], slow_map(of_type), atol=1e-6)
            for place, name in ((4, "dormers"), (5, "chimneys")):
                known = batch[name][crop]
                known = known[np.isfinite(known[:, 0])]
                np.testing.assert_allclose(maps[crop, place], slow_map(known), atol=1e-6)
        np.testing.assert_array_equal(maps[:, 6], batch["garages"])

    def test_a_crop_trains_the_corner_maps_of_its_own_foundation_only(self):
        maps = selected_maps(np.array([0, 1, 2, 3, 4], np.uint8))
        np.testing.assert_array_equal(maps[:, 0], [0, 4, 8, 12, 16])
        np.testing.assert_array_equal(maps[3], [12, 13, 14, 15, 20, 21, 22])

    def test_what_is_not_known_has_no_weight(self):
        weights = selected_weights(np.array([1, 1, 5], np.uint8), np.array([1, 0, 1], np.uint8))
        np.testing.assert_array_equal(weights, [[1] * 7, [1, 1, 1, 1, 0, 0, 0], [0] * 7])


if __name__ == "__main__":
    unittest.main()
