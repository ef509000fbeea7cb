"""How far a training is, and the learning rate there."""

from __future__ import annotations

import math
import time

WARM_UP = 0.04
LAST = 0.002  # of the highest rate


def rate_at(progress: float) -> float:
    """Share of the highest rate at a progress in [0, 1]: up in a line, down along a cosine."""
    if progress < WARM_UP:
        return max(progress / WARM_UP, 0.01)
    fall = (progress - WARM_UP) / (1 - WARM_UP)
    return LAST + (1 - LAST) * 0.5 * (1 + math.cos(math.pi * min(1.0, fall)))


class Schedule:
    """Progress by time or by steps. By time a training ends when told, however slow the machine;
    by steps the same seed gives the same network."""

    def __init__(self, seconds: float | None, steps: int | None, seconds_before: float = 0.0):
        if (seconds is None) == (steps is None):
            raise ValueError("one of seconds and steps must be given")
        self._seconds, self._steps, self._before = seconds, steps, seconds_before
        self._began = time.monotonic()

    def elapsed(self) -> float:
        """Seconds of training, those before an interruption included."""
        return self._before + time.monotonic() - self._began

    def progress(self, step: int) -> float:
        done = self.elapsed() / self._seconds if self._seconds else step / self._steps
        return min(1.0, done)

    def left(self, step: int) -> float:
        """Seconds until the end, as far as one can tell."""
        progress = self.progress(step)
        if self._seconds:
            return max(0.0, self._seconds - self.elapsed())
        return self.elapsed() * (1 - progress) / progress if progress > 0 else math.inf
