"""Pictures of a scene with numpy alone, where no graphics processor is: the meshes of a Visual, with a depth buffer and
one light. examples/viewer draws the same meshes far better and faster."""
from __future__ import annotations

from typing import Any

import numpy as np

from .scene import Scene
from .visual import Visual, VisualKind

COLOURS = {VisualKind.THREAD: (122, 72, 160), VisualKind.DRAIN: (222, 142, 120), VisualKind.NEEDLE: (150, 160, 175),
           VisualKind.FLOOR: (176, 182, 168)}
STEEL = (120, 128, 140)
BACKGROUND = (24, 26, 30)
DIRECTION = np.array((0.25, -1.0, 0.75)) / np.sqrt(0.25 ** 2 + 1.0 + 0.75 ** 2)
"""From the target to the eye."""


class Camera:
    """A parallel projection: x to the right, y up, z to the eye."""

    def __init__(self, target: Any, size: float, width: int, height: int) -> None:
        right = np.cross((0.0, 0.0, 1.0), DIRECTION)
        right /= np.sqrt((right * right).sum())
        self.axes = np.stack((right, np.cross(DIRECTION, right), DIRECTION))
        self.target, self.scale = np.asarray(target, float), min(width, height) / size
        self.width, self.height = width, height

    def project(self, points: Any) -> Any:
        """Column, row, and nearness to the eye, in pixels."""
        seen = (np.asarray(points) - self.target) @ self.axes.T * self.scale
        return seen * (1.0, -1.0, 1.0) + (0.5 * self.width, 0.5 * self.height, 0.0)


def triangles(camera: Camera, corners: Any, colours: Any) -> Any:
    """A picture, height x width x 3, uint8. corners: n x 3 x 3, as Camera.project gives them; colours: n x 3."""
    depth = np.full(camera.width * camera.height, -np.inf)
    picture = np.empty((camera.width * camera.height, 3), np.uint8)
    picture[:] = BACKGROUND
    low = np.floor(corners[:, :, :2].min(axis=1)).astype(int)
    high = np.ceil(corners[:, :, :2].max(axis=1)).astype(int)
    inside = (high >= 0).all(axis=1) & (low < (camera.width, camera.height)).all(axis=1)
    low, high = np.maximum(low, 0), np.minimum(high, (camera.width - 1, camera.height - 1))
    extent = (high - low).max(axis=1) + 1
    for size in (2, 4, 8, 16):
        # All triangles whose box is about that large at once, in blocks that fit into the caches.
        alike = np.flatnonzero(inside & (extent <= size) & (extent > (size // 2 if size > 2 else 0)))
        block = 2 ** 16 // size ** 2
        for first in range(0, len(alike), block):
            _fill(camera, corners, colours, alike[first:first + block], low, high, (size, size), depth, picture)
    for one in np.flatnonzero(inside & (extent > 16)):
        box = high[one] - low[one] + 1
        _fill(camera, corners, colours, np.array((one,)), low, high, (int(box[0]), int(box[1])), depth, picture)
    return picture.reshape(camera.height, camera.width, 3)


def _fill(camera: Camera, corners: Any, colours: Any, chosen: Any, low: Any, high: Any, size: tuple[int, int],
          depth: Any, picture: Any) -> None:
    offsets = np.stack(np.meshgrid(np.arange(size[0]), np.arange(size[1]), indexing="ij"), axis=-1).reshape(1, -1, 2)
    pixels = low[chosen][:, None, :] + offsets
    a, b, c = (corners[chosen, corner][:, None, :] for corner in range(3))
    x, y = pixels[..., 0] + 0.5, pixels[..., 1] + 0.5
    area = (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])
    area = np.where(area == 0.0, np.inf, area)
    of_b = ((x - a[..., 0]) * (c[..., 1] - a[..., 1]) - (y - a[..., 1]) * (c[..., 0] - a[..., 0])) / area
    of_c = ((b[..., 0] - a[..., 0]) * (y - a[..., 1]) - (b[..., 1] - a[..., 1]) * (x - a[..., 0])) / area
    covered = (of_b >= 0.0) & (of_c >= 0.0) & (of_b + of_c <= 1.0) & np.isfinite(area) & \
        (pixels <= high[chosen][:, None, :]).all(axis=2)
    near = a[..., 2] + of_b * (b[..., 2] - a[..., 2]) + of_c * (c[..., 2] - a[..., 2])
    which, place = np.nonzero(covered)
    if not len(which):
        return
    pixel = pixels[which, place, 1] * camera.width + pixels[which, place, 0]
    close = near[which, place]
    visible = close > depth[pixel]
    which, pixel, close = which[visible], pixel[visible], close[visible]
    if len(chosen) > 1:  # the nearest is written last
        order = np.argsort(close, kind="stable")
        which, pixel, close = which[order], pixel[order], close[order]
    depth[pixel] = close
    picture[pixel] = colours[chosen[which]]


class Picture:
    """Draws a scene from one place: the middle of the picture, and its smaller side, m."""

    def __init__(self, scene: Scene, target: Any, size: float, width: int = 480, height: int = 360) -> None:
        self.visual = Visual(scene.context)
        self.visual.add(scene)
        self.camera = Camera(target, size, width, height)

    def draw(self) -> Any:
        self.visual.update()
        vertices, faces = self.visual.vertices, self.visual.triangles
        colours = np.empty((len(faces), 3))
        for part in self.visual.parts:
            colours[part.triangles] = COLOURS.get(part.kind, STEEL)
        normals = vertices[:, 3:6][faces].mean(axis=1) @ self.camera.axes.T
        lengths = np.sqrt((normals * normals).sum(axis=1))
        light = np.abs(normals @ (0.36, 0.48, 0.8)) / np.where(lengths > 0.0, lengths, 1.0)
        shaded = (colours * (0.35 + 0.65 * light)[:, None]).astype(np.uint8)
        return triangles(self.camera, self.camera.project(vertices[:, :3])[faces], shaded)

    def close(self) -> None:
        self.visual.close()
