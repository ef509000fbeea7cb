"""Learned doubling of a map's size."""

from __future__ import annotations

import torch
import torch.nn.functional as F
from torch import Tensor, nn


class Doubling(nn.Module):
    """A transposed convolution of kernel 2 and stride 2: every pixel becomes 2 x 2.

    In training it runs as a 1 x 1 convolution whose channels are dealt to the four pixels, which on
    processors is many times faster; `transposed` gives the very same as one layer, for the export.
    Channel 4 k + 2 row + col of the convolution is channel k of pixel (row, col) of the four.
    """

    def __init__(self, inputs: int, outputs: int, bias: bool = False):
        super().__init__()
        self.outputs = outputs
        self.weight = nn.Parameter(torch.empty(4 * outputs, inputs))
        nn.init.kaiming_uniform_(self.weight, a=5**0.5)
        self.bias = nn.Parameter(torch.zeros(outputs)) if bias else None

    def forward(self, x: Tensor) -> Tensor:
        bias = None if self.bias is None else self.bias.repeat_interleave(4)
        return F.pixel_shuffle(F.conv2d(x, self.weight[:, :, None, None], bias), 2)

    def selected(self, x: Tensor, channels: Tensor) -> Tensor:
        """Only some output channels, of each sample its own: x is N x C x H x W, channels N x K
        (integers); returns N x K x 2H x 2W."""
        n, inputs, height, width = x.shape
        k = channels.shape[1]
        weight = self.weight.view(self.outputs, 4, inputs)[channels].reshape(n, 4 * k, inputs)
        pixels = x.permute(0, 2, 3, 1).reshape(n, height * width, inputs)
        dealt = torch.bmm(pixels, weight.transpose(1, 2).to(x.dtype)).float()
        if self.bias is not None:
            dealt = dealt + self.bias[channels].repeat_interleave(4, 1)[:, None, :]
        dealt = dealt.view(n, height, width, k, 2, 2)
        return dealt.permute(0, 3, 1, 4, 2, 5).reshape(n, k, 2 * height, 2 * width)

    def transposed(self) -> nn.ConvTranspose2d:
        inputs = self.weight.shape[1]
        layer = nn.ConvTranspose2d(inputs, self.outputs, 2, 2, bias=self.bias is not None)
        with torch.no_grad():
            layer.weight.copy_(self.weight.view(self.outputs, 2, 2, inputs).permute(3, 0, 1, 2))
            if self.bias is not None:
                layer.bias.copy_(self.bias)
        return layer
