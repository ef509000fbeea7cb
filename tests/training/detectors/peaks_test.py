import unittest

import numpy as np

from peaks import Agreement, find_peaks
from targets import add_points


class PeaksTest(unittest.TestCase):
    def test_peaks_of_a_target_are_its_points(self):
        points = np.array([[[10.5, 20.5], [40.5, 22.5], [33.5, 50.5]]], np.float32)
        maps = np.zeros((1, 1, 64, 64), np.float32)
        add_points(maps, points, 0)
        found, values = find_peaks(maps)[0][0]
        self.assertEqual({tuple(p) for p in found}, {tuple(p) for p in points[0].tolist()})
        np.testing.assert_allclose(values, 1)

    def test_every_known_point_is_hit_once_and_by_the_highest_peak_near_it(self):
        agreement = Agreement(radius=3)
        found = np.array([[10, 10], [11, 10], [30, 30.0]])
        agreement.add(found, np.array([0.9, 0.8, 0.6]), np.array([[12, 10], [50, 50], [np.nan] * 2]))
        self.assertEqual(agreement.hits[0].tolist(), [True, False, False])
        self.assertEqual(agreement.at(0.5), (1 / 3, 1 / 2))
        self.assertEqual(agreement.at(0.85), (1.0, 1 / 2))

    def test_the_best_threshold_has_the_best_f1(self):
        rng = np.random.default_rng(1)
        agreement = Agreement(radius=1)
        for _ in range(200):
            known = rng.uniform(0, 64, (2, 2))
            true, false = rng.random() ** 0.5, rng.random() ** 2
            order = np.argsort([-true, -false])
            found = np.array([known[0], [200.0, 200.0]])[order]
            agreement.add(found, np.array([true, false])[order], known)

        def f1(threshold):
            precision, recall = agreement.at(threshold)
            return 2 * precision * recall / max(1e-9, precision + recall)

        best = f1(agreement.best_threshold())
        self.assertTrue(all(f1(t) <= best + 1e-12 for t in np.linspace(0, 1, 500)))


if __name__ == "__main__":
    unittest.main()
