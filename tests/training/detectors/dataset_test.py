import tempfile
import unittest
from pathlib import Path

import numpy as np

from dataset import NAMES, Dataset, drawn
from stream import Stream


def write_shards(folder, sizes):
    """Shards whose arrays hold the number of the crop."""
    first = 0
    for shard, size in enumerate(sizes):
        numbers = np.arange(first, first + size)
        for name in NAMES:
            if name in ("crops", "turned"):
                array = np.broadcast_to(numbers[:, None, None, None], (size, 4, 64, 64))
                array = array.astype(np.uint8)
            elif name in ("masks", "garages"):
                array = np.zeros((size, 512), np.uint8)
                array[:, 1] = 0b10100000  # row 0, columns 8 and 10
            else:
                array = numbers.astype(np.float32)
            np.save(Path(folder) / f"{name}_{shard:04d}.npy", array)
        first += size


class DatasetTest(unittest.TestCase):
    def test_crops_come_in_the_order_asked_for_from_every_shard(self):
        with tempfile.TemporaryDirectory() as folder:
            write_shards(folder, [5, 3, 4])
            dataset = Dataset(folder)
            rows = np.array([11, 0, 7, 5, 4, 8])
            batch = dataset.take(rows, ("crops", "azimuth", "garages", "details_known"))
            np.testing.assert_array_equal(batch["crops"][:, 2, 3, 4], rows)
            np.testing.assert_array_equal(batch["azimuth"], rows)
            np.testing.assert_array_equal(np.argwhere(batch["garages"][3]), [[0, 8], [0, 10]])
            self.assertTrue((batch["details_known"] == 1).all())

    def test_the_last_shards_validate(self):
        with tempfile.TemporaryDirectory() as folder:
            write_shards(folder, [30, 30, 30, 10])
            training, validation = Dataset(folder).split(0.1)
            np.testing.assert_array_equal(np.concatenate([training, validation]), np.arange(100))
            self.assertEqual(validation[0], 90)
        with tempfile.TemporaryDirectory() as folder:
            write_shards(folder, [40])
            self.assertEqual(len(Dataset(folder).split(0.1)[1]), 4)

    def test_a_missing_or_cut_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            write_shards(folder, [4, 4])
            np.save(Path(folder) / "roofs_0001.npy", np.zeros((3, 3), np.int8))
            with self.assertRaisesRegex(SystemExit, "roofs_0001.npy: has 3 entries"):
                Dataset(folder)
            (Path(folder) / "roofs_0001.npy").unlink()
            with self.assertRaisesRegex(SystemExit, "roofs_0001.npy: is missing"):
                Dataset(folder)

    def test_drawn_crops_and_both_halves_of_them_hold_every_foundation_alike(self):
        foundation = np.arange(6000) % 6
        rows = drawn(np.arange(6000), 3000)
        self.assertEqual(len(set(rows)), 3000)
        for half in (rows[::2], rows[1::2]):
            shares = np.bincount(foundation[half], minlength=6) / len(half)
            self.assertLess(np.abs(shares - 1 / 6).max(), 0.04)
        np.testing.assert_array_equal(rows, drawn(np.arange(6000), 3000))
        self.assertEqual(len(drawn(np.arange(5), 100)), 5)

    def test_an_epoch_takes_every_crop_once_and_resuming_changes_nothing(self):
        rows = np.arange(100, 140)
        stream = Stream(rows, 8, seed=1)
        batches = [stream.at(step) for step in range(10)]
        np.testing.assert_array_equal(np.sort(np.concatenate(batches[:5])), rows)
        np.testing.assert_array_equal(np.sort(np.concatenate(batches[5:])), rows)
        self.assertTrue((batches[0] != batches[5]).any())
        np.testing.assert_array_equal(Stream(rows, 8, seed=1).at(7), batches[7])


if __name__ == "__main__":
    unittest.main()
