"""What training minimises."""

from __future__ import annotations

import math

import torch
import torch.nn.functional as F
from torch import Tensor

NUM_BINS = 8
QUARTER = math.pi / 2
BIN = QUARTER / NUM_BINS


def class_loss(scores: Tensor, truth: Tensor, weights: Tensor, smoothing: float = 0.05) -> Tensor:
    """Cross entropy of n x K scores; n weights; their sum divides, 0 where it is 0."""
    losses = F.cross_entropy(scores, truth, reduction="none", label_smoothing=smoothing)
    return (losses * weights).sum() / weights.sum().clamp(min=1e-6)


def map_loss(scores: Tensor, targets: Tensor, weights: Tensor, gains: Tensor,
             shares: Tensor) -> Tensor:
    """Weighted binary cross entropy of n x K x H x W scores against targets in [0, 1], mean over
    pixels, summed over the K maps times their shares; n x K weights. A pixel of target t counts
    1 + gain t, for what there is to find covers few pixels: gains, shares, K values."""
    losses = F.softplus(scores) - scores * targets
    losses = (losses * (1 + gains[None, :, None, None] * targets)).mean((2, 3))
    return (shares * (losses * weights).sum(0) / weights.sum(0).clamp(min=1e-6)).sum()


def azimuth_loss(bins: Tensor, cosines: Tensor, sines: Tensor, azimuth: Tensor,
                 weights: Tensor) -> tuple[Tensor, Tensor]:
    """MultiBin (Mousavian et al., 2017) of azimuths modulo a quarter turn, radians: cross entropy
    of the bin, and 1 - cos of four times the error of each bin that covers the azimuth. Bins
    overlap by half a bin on either side, so that a neighbour of the right bin answers well too."""
    centres = (torch.arange(NUM_BINS, dtype=azimuth.dtype) + 0.5) * BIN
    bin_loss = class_loss(bins, torch.floor(azimuth / BIN).long().clamp(0, NUM_BINS - 1), weights)
    offset = 4 * (azimuth[:, None] - centres)
    covers = torch.cos(offset) >= math.cos(4 * BIN)
    length = torch.sqrt(cosines**2 + sines**2 + 1e-6)
    error = 1 - (cosines * torch.cos(offset) + sines * torch.sin(offset)) / length
    share = covers.float() * weights[:, None]
    return bin_loss, (error * share).sum() / share.sum().clamp(min=1e-6)


def decode_azimuth(bins: Tensor, cosines: Tensor, sines: Tensor) -> Tensor:
    """Azimuths in [0, pi/2) from n x 8 bin scores, cosines, sines."""
    best = bins.argmax(1)
    rows = torch.arange(len(best))
    offset = torch.atan2(sines[rows, best], cosines[rows, best]) / 4
    return torch.remainder((best + 0.5) * BIN + offset, QUARTER)
