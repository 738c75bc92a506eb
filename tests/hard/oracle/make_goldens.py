#!/usr/bin/env python3
"""Writes goldens.txt: where rays cross shapes, to the nearest double.

Shares nothing with the renderer's formulas: no discriminant, no determinant. A solid is a convex
function of the point, below zero inside. Along a ray it is convex too: its lowest point is closed in
on by thirds, and the two crossings on either side of it by halves, in numbers of 60 digits. A flat
shape is the sign of a height, and an outline around the point where it changes.

    make_goldens.py > goldens.txt        a minute; needs python3 with mpmath

A line is: kind, its numbers, ':', origin and direction, ':', the values of t >= 0 in order. Solids
are capped; a cone's numbers are base, top and both radii. In about half of the lines all numbers are
floats as well.
"""

import random
import struct

from mpmath import mp, mpf, sqrt

mp.dps = 60
HALVINGS = 230  # more bits than 60 digits hold
dice = random.Random(4)


def vector(*xs):
    return [mpf(x) for x in xs]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def along(o, d, t):
    return [x + t * y for x, y in zip(o, d)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return sqrt(dot(a, a))


def halve(sign_at, inside, outside):
    """Where sign_at changes from true at `inside` to false at `outside`."""
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        if sign_at(middle):
            inside = middle
        else:
            outside = middle
    return inside


def cross_convex(f, o, d, middle, size):
    """The crossings of a convex function whose inside lies within `size` of `middle`."""
    at = lambda t: f(along(o, d, t))
    closest = dot(sub(middle, o), d) / dot(d, d)
    reach = 2 * size / norm(d)
    low, high, inside = closest - reach, closest + reach, None
    for _ in range(2 * HALVINGS):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        fa, fb = at(a), at(b)
        if fa < 0 or fb < 0:
            inside = a if fa < fb else b
            break
        if fa < fb:
            high = b
        else:
            low = a
    if inside is None:
        return []
    is_inside = lambda t: at(t) < 0
    return [halve(is_inside, inside, closest - reach), halve(is_inside, inside, closest + reach)]


def cross_flat(o, d, point, normal, holds):
    height = lambda t: dot(sub(along(o, d, t), point), normal)
    above = height(mpf(0)) > 0
    far = mpf(1)
    while (height(far) > 0) == above:
        far *= 2
        if far > mpf(2) ** 200:
            return []
    t = halve(lambda s: (height(s) > 0) == above, mpf(0), far)
    return [t] if holds(along(o, d, t)) else []


def frustum(base, top, base_radius, top_radius):
    axis = sub(top, base)
    height = norm(axis)
    axis = [x / height for x in axis]

    def f(p):
        q = sub(p, base)
        z = dot(q, axis)
        around = norm(sub(q, [z * x for x in axis]))
        return max(around - (base_radius + (top_radius - base_radius) * z / height), -z, z - height)

    return f, height


def crossings(kind, n, o, d):
    if kind == "sphere":
        return cross_convex(lambda p: norm(sub(p, n[:3])) - n[3], o, d, n[:3], n[3])
    if kind == "box":
        f = lambda p: max(max(a - x, x - b) for x, a, b in zip(p, n[:3], n[3:]))
        return cross_convex(f, o, d, n[:3], norm(sub(n[3:], n[:3])))
    if kind in ("cylinder", "cone"):
        f, height = frustum(n[:3], n[3:6], n[6], n[-1])
        return cross_convex(f, o, d, n[:3], height + n[6] + n[-1])
    if kind == "plane":
        normal = n[:3]
        point = [x * n[3] / dot(normal, normal) for x in normal]
        return cross_flat(o, d, point, normal, lambda p: True)
    if kind == "disc":
        within = lambda p: n[7] <= norm(sub(p, n[:3])) <= n[6]
        return cross_flat(o, d, n[:3], n[3:6], within)
    first, u, v = n[:3], n[3:6], n[6:]
    if kind == "triangle":
        u, v = sub(u, first), sub(v, first)
    normal = cross(u, v)

    def holds(p):
        q = sub(p, first)
        a, b = dot(cross(q, v), normal), dot(cross(u, q), normal)
        size = dot(normal, normal)
        return a >= 0 and b >= 0 and (a + b <= size if kind == "triangle" else max(a, b) <= size)

    return cross_flat(o, d, first, normal, holds)


def as_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def spot(size):
    return [dice.uniform(-size, size) for _ in range(3)]


def direction():
    while True:
        v = spot(1)
        length = float(norm(vector(*v)))
        if 0.1 < length < 1:
            return [x / length for x in v]


def aside(d):
    v = cross(d, direction())
    length = float(norm(vector(*v)))
    return [x / length for x in v]


def ray_past(middle, impact, distance):
    """A ray that passes `middle` at the distance `impact`, as far as doubles allow."""
    d = direction()
    return [m + impact * a - distance * x for m, a, x in zip(middle, aside(d), d)], d


def cases():
    for i in range(60):
        yield "sphere", spot(2) + [dice.uniform(0.2, 2)], ray_past(spot(2), 0.3, 5)
    for i in range(40):
        graze = 1 + dice.choice((-1, 1)) * 10 ** -dice.uniform(2, 10)
        yield "sphere", [0, 0, 0, 1], ray_past([0, 0, 0], graze, dice.uniform(0.1, 10))
    for i in range(40):
        radius = 10.0 ** dice.randint(6, 10)
        up = direction()
        d = direction()
        d = [x if i % 4 else -u for x, u in zip(d, up)]
        yield "sphere", [-(radius + 2) * u for u in up] + [radius], ([0, 0, 0], d)
    for i in range(100):
        low = spot(2)
        yield "box", low + [x + dice.uniform(0.1, 2) for x in low], ray_past(low, 1, 5)
    for i in range(100):
        base, axis = spot(2), direction() if i % 3 else [0, 1, 0]
        top = [b + dice.uniform(0.3, 3) * a for a, b in zip(axis, base)]
        if i % 3 == 0:
            top = [base[0], base[1] + dice.uniform(0.3, 3), base[2]]
        yield "cylinder", base + top + [dice.uniform(0.2, 2)], ray_past(base, 1, 5)
        radii = [dice.uniform(0.2, 2), 0 if i % 2 else dice.uniform(0.2, 2)]
        yield "cone", base + top + radii, ray_past(top if i % 4 else base, 0.5, 5)
    for i in range(100):
        yield "plane", direction() + [dice.uniform(-2, 2)], (spot(5), direction())
        corners = spot(2) + spot(2) + spot(2)
        inside = [sum(corners[k::3]) / 3 for k in range(3)]
        yield "triangle", corners, ray_past(inside, 0.3, 4)
        yield "quad", corners, ray_past(corners[:3], 1, 4)
        middle = spot(2)
        yield "disc", middle + direction() + [2, 0.5], ray_past(middle, 1, 4)


for kind, numbers, (origin, d) in cases():
    rounded = dice.choice((as_float, float))
    numbers, origin, d = ([rounded(x) for x in xs] for xs in (numbers, origin, d))
    found = crossings(kind, vector(*numbers), vector(*origin), vector(*d))
    values = [float(t) for t in found if t >= 0]
    hexes = lambda xs: " ".join(x.hex() for x in xs)
    print(kind, hexes(numbers), ":", hexes(origin + d), ":", hexes(values))
