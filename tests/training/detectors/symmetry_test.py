import unittest

import numpy as np

from symmetry import NUM_SYMMETRIES, Symmetry, vary

SIZE = 64


def hills(rng):
    """A smooth height function of (x to the right, y up), from the crop's centre in pixels."""
    waves = [(rng.normal(size=2) * 0.08, rng.uniform(0, 6), rng.uniform(1, 4)) for _ in range(4)]
    return lambda x, y: sum(h * np.sin(k[0] * x + k[1] * y + p) for k, p, h in waves)


def rendered(height):
    """The crop of a height function, 1 x 4 x 64 x 64 bytes: normals by central differences."""
    centre = np.arange(SIZE) + 0.5 - SIZE / 2
    x, y = np.meshgrid(centre, -centre)
    e = 1e-4
    slope_x = (height(x + e, y) - height(x - e, y)) / (2 * e)
    slope_y = (height(x, y + e) - height(x, y - e)) / (2 * e)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(x)]) / np.sqrt(
        slope_x**2 + slope_y**2 + 1)
    channels = np.stack([(normal[0] + 1) / 2, (normal[1] + 1) / 2, normal[2],
                         (height(x, y) + 20) / 40])
    return np.round(channels * 255).astype(np.uint8)[None]


def moved_height(height, symmetry):
    """The function whose crop should come out: asks the old one where a point came from."""

    def moved(x, y):
        for _ in range(symmetry.quarters):  # back, so clockwise
            x, y = y, -x
        return height(-x if symmetry.mirrored else x, y)

    return moved


ALL = [Symmetry.of(index) for index in range(NUM_SYMMETRIES)]


class SymmetryTest(unittest.TestCase):
    def test_normals_of_a_moved_crop_equal_those_of_the_moved_heights(self):
        height = hills(np.random.default_rng(3))
        crop = rendered(height)
        for symmetry in ALL:
            got = symmetry.crops(crop).astype(int)
            want = rendered(moved_height(height, symmetry)).astype(int)
            # One: 255 - byte rounds the other way.
            self.assertLessEqual(np.abs(got - want).max(), 1, symmetry)

    def test_four_quarter_turns_are_the_identity(self):
        crop = rendered(hills(np.random.default_rng(4)))
        turned = crop
        for _ in range(4):
            turned = Symmetry(False, 1).crops(turned)
        np.testing.assert_array_equal(turned, crop)
        self.assertTrue((Symmetry(False, 1).crops(crop) != crop).any())

    def test_mirroring_twice_is_the_identity(self):
        crop = rendered(hills(np.random.default_rng(5)))
        for symmetry in ALL[4:]:
            np.testing.assert_array_equal(symmetry.crops(symmetry.crops(crop)), crop)

    def test_points_move_with_the_pixels_they_lie_in(self):
        for symmetry in ALL:
            image = np.zeros((SIZE, SIZE), np.uint8)
            image[10, 45] = 1
            x, y = symmetry.points(np.array([45.5, 10.5]))
            row, col = np.argwhere(symmetry.pixels(image))[0]
            self.assertEqual((x, y), (col + 0.5, row + 0.5))

    def test_corners_of_rectangles_are_named_after_where_they_lie(self):
        rectangle = np.array([[12, 20], [30, 20], [12, 50], [30, 50]], np.float32)
        components = np.full((1, 3, 4, 2), np.nan, np.float32)
        components[0, 0] = rectangle
        corners = np.full((1, 12, 3), np.nan, np.float32)
        corners[0, :4] = np.column_stack([np.arange(4), rectangle])
        for symmetry in ALL:
            moved = symmetry.components(components)[0, 0]
            x, y = moved.T
            self.assertTrue(x[0] == x[2] < x[1] == x[3] and y[0] == y[1] < y[2] == y[3])
            for corner_type, *point in symmetry.corners(corners, np.array([0]))[0, :4]:
                np.testing.assert_array_equal(moved[int(corner_type)], point)

    def test_corners_of_l_and_u_keep_their_roles(self):
        corners = np.array([[[2, 10, 20], [np.nan] * 3]], np.float32)
        for symmetry in ALL:
            for foundation in (3, 4):
                moved = symmetry.corners(corners, np.array([foundation]))
                self.assertEqual(moved[0, 0, 0], 2)
                np.testing.assert_array_equal(moved[0, 0, 1:], symmetry.points(corners[0, 0, 1:]))

    def test_azimuths_move_with_the_direction_they_stand_for(self):
        for symmetry in ALL:
            for azimuth in (0.1, 0.7, 1.5):
                tip = np.array([32 + 20 * np.cos(azimuth), 32 - 20 * np.sin(azimuth)])
                x, y = symmetry.points(tip) - 32
                want = np.mod(np.arctan2(-y, x), np.pi / 2)
                self.assertAlmostEqual(float(symmetry.azimuths(np.array(azimuth))), want, 12)

    def test_a_varied_batch_holds_every_symmetry(self):
        crop = rendered(hills(np.random.default_rng(6)))
        batch = {"crops": np.repeat(crop, 16, 0), "foundation": np.zeros(16, np.uint8)}
        varied = vary(batch, np.random.default_rng(1))["crops"]
        want = {symmetry.crops(crop).tobytes() for symmetry in ALL}
        self.assertEqual({one.tobytes() for one in varied}, want)
        self.assertEqual(len(want), NUM_SYMMETRIES)


if __name__ == "__main__":
    unittest.main()
