"""What of a trained network is exported, and what it costs."""

from __future__ import annotations

import copy

import torch
from torch import Tensor, nn

from doubling import Doubling
from networks import CROP_SIZE, AzimuthNet, HouseNet


class Deployed(nn.Module):
    """A copy of a network as its ONNX file holds it, in evaluation mode: probabilities instead of
    scores, in the order of `OUTPUTS`, and transposed convolutions."""

    def __init__(self, network: nn.Module):
        super().__init__()
        self.network = copy.deepcopy(network).float().to(memory_format=torch.contiguous_format)
        for name, layer in list(self.network.named_children()):
            if isinstance(layer, Doubling):
                setattr(self.network, name, layer.transposed())
        self.eval()

    def forward(self, crop: Tensor) -> tuple[Tensor, ...]:
        scores = self.network(crop)
        if isinstance(self.network, HouseNet):
            return torch.softmax(scores[0], 1), torch.sigmoid(scores[1])
        if isinstance(self.network, AzimuthNet):
            bins, cosines, sines = scores
            length = torch.sqrt(cosines * cosines + sines * sines + 1e-6)
            return (torch.cat([torch.softmax(bins, 1), cosines / length, sines / length], 1),)
        return tuple(torch.softmax(score, 1) for score in scores)


def multiply_adds(network: nn.Module) -> int:
    """Multiply-adds of the deployed network's convolutions for one crop."""
    total = 0

    def count(layer: nn.Module, inputs: tuple[Tensor], output: Tensor) -> None:
        nonlocal total
        pixels = inputs[0] if isinstance(layer, nn.ConvTranspose2d) else output
        total += layer.weight.numel() * pixels.shape[2] * pixels.shape[3]

    deployed = Deployed(network)
    for layer in deployed.modules():
        if isinstance(layer, (nn.Conv2d, nn.ConvTranspose2d)):
            layer.register_forward_hook(count)
    with torch.no_grad():
        deployed(torch.zeros(1, network.INPUT_CHANNELS, CROP_SIZE, CROP_SIZE))
    return total
