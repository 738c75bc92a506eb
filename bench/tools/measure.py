# bench: one process, measured from outside, and what many such measurements say together.
import math
import os
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass


@dataclass
class Run:
    wall: float  # seconds from start to end, as a person with a watch sees them
    cpu: float  # of all its threads, user and system
    peak_bytes: int  # the most memory that was in use at once
    log: str  # what it wrote to stdout and stderr


class Failed(Exception):
    pass


def run(words, folder=None):
    """Runs a program to its end. Raises Failed with the end of its output where it does not
    succeed."""
    with tempfile.TemporaryFile() as log:
        start = time.perf_counter()
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                   cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read().decode(errors='replace')
    if process.returncode != 0:
        raise Failed(f'{" ".join(map(str, words))}: exit code {process.returncode}\n{text[-800:]}')
    return Run(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, text)


@dataclass
class Spread:
    """Median, least and greatest of some repetitions."""
    median: float
    least: float
    most: float

    @staticmethod
    def of(values):
        values = list(values)
        return Spread(statistics.median(values), min(values), max(values))

    def text(self, digits=3):
        return f'{short(self.median, digits)} ({short(self.least, digits)}-{short(self.most, digits)})'


def short(value, digits=3):
    """The number with so many significant digits, without an exponent."""
    if value == 0 or not math.isfinite(value):
        return f'{value:g}'
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f'{value:.{decimals}f}'


def geometric_mean(values):
    values = list(values)
    return math.exp(sum(math.log(v) for v in values) / len(values)) if values else math.nan


def table(head, rows):
    """Rows of texts in columns: the first to the left, the others to the right."""
    widths = [max(len(str(row[i])) for row in [head, *rows]) for i in range(len(head))]
    lines = []
    for row in [head, *rows]:
        cells = [str(cell).rjust(width) for cell, width in zip(row, widths)]
        cells[0] = str(row[0]).ljust(widths[0])
        lines.append('  '.join(cells).rstrip())
    return '\n'.join(lines)


def machine():
    """What a figure is worth nothing without."""
    model = ''
    with open('/proc/cpuinfo') as info:
        for line in info:
            if line.startswith('model name'):
                model = line.split(':', 1)[1].strip()
                break
    return {'processor': model, 'cores': os.cpu_count(), 'load': os.getloadavg()[0]}
