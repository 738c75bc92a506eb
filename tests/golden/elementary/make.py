#!/usr/bin/env python3
"""Writes table.txt: what the functions of core/math/elementary.h are in truth, by mpmath.

Each line: function, one or two arguments, result rounded to double, and what is left of it, all in
hexadecimal. Arguments are drawn from a fixed seed. With --constants it prints the two-word constants
that stand in the source instead.
"""
import math
import random
import struct
import sys

import mpmath as mp

mp.mp.prec = 1400  # sines of 2^1000 degrees need as many bits as their argument


def words(value):
    hi = float(value)
    return hi.hex(), (float(value - mp.mpf(hi)) if math.isfinite(hi) else 0.0).hex()


def constants():
    for name, value in [("2 pi", 2 * mp.pi), ("pi/180", mp.pi / 180), ("1/(2 pi)", 1 / (2 * mp.pi)),
                        ("1/3", mp.mpf(1) / 3), ("1/5", mp.mpf(1) / 5)]:
        print(name, *words(value))
    head = math.floor(mp.log(2) * 2**42) / 2**42
    print("ln 2", head.hex(), *words(mp.log(2) - mp.mpf(head)))
    for i in range(9):
        print(f"atan({i}/8)/(2 pi)", *words(mp.atan(mp.mpf(i) / 8) / (2 * mp.pi)))


FUNCTIONS = {
    "exp_of": lambda x: mp.exp(x),
    "log_of": lambda x: mp.log(x),
    "power": lambda x, y: mp.power(x, y),
    "sin_deg": lambda x: mp.sin(x * mp.pi / 180),
    "cos_deg": lambda x: mp.cos(x * mp.pi / 180),
    "tan_deg": lambda x: mp.tan(x * mp.pi / 180),
    "sin_turns": lambda u: mp.sin(2 * mp.pi * (u - mp.floor(u))),
    "cos_turns": lambda u: mp.cos(2 * mp.pi * (u - mp.floor(u))),
    "asin_deg": lambda x: mp.asin(x) * 180 / mp.pi,
    "acos_deg": lambda x: mp.acos(x) * 180 / mp.pi,
    "acos_turns": lambda x: mp.acos(x) / (2 * mp.pi),
    "atan2_deg": lambda y, x: mp.atan2(y, x) * 180 / mp.pi,
    "atan2_turns": lambda y, x: mp.atan2(y, x) / (2 * mp.pi),
}


def any_double(rng):
    """A finite nonzero double, every exponent as likely as any other."""
    bits = rng.getrandbits(64)
    value = struct.unpack("<d", struct.pack("<Q", bits))[0]
    return value if math.isfinite(value) and value != 0 else any_double(rng)


def near(rng, value):
    return value * (1 + rng.choice([-1, 1]) * 2.0 ** -rng.randint(2, 52))


def arguments(name, rng):
    if name == "exp_of":
        return [rng.uniform(-745, 709.7) for _ in range(30)] + [near(rng, 0.5 * k * math.log(2)) for k in
                range(-1400, 1400, 97)] + [math.copysign(2.0 ** -k, -1 if k % 2 else 1) for k in range(0, 70, 7)]
    if name == "log_of":
        return [abs(any_double(rng)) for _ in range(30)] + [near(rng, 1.0) for _ in range(30)] + [
            5e-324, 2.2e-308, 1.7976931348623157e308]
    if name == "power":
        pairs = [(rng.uniform(0, 4), rng.uniform(-60, 60)) for _ in range(30)]
        for _ in range(30):  # results over the whole range of exponents
            base = abs(any_double(rng))
            pairs.append((base, rng.uniform(-744, 709) / math.log(base)))
        return pairs + [(near(rng, 1.0), 2.0 ** rng.randint(0, 40)) for _ in range(20)]
    if name in ("sin_deg", "cos_deg", "tan_deg"):
        return [rng.uniform(-400, 400) for _ in range(30)] + [near(rng, 30.0 * k) for k in range(1, 40)] + [
            any_double(rng) for _ in range(30)]
    if name in ("sin_turns", "cos_turns"):
        return [rng.uniform(-2, 2) for _ in range(30)] + [near(rng, 0.125 * k) for k in range(1, 40)] + [
            any_double(rng) for _ in range(20)]
    if name in ("asin_deg", "acos_deg", "acos_turns"):
        return [rng.uniform(-1, 1) for _ in range(30)] + [
            rng.choice([-1, 1]) * (1 - 2.0 ** -rng.randint(1, 53)) for _ in range(20)] + [
            rng.choice([-1, 1]) * 2.0 ** -rng.uniform(0, 1070) for _ in range(30)] + [0.5, -0.5]
    pairs = [(rng.uniform(-1, 1), rng.uniform(-1, 1)) for _ in range(40)]
    pairs += [(any_double(rng), any_double(rng)) for _ in range(60)]
    for _ in range(40):  # along the borders of the octants
        x = rng.uniform(-3, 3)
        pairs.append((near(rng, x * rng.choice([-1, 1, 0.0625, 0.1875, 16])), x))
    return pairs


def main():
    if "--constants" in sys.argv:
        constants()
        return
    with open(__file__.replace("make.py", "table.txt"), "w") as table:
        for name, function in FUNCTIONS.items():
            rng = random.Random(name)
            for given in arguments(name, rng):
                given = given if isinstance(given, tuple) else (given,)
                hi, lo = words(function(*map(mp.mpf, given)))
                if math.isinf(float.fromhex(hi)):
                    continue  # overflow has its own test
                if name == "atan2_deg" and float.fromhex(hi) == -180:
                    continue  # the contract gives 180
                print(name, *(g.hex() for g in given), hi, lo, file=table)


main()
