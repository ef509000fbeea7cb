import unittest

import torch

from calibrate import calibrate, maps_of
from deployed import Deployed
from doubling import Doubling
from networks import NETWORKS, HouseNet


def warmed(network):
    """With running statistics and biases as after some training."""
    torch.manual_seed(1)
    network.train()
    for _ in range(3):
        network(torch.rand(8, network.INPUT_CHANNELS, 64, 64) * 255)
    return network.eval()


class NetworksTest(unittest.TestCase):
    def test_a_doubling_equals_its_transposed_convolution_and_its_selection(self):
        doubling = Doubling(6, 5, bias=True)
        torch.nn.init.normal_(doubling.bias)
        x = torch.randn(3, 6, 7, 9)
        want = doubling.transposed()(x)
        self.assertEqual(tuple(want.shape), (3, 5, 14, 18))
        self.assertLess((doubling(x) - want).abs().max(), 1e-5)
        channels = torch.tensor([[0, 4], [3, 1], [2, 2]])
        chosen = doubling.selected(x, channels)
        self.assertLess((chosen - want[torch.arange(3)[:, None], channels]).abs().max(), 1e-5)

    def test_what_is_deployed_has_the_documented_shapes_and_is_probabilities(self):
        crops = torch.rand(3, 5, 64, 64) * 255
        shapes = {"house": [(3, 6), (3, 23, 64, 64)], "roof": [(3, 3)] * 3, "azimuth": [(3, 24)]}
        for name, network in NETWORKS.items():
            deployed = Deployed(warmed(network()))
            with torch.no_grad():
                outputs = deployed(crops[:, : network.INPUT_CHANNELS])
            self.assertEqual([tuple(output.shape) for output in outputs], shapes[name])
            classes = outputs[:1] if name == "house" else outputs
            for output in classes:
                sums = output[:, :8].sum(1)
                self.assertLess((sums - 1).abs().max(), 1e-5)
        length = outputs[0][:, 8:16] ** 2 + outputs[0][:, 16:] ** 2
        self.assertLess((length - 1).abs().max(), 0.01)

    def test_a_crop_is_answered_alike_whatever_else_the_batch_holds(self):
        for network in NETWORKS.values():
            deployed = Deployed(warmed(network()))
            crops = torch.rand(5, network.INPUT_CHANNELS, 64, 64) * 255
            with torch.no_grad():
                for together, alone in zip(deployed(crops), deployed(crops[2:3])):
                    self.assertLess((together[2:3] - alone).abs().max(), 1e-5)

    def test_calibration_moves_a_threshold_to_a_half(self):
        network = warmed(HouseNet(8))
        crops = torch.rand(2, 4, 64, 64) * 255
        with torch.no_grad():
            before = torch.sigmoid(network(crops)[1])
            calibrate(network, {"corners L": 0.1, "dormers": 0.03})
            after = torch.sigmoid(network(crops)[1])
        for kind, threshold in (("corners L", 0.1), ("dormers", 0.03), ("chimneys", 0.5)):
            clear = (before[:, maps_of(kind)] - threshold).abs() > 1e-5
            same = (before[:, maps_of(kind)] > threshold) == (after[:, maps_of(kind)] > 0.5)
            self.assertTrue(same[clear].all(), kind)
        calibrate(network, {"garages": 1.0})
        self.assertTrue(torch.isfinite(network.maps.bias).all())
        self.assertEqual(maps_of("corners L") + maps_of("garages"), [12, 13, 14, 15, 22])


if __name__ == "__main__":
    unittest.main()
