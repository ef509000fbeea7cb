import unittest

import numpy as np

from masks import MAX_SCALE, MAX_SHIFT, boxes, filled, jittered
from roof_task import roof_inputs


def quad(left, top, right, bottom):
    return np.array([[left, top], [right, top], [left, bottom], [right, bottom]], np.float32)


def batch(foundation, *quads):
    components = np.full((1, 3, 4, 2), np.nan, np.float32)
    components[0, : len(quads)] = quads
    roofs = np.full((1, 3), -1, np.int8)
    roofs[0, : len(quads) if foundation <= 2 else 1] = 1
    return {"crops": np.zeros((1, 4, 64, 64), np.uint8), "components": components,
            "roofs": roofs, "foundation": np.array([foundation], np.uint8)}


class MasksTest(unittest.TestCase):
    def test_a_mask_holds_the_pixels_whose_centres_lie_in_a_box(self):
        box = np.array([[[10.2, 20.6, 5.0, 9.0], [40.0, 42.0, 50.0, 51.4], [np.nan] * 4]])
        mask = filled(box)[0]
        for row in range(64):
            for col in range(64):
                x, y = col + 0.5, row + 0.5
                inside = any(b[0] <= x <= b[1] and b[2] <= y <= b[3] for b in box[0])
                self.assertEqual(mask[row, col], 255 if inside else 0)

    def test_the_box_of_a_turned_rectangle_has_its_centre_and_nearly_its_sides(self):
        angle = np.radians(3)
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        left, right, top, bottom = boxes((quad(12, 20, 40, 44) - (26, 32)) @ turn.T + (26, 32))
        self.assertAlmostEqual(left + right, 52, 4)
        self.assertAlmostEqual(top + bottom, 64, 4)
        self.assertAlmostEqual(right - left, 28 * np.cos(angle), 4)
        self.assertAlmostEqual(bottom - top, 24 * np.cos(angle), 4)

    def test_jitter_keeps_within_its_bounds_and_moves_every_side(self):
        box = np.broadcast_to([10.0, 40.0, 20.0, 30.0], (2000, 1, 4))
        moved = jittered(box, np.random.default_rng(1)) - box
        self.assertLessEqual(np.abs(moved[..., :2]).max(), MAX_SHIFT + MAX_SCALE * 15)
        self.assertGreater(moved.std(axis=0).min(), 0.5)

    def test_i_ii_and_iii_mask_one_component_and_l_and_u_all(self):
        quads = quad(5, 5, 20, 20), quad(30, 30, 50, 60)
        single = [filled(boxes(q)[None, None])[0] for q in quads]
        for foundation in (3, 4):
            crops, component = roof_inputs(batch(foundation, *quads), None)
            np.testing.assert_array_equal(crops[0, 4], np.maximum(*single))
            self.assertEqual(component[0], 0)
        rng = np.random.default_rng(2)
        seen = set()
        for _ in range(40):
            crops, component = roof_inputs(batch(1, *quads), rng)
            overlaps = [np.count_nonzero(crops[0, 4] & one) for one in single]
            self.assertEqual(int(np.argmax(overlaps)), component[0])
            self.assertEqual(min(overlaps), 0)
            seen.add(int(component[0]))
        self.assertEqual(seen, {0, 1})

    def test_a_component_without_a_known_roof_is_never_drawn(self):
        two = batch(1, quad(5, 5, 20, 20), quad(30, 30, 50, 60))
        two["roofs"][0, 0] = -1
        rng = np.random.default_rng(3)
        drawn = {int(roof_inputs(two, rng)[1][0]) for _ in range(30)}
        self.assertEqual(drawn, {1})


if __name__ == "__main__":
    unittest.main()
