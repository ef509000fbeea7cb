"""The moving average of a network's weights, which generalises better than the last weights."""

from __future__ import annotations

import copy

import torch
from torch import nn

MEMORY = 0.999  # a step


class WeightAverage:
    def __init__(self, network: nn.Module):
        self.network = copy.deepcopy(network).eval()
        for parameter in self.network.parameters():
            parameter.requires_grad_(False)
        self._mine = self._floats(self.network)

    @staticmethod
    def _floats(network: nn.Module) -> list[torch.Tensor]:
        return [tensor for tensor in network.state_dict().values() if tensor.is_floating_point()]

    def update(self, network: nn.Module, step: int) -> None:
        """After the given step, from 0. The first steps forget faster."""
        memory = min(MEMORY, (1 + step) / (10 + step))
        theirs = self._floats(network)
        torch._foreach_mul_(self._mine, memory)
        torch._foreach_add_(self._mine, theirs, alpha=1 - memory)
