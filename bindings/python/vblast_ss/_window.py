"""A window for pictures, by pygame, as gymnasium's own environments have it. pygame is loaded with the first window."""
from __future__ import annotations

import importlib
import os
from typing import Any

SCALE = 2
"""Pixels of the window along a pixel of the picture."""
UNSEEN = ("dummy", "offscreen")
"""SDL's drivers without a display. SDL may fall back on them."""


class Window:
    """Shows pictures, height x width x 3, uint8, of one size, at most `rate` of them a second. pygame has one window in a process: of
    several objects the last to show a picture has it."""

    def __init__(self, title: str, rate: int) -> None:
        try:
            self._pygame: Any = importlib.import_module("pygame")
        except ImportError:
            raise ImportError('render_mode="human" needs pygame: python3 -m pip install pygame') from None
        self._title, self._rate = title, rate
        self._surface: Any = None
        self._dismissed = False
        self._begin()
        self._clock = self._pygame.time.Clock()

    def _begin(self) -> None:
        display = self._pygame.display
        try:
            display.init()
        except self._pygame.error as failure:
            raise RuntimeError(f'render_mode="human" needs a display: {failure}') from None
        driver = display.get_driver()
        if driver in UNSEEN and os.environ.get("SDL_VIDEODRIVER") != driver:
            display.quit()
            raise RuntimeError('render_mode="human" needs a display: there is none (is DISPLAY or WAYLAND_DISPLAY set?)')

    def show(self, picture: Any) -> None:
        """Waits until the picture before has been there long enough. Does nothing after the user has closed the window."""
        if self._dismissed:
            return
        pygame = self._pygame
        if self._surface is None or pygame.display.get_surface() is not self._surface:
            self._begin()
            height, width = picture.shape[:2]
            self._surface = pygame.display.set_mode((SCALE * width, SCALE * height))
            pygame.display.set_caption(self._title)
        if any(event.type == pygame.QUIT for event in pygame.event.get()):
            self.close()
            return
        small = pygame.surfarray.make_surface(picture.swapaxes(0, 1))
        pygame.transform.scale(small, self._surface.get_size(), self._surface)
        pygame.display.flip()
        self._clock.tick(self._rate)

    def close(self) -> None:
        if not self._dismissed and (self._surface is None or self._pygame.display.get_surface() is self._surface):
            self._pygame.display.quit()
        self._surface, self._dismissed = None, True
