"""Simulation of laparoscopic suturing: the Python binding of libvblast_ss.

    import vblast_ss as vb

    with vb.Thread(preset="silk_2_0", length=0.1) as thread:
        thread.attach("clamp", direction=(1, 0, 0))
        for _ in range(100):
            thread.step(1e-3)
        print(thread.positions[-1], thread.energies.total)

Objects: Context, Thread, Drain, Needle, Grasper, Scene, KnotDetector, Collision, Device, Mock, Output,
Openhaptics, Nidaqmx, Metrics, Record, Replay, Replica, Session, Visual. Settings are keywords over the library's
defaults; failures are exceptions (vblast_ss.errors); arrays are
read-only views without a copy (vblast_ss.views says how long they are good). SI units everywhere. The page
docs/guides/python.md tells more; vblast_ss._api is the C interface as it is."""
from __future__ import annotations

from . import collision, errors, views
from ._library import lib
from ._values import baseline_defaults, solver_defaults  # noqa: F401
from .core_speed import *  # noqa: F401,F403
from .collision import *  # noqa: F401,F403
from .context import *  # noqa: F401,F403
from .context import version
from .devices import *  # noqa: F401,F403
from .drain import *  # noqa: F401,F403
from .errors import *  # noqa: F401,F403
from .grasper import *  # noqa: F401,F403
from .hardware import *  # noqa: F401,F403
from .knots import *  # noqa: F401,F403
from .metrics import *  # noqa: F401,F403
from .needle import *  # noqa: F401,F403
from .records import *  # noqa: F401,F403
from .replica import *  # noqa: F401,F403
from .scene import *  # noqa: F401,F403
from .sessions import *  # noqa: F401,F403
from .thread import *  # noqa: F401,F403
from .views import View
from .visual import *  # noqa: F401,F403

__version__ = version()

library_path: str = lib.path
"""The shared library that is used."""
