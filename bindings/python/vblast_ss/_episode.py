"""What environments have in common: spaces, gymnasium's where it is installed, else small ones that stand in, and the
begin and end of episodes."""
from __future__ import annotations

import copy
import importlib
from typing import Any, Mapping, Optional, TypeVar

import numpy as np

from ._picture import Picture
from ._window import Window

VIEW_TARGET, VIEW_SIZE = (0.0, 0.01, 0.01), 0.16
"""Middle and height of a picture, m."""

E = TypeVar("E", bound="Episodes")

Base: Any = object
"""gymnasium.Env where there is one."""
_GymnasiumBox: Any = None
try:
    _gymnasium: Any = importlib.import_module("gymnasium")
except ImportError:
    pass
else:
    Base, _GymnasiumBox = _gymnasium.Env, _gymnasium.spaces.Box


class _Box:
    """Arrays between bounds, as far as an environment needs gymnasium.spaces.Box."""

    def __init__(self, low: Any, high: Any, shape: Optional[tuple[int, ...]] = None, dtype: Any = np.float64,
                 seed: Optional[int] = None) -> None:
        self.dtype = np.dtype(dtype)
        self.shape = np.broadcast(np.asarray(low), np.asarray(high)).shape if shape is None else tuple(shape)
        self.low, self.high = (np.broadcast_to(np.asarray(bound, self.dtype), self.shape) for bound in (low, high))
        self.seed(seed)

    def seed(self, seed: Optional[int] = None) -> None:
        self._random = np.random.default_rng(seed)

    def sample(self) -> Any:
        if not (np.isfinite(self.low).all() and np.isfinite(self.high).all()):
            raise ValueError("there is no even chance without bounds")
        return self._random.uniform(self.low, self.high).astype(self.dtype)

    def contains(self, x: Any) -> bool:
        x = np.asarray(x)
        return x.shape == self.shape and bool(((x >= self.low) & (x <= self.high)).all())

    __contains__ = contains

    def __repr__(self) -> str:
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


Box: Any = _GymnasiumBox or _Box
"""gymnasium.spaces.Box where there is one."""


class Episodes(Base):  # type: ignore[misc]
    """An environment over a scene that is made anew for each episode."""
    metadata: dict[str, Any] = {"render_modes": ["human", "rgb_array"], "render_fps": 100}
    spec = None

    def __init__(self, time_limit: float, control: int, record: bool, actions: int, observed: int,
                 render_mode: Optional[str] = None) -> None:
        if control < 1 or not time_limit > 0.0:
            raise ValueError("an episode has steps and time")
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise ValueError(f"render_mode is {render_mode!r}, not None or one of {self.metadata['render_modes']}")
        self.render_mode = render_mode
        # Videos then run in simulated time.
        self.metadata = {**self.metadata, "render_fps": max(1, round(1000 / control))}
        self._picture: Any = None
        self._window: Optional[Window] = None
        self.time_limit, self.control, self.recorded = time_limit, control, record
        self.observation_space = Box(-np.inf, np.inf, (observed,), np.float64)
        self.action_space = Box(-1.0, 1.0, (actions,), np.float64)
        self._scene: Any = None
        self._random = np.random.default_rng()
        self._log = b""
        self._over = True

    def _fields(self, seed: Optional[int], options: Optional[Mapping[str, Any]]) -> dict[str, Any]:
        """Of the task of an episode; without a seed the next one of a series that the last seed began."""
        if Base is not object:
            super().reset(seed=seed)  # of gymnasium, whose np_random is not used here
        if seed is not None:
            self._random = np.random.default_rng(seed)
        return {"seed": int(self._random.integers(2**32)), **dict(options or {})}

    def _wanted(self, action: Any) -> Any:
        if self._scene is None or self._over:
            raise RuntimeError("the episode is over: reset()")
        wanted = np.asarray(action, np.float64)
        if wanted.shape != self.action_space.shape or not np.isfinite(wanted).all():
            raise ValueError(f"an action is {self.action_space.shape[0]} finite numbers")
        return np.clip(wanted, -1.0, 1.0)

    def take_log(self) -> bytes:
        """Ends the log of the episode, and gives it; analysis.trace() reads it."""
        if self._scene is None:
            raise RuntimeError("there is no episode: reset()")
        record = self._scene.record
        if record is None:
            raise RuntimeError(f"nothing is recorded: {type(self).__name__}(record=True)")
        if not record.closed:
            record.end()
            self._log += record.take()
            record.close()
        return self._log

    def render(self) -> Any:
        """With render_mode="rgb_array" the scene, 360 x 480 x 3, uint8, drawn by numpy alone; otherwise None. With "human" each
        reset() and step() shows that picture in a window."""
        if self._scene is None and self.render_mode is not None:
            raise RuntimeError("there is no episode: reset()")
        return self._drawn() if self.render_mode == "rgb_array" else None

    def _drawn(self) -> Any:
        if self._picture is None:
            self._picture = Picture(self._scene.scene, VIEW_TARGET, VIEW_SIZE)
        return self._picture.draw()

    def _show(self) -> None:
        """In the window, if there is to be one."""
        if self.render_mode != "human":
            return
        if self._window is None:
            self._window = Window(type(self).__name__, self.metadata["render_fps"])
        self._window.show(self._drawn())

    def _end(self) -> None:
        """Of the episode, whose scene is destroyed; the window stays for the next one."""
        self._picture = None
        if self._scene is not None:
            self._scene.close()
        self._scene = None
        self._over = True

    def close(self) -> None:
        self._end()
        if self._window is not None:
            self._window.close()
        self._window = None

    def __getstate__(self) -> dict[str, Any]:
        """Of a copy, and in a pickle: everything, also an episode that has begun, except the window and the log."""
        if self._scene is not None and self._scene.record is not None:
            raise TypeError("an episode that is recorded cannot be copied or pickled: a log has one writer. Copy the environment "
                            "before reset() or after close()")
        return {**vars(self), "_picture": None, "_window": None}

    def __copy__(self: E) -> E:
        return copy.deepcopy(self)

    def __enter__(self: E) -> E:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


def register(name: str, entry_point: str) -> None:
    """Makes gymnasium.make(name) work, where gymnasium is installed."""
    if Base is not object and name not in _gymnasium.registry:
        _gymnasium.register(id=name, entry_point=entry_point)
