"""Letters of the page against what is behind them: the contrast ratio of WCAG 2.1, at least that of its level AAA."""
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
