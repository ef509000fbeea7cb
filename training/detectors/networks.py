"""The three networks of the detectors (docs/detectors.md), and what of them is exported.

A network returns raw scores (logits), for the losses; `Deployed` wraps it and returns what the
document promises: probabilities. Only layers that OpenCV 4.6 reads right at every batch size are
used: convolutions, batch normalisation, ReLU, sums, concatenation, global average pooling, and
softmax over N x K. Fully connected layers are 1 x 1 convolutions of a 1 x 1 map.
"""

from __future__ import annotations

import torch
from torch import Tensor, nn

from doubling import Doubling

NUM_FOUNDATIONS = 6
NUM_MAPS = 23
NUM_ROOF_TYPES = 3
NUM_AZIMUTH_BINS = 8
CROP_SIZE = 64


def conv_bn(inputs: int, outputs: int, kernel: int = 3, stride: int = 1) -> nn.Sequential:
    """Convolution, batch normalisation, ReLU; keeps the size or divides it by the stride."""
    return nn.Sequential(
        nn.Conv2d(inputs, outputs, kernel, stride, kernel // 2, bias=False),
        nn.BatchNorm2d(outputs),
        nn.ReLU(),
    )


class Residual(nn.Module):
    """Two 3 x 3 convolutions beside the identity (He et al., 2016)."""

    def __init__(self, channels: int):
        super().__init__()
        self.first = conv_bn(channels, channels)
        self.second = nn.Sequential(
            nn.Conv2d(channels, channels, 3, 1, 1, bias=False), nn.BatchNorm2d(channels)
        )

    def forward(self, x: Tensor) -> Tensor:
        return torch.relu(x + self.second(self.first(x)))


def stage(inputs: int, outputs: int, blocks: int) -> nn.Sequential:
    """Halves the size, then residual blocks."""
    return nn.Sequential(conv_bn(inputs, outputs, 3, 2), *[Residual(outputs) for _ in range(blocks)])


def head(inputs: int, hidden: int, outputs: int) -> nn.Sequential:
    """One fully connected layer between the pooled features and the output layer (NPR 4.1)."""
    return nn.Sequential(
        nn.Conv2d(inputs, hidden, 1), nn.ReLU(), nn.Dropout(0.1), nn.Conv2d(hidden, outputs, 1),
        nn.Flatten(1),
    )


def scaled(crop: Tensor) -> Tensor:
    """Bytes as floats, [0, 255], to [-1, 1]."""
    return crop * (1.0 / 127.5) - 1.0


class HouseNet(nn.Module):
    """Foundation scores N x 6 and map scores N x 23 x 64 x 64 of crops N x 4 x 64 x 64.

    A residual encoder down to 4 x 4, and a decoder that adds what it doubles to the encoder's
    features of the same size.
    """

    NAME = "house"
    INPUT_CHANNELS = 4
    OUTPUTS = ("foundation", "maps")

    def __init__(self, width: int = 24, blocks: tuple[int, int, int] = (1, 2, 2)):
        super().__init__()
        a, b, c = width, 2 * width, 4 * width
        self.stem = conv_bn(self.INPUT_CHANNELS, a, 5, 2)
        self.at32 = nn.Sequential(*[Residual(a) for _ in range(blocks[0])])
        self.at16 = stage(a, b, blocks[1])
        self.at8 = stage(b, c, blocks[2])
        self.at4 = stage(c, c, 1)
        self.up8 = Doubling(c, c)
        self.join8 = conv_bn(c, c)
        self.up16 = Doubling(c, b)
        self.join16 = Residual(b)
        self.up32 = Doubling(b, a)
        self.join32 = Residual(a)
        self.maps = Doubling(a, NUM_MAPS, bias=True)
        self.pool = nn.AdaptiveAvgPool2d(1)
        self.foundation = head(c + c + a, 128, NUM_FOUNDATIONS)
        # Most pixels show nothing: begin there, or the first steps only learn that.
        nn.init.constant_(self.maps.bias, -3.0)

    def features(self, crop: Tensor) -> tuple[Tensor, Tensor]:
        """Foundation scores, and the features N x width x 32 x 32 that `maps` reads."""
        x32 = self.at32(self.stem(scaled(crop)))
        x16 = self.at16(x32)
        x8 = self.at8(x16)
        x4 = self.at4(x8)
        y8 = self.join8(self.up8(x4) + x8)
        y16 = self.join16(self.up16(y8) + x16)
        y32 = self.join32(self.up32(y16) + x32)
        pooled = torch.cat([self.pool(x4), self.pool(y8), self.pool(y32)], 1)
        return self.foundation(pooled), y32

    def forward(self, crop: Tensor) -> tuple[Tensor, Tensor]:
        foundation, y32 = self.features(crop)
        return foundation, self.maps(y32)


class Trunk(nn.Module):
    """The shared part of the two classifiers: pooled features of a crop."""

    def __init__(self, channels: int, width: int, blocks: tuple[int, int, int]):
        super().__init__()
        a, b, c = width, 2 * width, 4 * width
        self.features = 2 * c
        self.stem = conv_bn(channels, a, 5, 2)
        self.at32 = nn.Sequential(*[Residual(a) for _ in range(blocks[0])])
        self.at16 = stage(a, b, blocks[1])
        self.at8 = stage(b, c, blocks[2])
        self.at4 = conv_bn(c, c, 3, 2)
        self.pool = nn.AdaptiveAvgPool2d(1)

    def forward(self, crop: Tensor) -> Tensor:
        x8 = self.at8(self.at16(self.at32(self.stem(scaled(crop)))))
        return torch.cat([self.pool(x8), self.pool(self.at4(x8))], 1)


class RoofNet(nn.Module):
    """Roof type scores, N x 3 each, of I components, of L and of U, of N x 5 x 64 x 64."""

    NAME = "roof"
    INPUT_CHANNELS = 5
    OUTPUTS = ("roof_i", "roof_l", "roof_u")

    def __init__(self, width: int = 16, blocks: tuple[int, int, int] = (1, 1, 1)):
        super().__init__()
        self.trunk = Trunk(self.INPUT_CHANNELS, width, blocks)
        self.heads = nn.ModuleList(
            [head(self.trunk.features, 64, NUM_ROOF_TYPES) for _ in self.OUTPUTS]
        )

    def forward(self, crop: Tensor) -> tuple[Tensor, ...]:
        pooled = self.trunk(crop)
        return tuple(head(pooled) for head in self.heads)


class AzimuthNet(nn.Module):
    """Multi-bin scores of the azimuth (Mousavian et al., 2017): bin scores N x 8, and not yet
    normalised cosines and sines, N x 8 each."""

    NAME = "azimuth"
    INPUT_CHANNELS = 4
    OUTPUTS = ("bins",)

    def __init__(self, width: int = 16, blocks: tuple[int, int, int] = (1, 1, 1)):
        super().__init__()
        self.trunk = Trunk(self.INPUT_CHANNELS, width, blocks)
        self.bins = head(self.trunk.features, 64, NUM_AZIMUTH_BINS)
        self.cosines = head(self.trunk.features, 64, NUM_AZIMUTH_BINS)
        self.sines = head(self.trunk.features, 64, NUM_AZIMUTH_BINS)

    def forward(self, crop: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        pooled = self.trunk(crop)
        return self.bins(pooled), self.cosines(pooled), self.sines(pooled)


NETWORKS = {net.NAME: net for net in (HouseNet, RoofNet, AzimuthNet)}
