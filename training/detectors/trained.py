"""A trained network, read from the checkpoint of its training."""

from __future__ import annotations

from pathlib import Path

import torch
from torch import nn

from networks import NETWORKS


def load_trained(folder: str | Path) -> nn.Module:
    """The averaged weights, in evaluation mode."""
    path = Path(folder) / "checkpoint.pt"
    if not path.exists():
        raise SystemExit(f"{path}: is missing; train the network first (train.py)")
    state = torch.load(path, map_location="cpu")
    width = state["options"].get("width")
    network = NETWORKS[state["net"]](**({"width": width} if width else {}))
    network.load_state_dict(state["average"])
    return network.eval()
