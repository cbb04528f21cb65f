"""Many scenes at once: each in a context of its own, worked on by several threads.

    from vblast_ss.batch import Batch

    def make(bending):
        scene = vb.Scene(vb.Context())
        scene.add(vb.Thread(scene.context, bending_stiffness=bending))
        return scene

    with Batch(make, [1e-8, 2e-8, 4e-8], workers=2) as batch:
        batch.step(1e-3, 100)
        print(batch.map(lambda scene: scene.state_hash))
        print(batch.costs, batch.errors)

Calls of the library let other Python threads run, so workers gain as far as the time is spent in the library. What
comes out does not depend on how many there are, as long as scenes share nothing. Over processes and machines:
bindings/python/examples/sweep_throws.py."""
from __future__ import annotations

import concurrent.futures
import os
import time
from typing import Any, Callable, Generic, Iterable, NamedTuple, Optional, TypeVar

from .errors import Error

__all__ = ["Batch", "Cost"]

I = TypeVar("I")
S = TypeVar("S")
V = TypeVar("V")


class Cost(NamedTuple):
    """What a scene has cost so far."""
    seconds: float
    """Processor time of the threads that worked on it."""
    steps: int
    """Of step()."""


class Batch(Generic[I, S]):
    """Scenes, or anything else with step(h), made from items.

        make     called with each item; gives a scene in a context of its own
        items    of any kind, one a scene
        workers  threads; default: as many as there are processors

    An error of one scene, also of make, is data: it stands in `errors`, the scene is left as it is, and the others
    go on. What is no Exception, such as KeyboardInterrupt, is raised. Closing the batch closes contexts, or what
    else has close().
    """

    def __init__(self, make: Callable[[I], S], items: Iterable[I], *, workers: Optional[int] = None) -> None:
        self.items = list(items)
        if workers is not None and workers < 1:
            raise ValueError(f"{workers} workers")
        self.workers = workers or os.cpu_count() or 1
        self._scenes: list[Optional[S]] = [None] * len(self.items)
        self._errors: list[Optional[Exception]] = [None] * len(self.items)
        self._seconds = [0.0] * len(self.items)
        self._steps = [0] * len(self.items)
        self._pool = concurrent.futures.ThreadPoolExecutor(self.workers, "vblast_ss")

        def begin(number: int) -> None:
            self._scenes[number] = make(self.items[number])

        try:
            self._each(begin)
        except BaseException:
            self.close()
            raise

    # ---- work

    def _each(self, work: Callable[[int], V]) -> list[Optional[V]]:
        """Work on every scene that is still good; an error is its last."""
        def guarded(number: int) -> Optional[V]:
            begun = time.thread_time()
            try:
                return work(number)
            except Exception as error:
                self._errors[number] = error
                return None
            finally:
                self._seconds[number] += time.thread_time() - begun

        good = [number for number, error in enumerate(self._errors) if error is None]
        running = {number: self._pool.submit(guarded, number) for number in good}
        concurrent.futures.wait(running.values())
        found: list[Optional[V]] = [None] * len(self.items)
        for number, future in running.items():
            found[number] = future.result()
        return found

    def step(self, h: float = 1e-3, count: int = 1,
             before: Optional[Callable[[S, int], Any]] = None) -> None:
        """Steps every good scene `count` times; `before` is called with scene and number (0 ... count - 1) before each
        step, to move what is to be moved."""
        def work(number: int) -> None:
            scene: Any = self._scenes[number]
            for i in range(count):
                if before is not None:
                    before(scene, i)
                scene.step(h)
                self._steps[number] += 1

        self._each(work)

    def map(self, function: Callable[[S], V]) -> list[Optional[V]]:
        """What a function gives for each good scene, in the order of the items; None for the others."""
        return self._each(lambda number: function(self._scenes[number]))  # type: ignore[arg-type]

    # ---- what there is to see

    @property
    def scenes(self) -> list[Optional[S]]:
        """None: it could not be made."""
        return list(self._scenes)

    @property
    def errors(self) -> list[Optional[Exception]]:
        """None: it is good."""
        return list(self._errors)

    @property
    def costs(self) -> list[Cost]:
        return [Cost(*pair) for pair in zip(self._seconds, self._steps)]

    def close(self) -> None:
        """Closes every scene with its context; what will not close is left to go with its last reference."""
        self._pool.shutdown()
        for scene in self._scenes:
            context = getattr(scene, "context", None)
            thing: Any = context if hasattr(context, "close") else scene
            if hasattr(thing, "close"):
                try:
                    thing.close()
                except Error:
                    pass
        self._scenes = [None] * len(self.items)

    def __len__(self) -> int:
        return len(self.items)

    def __enter__(self) -> Batch[I, S]:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        bad = sum(error is not None for error in self._errors)
        return f"<Batch of {len(self)} scenes, {bad} ended by an error, {self.workers} workers>"
