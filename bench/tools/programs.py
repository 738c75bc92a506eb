# bench: the programs that are compared: how each is called, and what it says about its own time.
import json
import os
import re
from dataclasses import dataclass

from measure import Failed, run


@dataclass
class Rendering:
    wall: float  # of the whole process
    cpu: float
    trace_wall: float  # of tracing alone, as the program itself tells; 0 if it does not
    trace_cpu: float
    rays: int  # of all kinds, shadow rays among them; 0 if the program does not count
    peak_bytes: int
    samples: int = 1  # a pixel


class Alhazen:
    name = 'Alhazen'

    def __init__(self, program):
        self.program = program

    def render(self, scene, size, threads, folder, more=()):
        stats = os.path.join(folder, 'stats.json')
        done = run([self.program, 'render', scene, '-o', os.path.join(folder, 'alhazen.exr'),
                    '--size', f'{size[0]}x{size[1]}', '--threads', str(threads),
                    '--progress', 'none', '--stats', stats, *more])
        with open(stats) as file:
            said = json.load(file)
        seconds = said['seconds']
        return Rendering(done.wall, done.cpu, seconds['render'], seconds['render_cpu'],
                         said['rays']['total'], done.peak_bytes,
                         round(said['samples'] / (size[0] * size[1])))

    def export(self, scene, pov, more=()):
        run([self.program, 'export-pov', scene, '-o', pov, *more])

    def import_nff(self, nff, scene):
        run([self.program, 'import', nff, '-o', scene])


class PovRay:
    """POV-Ray 3.7 as it comes: its own bounding, no window, no anti-aliasing, a PNG file."""
    name = 'POV-Ray'

    def __init__(self, program):
        self.program = program

    def render(self, pov, size, threads, folder):
        done = run([self.program, f'+I{pov}', f'+O{os.path.join(folder, "povray.png")}', '+FN',
                    f'+W{size[0]}', f'+H{size[1]}', f'+WT{threads}', '+MB3', '-D', '-V', '-A',
                    '-J'], folder)
        traced = re.search(r'Trace Time:[^(]*\(([\d.]+) seconds\)\s*\n\s*using \d+ thread\(s\) '
                           r'with ([\d.]+) CPU-seconds', done.log)
        if not traced:
            raise Failed(f'POV-Ray did not say how long it traced {pov}:\n{done.log[-800:]}')
        rays = sum(int(n) for n in re.findall(r'^(?:Rays|Shadow Ray Tests): +(\d+)', done.log, re.M))
        return Rendering(done.wall, done.cpu, float(traced[1]), float(traced[2]), rays,
                         done.peak_bytes)


class Tachyon:
    name = 'Tachyon'

    def __init__(self, program):
        self.program = program

    def render(self, nff, size, threads, folder):
        """The size is in the file."""
        done = run([self.program, nff, '-numthreads', str(threads), '-o',
                    os.path.join(folder, 'tachyon.tga')])
        said = re.search(r'Ray Tracing Time: +([\d.]+) seconds', done.log)
        if not said:
            raise Failed(f'Tachyon did not say how long it traced {nff}:\n{done.log[-800:]}')
        # It does not say its processor time apart; what is not tracing is reading the scene.
        trace = float(said[1])
        return Rendering(done.wall, done.cpu, trace, trace * done.cpu / done.wall, 0,
                         done.peak_bytes)
