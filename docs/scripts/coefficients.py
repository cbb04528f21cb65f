#!/usr/bin/env python3
"""Prints every constant of lib/base's elementary functions (python3-mpmath).

A polynomial is the interpolant, at Chebyshev points, of what is left of the function after its
leading terms; the bound printed with it is the largest error found on a dense grid.
"""
from mpmath import mp, mpf, asin, atan, cos, exp, floor, ldexp, log, lu_solve, matrix
from mpmath import nint, pi, sin, sqrt

mp.prec = 500


def nearest(value, bits=53):
    """The nearest number with that many significant bits."""
    if value == 0:
        return mpf(0)
    shift = bits - 1 - int(floor(log(abs(value), 2)))
    return ldexp(nint(ldexp(value, shift)), -shift)


def c(value):
    digits, exponent = float(nearest(value)).hex().split("p")
    return (digits.rstrip("0").rstrip(".") + "p" + exponent) if value else "0.0"


def entry(*values):
    lines, line = [], "    {"
    for text in [c(v) + ", " for v in values]:
        if len(line + text) > 99:
            lines.append(line.rstrip())
            line = "     "
        line += text
    print("\n".join(lines + [line[:-2] + "},"]))


def head_and_tail(value, bits=53):
    return nearest(value, bits), value - nearest(value, bits)


def polynomial(name, low, high, degree, rest, scale=lambda x: mpf(1)):
    """Coefficients of rest(x) on [low, high]; prints the bound of error * scale(x)."""
    middle, half = mpf(low + high) / 2, mpf(high - low) / 2
    nodes = [middle + half * cos(pi * (2 * i + 1) / (2 * degree + 2)) for i in range(degree + 1)]
    powers = matrix([[x**j for j in range(degree + 1)] for x in nodes])
    found = [nearest(a) for a in lu_solve(powers, matrix([rest(x) for x in nodes]))]
    grid = [middle + half * mpf(i) / 211 for i in range(-211, 212)]
    worst = max(abs((mp.polyval(found[::-1], x) - rest(x)) * scale(x)) for x in grid)
    if name:
        print(f"/* {name}: error < 2^{float(log(worst, 2)):.1f} */")
        print("    " + ",\n    ".join(c(a) for a in found))
    return found, worst


def trigonometric():
    print("/* sin(k pi/64), k = 0..127: 26 bits, the rest */")
    for k in range(128):
        entry(*(head_and_tail(sin(k * pi / 64), 26) if k % 64 else (0, 0)))
    step = pi / 64
    p1 = nearest(step, 26)
    p2 = nearest(step - p1, 26)
    print("/* pi/64 in 26 + 26 + 53 bits; in 53 + 53 bits; 64/pi */")
    entry(p1, p2, step - p1 - p2)
    entry(*head_and_tail(step))
    entry(1 / step)
    h = (step / 2 * mpf(1.001)) ** 2
    tiny = mpf(2) ** -60
    polynomial("(sin r / r - 1) / u, u = r r, times u", tiny, h, 2,
               lambda u: (sin(sqrt(u)) / sqrt(u) - 1) / u, lambda u: u)
    polynomial("(cos r - 1) / u, times u", tiny, h, 2,
               lambda u: (cos(sqrt(u)) - 1) / u, lambda u: u)
    mp.prec = 1400
    bits = int(floor(ldexp(2 / pi, 32 * 37)))
    mp.prec = 500
    words = [0, 0] + [bits >> 32 * (36 - i) & 0xFFFFFFFF for i in range(37)]
    print("/* 2/pi after two zero words */")
    for i in range(0, len(words), 6):
        print("    " + " ".join(f"0x{w:08x}u," for w in words[i : i + 6]))


def expansions(name, function, slope, step):
    print(f"/* {name}, about i {float(step)}: head, tail, slope (26 bits, rest), powers 2..10 */")
    bound, half = 0, step / 2 + mpf(2) ** -20
    for i in range(17):
        a = i * step
        if i == 0:  # odd: powers 3, 5, 7, 9
            odd, worst = polynomial("", mpf(2) ** -60, half**2, 3,
                                    lambda u: (function(sqrt(u)) / sqrt(u) - 1) / u, lambda u: u)
            found = [0, odd[0], 0, odd[1], 0, odd[2], 0, odd[3], 0]
        else:
            found, worst = polynomial(
                "", -step / 2, half, 8,
                lambda h: (function(a + h) - function(a) - slope(a) * h) / h**2,
                lambda h: h * h / (a + h))
        bound = max(bound, worst)
        entry(*head_and_tail(function(a)), *head_and_tail(slope(a), 26), *found)
    print(f"/* relative error < 2^{float(log(bound, 2)):.1f} */")


def inverse_trigonometric():
    expansions("atan", atan, lambda a: 1 / (1 + a * a), mpf(1) / 16)
    expansions("asin", asin, lambda a: 1 / sqrt(1 - a * a), mpf(1) / 32)
    print("/* pi, pi/2 */")
    entry(*head_and_tail(pi))
    entry(*head_and_tail(pi / 2))


def exponential():
    print("/* 2^(i/64): nearest double, its relative error */")
    for i in range(64):
        power = mpf(2) ** (mpf(i) / 64)
        entry(power, power / nearest(power) - 1)
    step = log(2) / 64
    print("/* 64/ln 2; ln 2/64 in 36 + 53 bits */")
    entry(1 / step)
    entry(*head_and_tail(step, 36))
    h = step / 2 * mpf(1.001)
    polynomial("(exp r - 1 - r) / r^2, times r^2", -h, h * mpf(1.000001), 4,
               lambda r: (exp(r) - 1 - r) / r**2, lambda r: r**2)


def logarithm():
    print("/* 1/c, -log(1/c) in multiples of 2^-42, the rest */")
    largest = 0
    for i in range(64):  # cells centred on multiples of 1/128 below 1, of 1/64 from 1 on
        centre = mpf(90 + i) / 128 if i < 38 else 1 + mpf(i - 38) / 64
        low = centre - mpf(1) / (256 if i <= 38 else 128)
        high = centre + mpf(1) / (256 if i < 38 else 128)
        inverse = nint(2048 / (low + high)) / 1024 if i != 38 else mpf(1)
        largest = max(largest, abs(low * inverse - 1), abs(high * inverse - 1))
        head = nint(ldexp(-log(inverse), 42)) / mpf(2) ** 42
        entry(inverse, head, -log(inverse) - head)
    head = nint(ldexp(log(2), 42)) / mpf(2) ** 42
    print(f"/* |r| <= {float(largest):.6f}; ln 2 likewise */")
    entry(head, log(2) - head)
    polynomial("(log(1 + r) - r + r^2/2) / r^3, times r^2", -largest, largest * mpf(1.000001), 5,
               lambda r: (log(1 + r) - r + r * r / 2) / r**3, lambda r: r**2)


for part in (trigonometric, inverse_trigonometric, exponential, logarithm):
    print(f"\n/* ---- {part.__name__} ---- */")
    part()
