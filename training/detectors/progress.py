"""A line on stderr that says how a training is going."""

from __future__ import annotations

import sys
import time

WIDTH = 24


class ProgressLine:
    """Rewritten in place on a terminal; elsewhere a line every half minute."""

    def __init__(self, name: str):
        self._name = name
        self._terminal = sys.stderr.isatty()
        self._pause = 0.5 if self._terminal else 30.0
        self._last = -1e9
        self._samples = 0
        self._loss = None
        self._since = time.monotonic()

    def update(self, progress: float, left: float, samples: int, loss: float) -> None:
        """After a step: progress in [0, 1], seconds left, samples of the step and its loss."""
        self._samples += samples
        self._loss = loss if self._loss is None else 0.98 * self._loss + 0.02 * loss
        now = time.monotonic()
        if now - self._last < self._pause:
            return
        rate = self._samples / max(1e-6, now - self._since)
        bar = ("#" * round(progress * WIDTH)).ljust(WIDTH, ".")
        minutes, seconds = divmod(int(min(left, 359999)), 60)
        self._write(f"{self._name} [{bar}] {100 * progress:5.1f} %  {rate:6.0f} crops/s  "
                    f"loss {self._loss:.4f}  {minutes}:{seconds:02d} left")
        self._last, self._samples, self._since = now, 0, now

    def say(self, text: str) -> None:
        """A line that stays."""
        if self._terminal:
            sys.stderr.write("\r\033[K")
        sys.stderr.write(text + "\n")
        sys.stderr.flush()

    def _write(self, text: str) -> None:
        sys.stderr.write("\r\033[K" + text if self._terminal else text + "\n")
        sys.stderr.flush()
