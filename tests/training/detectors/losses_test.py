import math
import unittest

import torch
import torch.nn.functional as F

from losses import BIN, NUM_BINS, QUARTER, azimuth_loss, class_loss, decode_azimuth, map_loss


def encoded(azimuth):
    """What a perfect network would say: the right bin, and angles from every bin's centre."""
    centres = (torch.arange(NUM_BINS) + 0.5) * BIN
    offset = 4 * (azimuth[:, None] - centres)
    bins = 50 * F.one_hot((azimuth / BIN).long(), NUM_BINS).float()
    return bins, 3 * torch.cos(offset), 3 * torch.sin(offset)


class LossesTest(unittest.TestCase):
    def test_decoding_an_encoded_azimuth_gives_it_back(self):
        azimuth = torch.linspace(0, QUARTER - 1e-4, 997)
        error = torch.remainder(decode_azimuth(*encoded(azimuth)) - azimuth, QUARTER)
        self.assertLess(torch.minimum(error, QUARTER - error).max(), 1e-5)

    def test_a_neighbouring_bin_decodes_to_the_same_azimuth(self):
        azimuth = torch.linspace(0, QUARTER - 1e-4, 997)
        bins, cosines, sines = encoded(azimuth)
        error = torch.remainder(decode_azimuth(bins.roll(1, 1), cosines, sines) - azimuth, QUARTER)
        self.assertLess(torch.minimum(error, QUARTER - error).max(), 1e-5)

    def test_the_azimuth_loss_is_least_at_the_truth(self):
        azimuth = torch.tensor([0.01, 0.5, 1.56])
        weights = torch.ones(3)
        bins, cosines, sines = encoded(azimuth)
        _, at_truth = azimuth_loss(bins, cosines, sines, azimuth, weights)
        self.assertLess(at_truth, 1e-5)
        for error in (0.02, -0.02):
            turned = 4 * error
            off_cosines = cosines * math.cos(turned) - sines * math.sin(turned)
            off_sines = sines * math.cos(turned) + cosines * math.sin(turned)
            _, off = azimuth_loss(bins, off_cosines, off_sines, azimuth, weights)
            self.assertAlmostEqual(off.item(), 1 - math.cos(turned), 5)

    def test_what_has_no_weight_does_not_matter(self):
        scores = torch.randn(4, 6)
        truth = torch.tensor([0, 1, 2, 3])
        weights = torch.tensor([1.0, 1.0, 0.0, 0.0])
        want = class_loss(scores[:2], truth[:2], weights[:2])
        self.assertAlmostEqual(class_loss(scores, truth, weights).item(), want.item(), 6)
        maps, targets = torch.randn(2, 3, 8, 8), torch.rand(2, 3, 8, 8)
        known = torch.tensor([[1.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
        before = map_loss(maps, targets, known, torch.ones(3), torch.ones(3))
        maps[:, 2] += 5
        maps[1, 1] -= 5
        self.assertEqual(before, map_loss(maps, targets, known, torch.ones(3), torch.ones(3)))
        maps[1, 0] += 5
        self.assertNotEqual(before, map_loss(maps, targets, known, torch.ones(3), torch.ones(3)))

    def test_the_map_loss_is_the_weighted_cross_entropy(self):
        maps, targets = torch.randn(3, 2, 8, 8), torch.rand(3, 2, 8, 8)
        gains = torch.tensor([9.0, 2.0])
        want = F.binary_cross_entropy_with_logits(
            maps, targets, 1 + gains[None, :, None, None] * targets, reduction="none")
        got = map_loss(maps, targets, torch.ones(3, 2), gains, torch.ones(2))
        self.assertAlmostEqual(got.item(), want.mean((0, 2, 3)).sum().item(), 5)
        got = map_loss(maps, targets, torch.ones(3, 2), gains, torch.tensor([1.0, 2.0]))
        doubled = want.mean((0, 2, 3)) * torch.tensor([1.0, 2.0])
        self.assertAlmostEqual(got.item(), doubled.sum().item(), 5)


if __name__ == "__main__":
    unittest.main()
