"""A throw by one mouse: what the two scripted hands of examples/throw do at once, one tool after the other.

The right tool has the limb and winds it about the left one, which then takes the tail and draws it through."""
import math

from desk import add, dot

CERTIFIED = 4  # VBSS_KNOT_VERDICT_CERTIFIED
BEND = 0.8  # rad, of the jaws of angled tools
TRIES = 3  # to take the tail
BEHIND = 2e-3  # of the grasp, from the jaws' tip
TAIL_ROOT = (4.14e-3, 0.0, -1.49e-3)  # where it comes out of the drain


def places(*all_of_them):
    """Of a tool's tip, from mm."""
    return [tuple(1e-3 * v for v in place) for place in all_of_them]


NEAR = places((-38, -2, 40), (-19.5, -12.3, 29.3), (0, -23.5, 18.7), (2.2, -24.9, 17.6))
WRAPPED_ABOUT = places((-44.8, -47.7, 53.4), (-22.7, -29.8, 43.9), (-.6, -11.9, 34.3), (14, 0, 28))
ROUND = places((0, -25.1, 18), (-4.7, -23.9, 38.9), (-2.4, -7.4, 54.6), (2, 14.8, 52.4), (5.9, 27.7, 33.9), (6.7, 22, 11.9),
               (3.8, 1.4, 3.8), (-.1, -16.4, 16.5), (-1.1, -15.8, 39.1), (1.8, 2.5, 50.3), (3.5, 10.4, 48.2),
               (4.7, 15.4, 45.4))
RELEASED = places((7, 13, 39), (9.5, 13, 34))  # or the turns hold the left tool
OVER_TAIL = places((20, -.6, 25.5))
# drawn through: the left tool with the tail, the right one that gives way, a piece each
DRAWN = list(zip(
    places((26.9, .8, 17.1), (21.2, .3, 18.9), (17.7, .3, 21.1), (14, .3, 22.7), (10, .3, 23.7), (6, .4, 24), (2, .4, 23.6),
           (-1.6, .4, 22), (-4.8, .4, 20), (-7, .4, 17.6), (-9.4, .5, 15), (-11.2, .5, 12), (-12, .5, 10.3)),
    places((9, 15.3, 35.4), (14.8, 15.3, 33.7), (20.8, 15.3, 31.9), (26.8, 15.3, 30), (27, 12.6, 28), (27, 10.6, 26.5),
           (23.8, 8.7, 25.7), (20.9, 7.2, 24.9), (19.5, 6.2, 23.8), (18.6, 5.5, 22.5), (18.8, 5, 21.2), (19.7, 4.6, 19.8),
           (21.6, 4.6, 19))))
# and down, where the last turn leaves the jaws if it has not yet
LOWERED = list(zip(
    places((-12.5, .2, 7), (-13.5, -.2, 4), (-14.5, -.2, 2.6), (-14.8, -.2, 2.4), (-15, -.2, 2.4)),
    places((26, 4.6, 17.6), (32, 4.2, 16.5), (38, 3.8, 15.3), (43, 3.4, 14.2), (47, 3.1, 13.2))))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def take_tail(desk):
    """Jaws open to both sides of it, then to where it is."""
    tail = add(desk.wait(1).ends[0], TAIL_ROOT, -1.0)
    tool = desk.state.tools["left"]
    across = cross(tool.axis((0.0, 0.0, 1.0)), tail)
    if dot(across, tool.axis((1.0, 0.0, 0.0))) < 0.0:
        across = tuple(-v for v in across)
    desk.jaws("left", False)
    desk.roll_to("left", across, axis=(1.0, 0.0, 0.0))
    for _ in range(TRIES):
        for _ in range(2):
            s = desk.wait(1)
            tool = s.tools["left"]
            node = add(s.ends[0], tail, -1.5e-3 / math.sqrt(dot(tail, tail)))
            handle = add(tuple(math.sin(BEND) * v for v in tool.axis((0.0, 1.0, 0.0))), tool.axis((0.0, 0.0, 1.0)),
                         math.cos(BEND))
            desk.go("left", add(node, handle, -BEHIND), 0.04, near=0.3e-3)
        desk.jaws("left", True)
        if desk.wait(10).tools["left"].holds == 1:
            return
        desk.jaws("left", False)
    raise AssertionError("the tail is not taken")


def draw(desk, pieces):
    """True: it is tied."""
    for left, right in pieces:
        desk.go("right", right, corrections=0)
        desk.go("left", left, corrections=0)
        if desk.wait(10).result == CERTIFIED:
            return True
    return False


def tie_throw(desk):
    """Returns the last state."""
    desk.jaws("right", True)
    desk.follow("right", NEAR)
    desk.roll_to("right", (1.0, 0.0, 0.0))
    desk.follow("left", WRAPPED_ABOUT)
    desk.roll_to("left", (-1.0, 0.1, 0.0))
    desk.follow("right", ROUND)
    desk.follow("right", RELEASED)
    desk.follow("left", OVER_TAIL)
    take_tail(desk)
    if not draw(desk, DRAWN):
        desk.roll_to("left", (-1.0, 0.0, 0.3))
        draw(desk, LOWERED)
    return desk.wait(30)
