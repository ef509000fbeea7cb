import unittest

import torch
from torch import nn

from average import WeightAverage
from schedule import LAST, WARM_UP, Schedule, rate_at


class ScheduleTest(unittest.TestCase):
    def test_the_rate_climbs_then_falls_to_its_last(self):
        self.assertAlmostEqual(rate_at(WARM_UP), 1)
        self.assertAlmostEqual(rate_at(1), LAST)
        rates = [rate_at(i / 1000) for i in range(1001)]
        peak = round(1000 * WARM_UP)
        self.assertEqual(rates[:peak], sorted(rates[:peak]))
        self.assertEqual(rates[peak:], sorted(rates[peak:], reverse=True))

    def test_time_spent_before_an_interruption_counts(self):
        schedule = Schedule(seconds=1000, steps=None, seconds_before=400)
        self.assertAlmostEqual(schedule.progress(0), 0.4, 2)
        self.assertAlmostEqual(schedule.left(0), 600, 0)
        self.assertEqual(Schedule(None, 50).progress(25), 0.5)

    def test_the_average_forgets_its_beginning_and_lags_behind(self):
        network = nn.Linear(1, 1, bias=False)
        nn.init.constant_(network.weight, 1.0)
        average = WeightAverage(network)
        with torch.no_grad():
            network.weight.fill_(3.0)
        average.update(network, 0)
        self.assertAlmostEqual(average.network.weight.item(), 0.1 * 1 + 0.9 * 3, 5)
        for step in range(10**6, 10**6 + 1000):
            average.update(network, step)
        self.assertAlmostEqual(average.network.weight.item(), 3 - 0.2 * 0.999**1000, 4)


if __name__ == "__main__":
    unittest.main()
