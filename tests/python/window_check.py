"""render_mode="human" with the real gymnasium and pygame. test_gymnasium.py runs it.

    window_check.py [FILE]    FILE: the frame buffer of an Xvfb, in XWD format; without it there is no display"""
import sys
import time

import gymnasium
import numpy as np

import vblast_ss.suturing  # noqa: F401  registers both environments

NAMES = ("vblast_ss/Throw-v0", "vblast_ss/Suture-v0")


def screen(path):
    """Its pixels, height x width x 3."""
    data = np.fromfile(path, np.uint8)
    header = data[:100].view(">u4")
    size, width, height, row, colours = (int(header[place]) for place in (0, 4, 5, 12, 19))
    pixels = data[size + 12 * colours:][:row * height].reshape(height, row // 4, 4)
    order = [2, 1, 0] if header[7] == 0 else [1, 2, 3]  # bytes of a pixel, the least first or last
    return pixels[:, :width, order]


def shown(path, picture):
    """Whether the picture is on the screen; a server takes a moment."""
    height, width = picture.shape[:2]
    for _ in range(50):
        if (screen(path)[:2 * height:2, :2 * width:2] == picture).all():
            return True
        time.sleep(0.05)
    return False


def check_window(name, path):
    window, pictures = (gymnasium.make(name, time_limit=0.05, render_mode=mode) for mode in ("human", "rgb_array"))
    for environment in (window, pictures):
        environment.reset(seed=1)
    first = pictures.render()
    assert shown(path, first) and len(np.unique(first.reshape(-1, 3), axis=0)) > 20
    for environment in (window, pictures):
        environment.step(np.ones(environment.action_space.shape))
    second = pictures.render()
    assert (first != second).any() and shown(path, second) and window.render() is None
    for environment in (window, pictures):  # the same window shows the next episode
        environment.reset(seed=2)
    assert shown(path, pictures.render())
    window.close()
    assert shown(path, np.zeros((360, 480, 3), dtype=np.uint8))  # the screen is black
    pictures.close()


def check_closed_by_its_user(path):
    import pygame
    environment = gymnasium.make(NAMES[0], time_limit=0.05, render_mode="human")
    environment.reset(seed=1)
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    for _ in range(3):
        environment.step(np.zeros(8))
    assert not pygame.display.get_init()
    environment.close()
    environment.reset(seed=1)  # a new one
    assert pygame.display.get_init() and screen(path).any()
    environment.close()


def check_without_display():
    environment = gymnasium.make(NAMES[0], render_mode="human")
    try:
        environment.reset(seed=1)
    except RuntimeError as error:
        assert "needs a display" in str(error), error
    else:
        raise AssertionError("a window without a display")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        for one in NAMES:
            check_window(one, sys.argv[1])
        check_closed_by_its_user(sys.argv[1])
    else:
        check_without_display()
