"""Colours of the page. The contrast ratio of letters and background reaches level AAA of WCAG 2.1. The lightness of the tension
colours rises with tension, also for people with protanopia or deuteranopia."""
import re

WANTED = 7.0
BRIGHT_TISSUE = (190, 120, 105)  # the brightest that is behind letters without a shade of their own is darkened by that shade


def linear(byte):
    v = byte / 255
    return v / 12.92 if v <= 0.03928 else ((v + 0.055) / 1.055) ** 2.4


def luminance(colour):
    return sum(share * linear(c) for share, c in zip((0.2126, 0.7152, 0.0722), colour))


def ratio(a, b):
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def rgb(text):
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


def over(text, behind):
    """A colour with its opacity before another one."""
    share = int(text[7:9], 16) / 255 if len(text) == 9 else 1.0
    return tuple(share * a + (1 - share) * b for a, b in zip(rgb(text), behind))


# What is seen without the cones of long waves (protanopia) or of middle waves (deuteranopia), from linear RGB:
# Vienot, Brettel and Mollon 1999, equations 5 and 6 with their matrices multiplied.
SEEN = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.11238, 0.88762, 0), (0.11238, 0.88762, 0), (0.00401, -0.00401, 1)),
    "deuteranopia": ((0.29275, 0.70725, 0), (0.29275, 0.70725, 0), (-0.02234, 0.02234, 1)),
}
STEPS, STEP = 5, 7.0  # of tension; of CIE lightness between two of them


def lightness(linear_rgb):
    y = sum(share * c for share, c in zip((0.2126, 0.7152, 0.0722), linear_rgb))
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


def check_tension(materials):
    names = ("slack", "half_taut", "taut")
    slack, half_taut, taut = (tuple(float(c) for c in re.search(rf"\b{name} = vec3\(([^)]*)\)", materials).group(1).split(","))
                              for name in names)
    smallest = 100.0
    for kind, matrix in SEEN.items():
        shades = []
        for i in range(STEPS):
            s = 2 * i / (STEPS - 1)
            a, b, share = (slack, half_taut, s) if s < 1 else (half_taut, taut, s - 1)
            colour = [(1 - share) * x + share * y for x, y in zip(a, b)]
            shades.append(lightness([sum(m * c for m, c in zip(row, colour)) for row in matrix]))
        steps = [b - a for a, b in zip(shades, shades[1:])]
        assert min(steps) > STEP, f"tension colours with {kind}: lightness {[round(x) for x in shades]}"
        smallest = min(smallest, *steps)
    return f"tension: {STEPS} shades, lightness {smallest:.0f} apart or more, with and without all cones"


def check(style, panel):
    root = dict(re.findall(r"--(\w+): (#\w+)", style.split("}")[0]))
    box = re.search(r"background: (#\w{8}); border: 1px solid var\(--line\)", style).group(1)
    lowest = {}
    for name in ("ink", "pale", "good", "warn", "bad"):
        lowest[name] = ratio(rgb(root[name]), over(box, BRIGHT_TISSUE))
    for name in ("ink", "warn"):  # of tool and clock
        lowest[f"{name} on its shade"] = ratio(rgb(root[name]), over(root["shade"], (120, 75, 65)))
    shade = rgb(re.search(r"SHADE = '(#\w+)'", panel).group(1))
    for name, colour in re.findall(r"(\w+): '(#\w{6})'", re.search(r"INK = {(.*)}", panel).group(1)):
        lowest[f"panel, {name}"] = ratio(rgb(colour), shade)
    low = {name: round(value, 1) for name, value in lowest.items() if value < WANTED}
    assert not low, f"contrast below {WANTED}: {low}"
    return f"contrast of letters: {min(lowest.values()):.1f} or more"
