"""What the three tasks share: how a network is run."""

from __future__ import annotations

import contextlib

import numpy as np
import torch
from torch import Tensor, nn


def low_precision() -> contextlib.AbstractContextManager:
    """bfloat16 where the processor computes with it: twice as fast, with no loss seen."""
    return torch.autocast("cpu", dtype=torch.bfloat16)


def as_input(crops: np.ndarray) -> Tensor:
    """Bytes n x C x 64 x 64 as floats, channels last."""
    return torch.from_numpy(crops).float().contiguous(memory_format=torch.channels_last)


def forward(network: nn.Module, crops: np.ndarray) -> tuple[Tensor, ...]:
    """Scores in float32, without gradients."""
    with torch.no_grad(), low_precision():
        scores = network(as_input(crops))
    return tuple(score.float() for score in scores)
