"""A plug-in that changes the floating-point mode of the process does not disturb the library."""
import ctypes
import platform
import subprocess
import sys
import textwrap

import pytest

import vblast_ss as vb

LINES = """
    #include <xmmintrin.h>
    void set_mode(unsigned mode) { _mm_setcsr(mode); }
    unsigned get_mode(void) { return _mm_getcsr() & 0xffc0; }
"""
MODES = {"flushed": 0x9fc0, "upward": 0x5f80, "to zero": 0x7f80}


@pytest.fixture(scope="module")
def plug_in(tmp_path_factory):
    if platform.machine() not in ("x86_64", "AMD64") or sys.platform == "win32":
        pytest.skip("the plug-in is for x86-64")
    folder = tmp_path_factory.mktemp("plug_in")
    (folder / "mode.c").write_text(textwrap.dedent(LINES))
    subprocess.run(["cc", "-shared", "-fPIC", "-o", folder / "mode.so", folder / "mode.c"], check=True)
    return ctypes.CDLL(str(folder / "mode.so"))


def state(set_mode, mode):
    """Hash after some steps in a mode. The settings are numbers of the host, so they are read before."""
    with vb.Thread(segment_count=20, length=0.1) as thread:
        set_mode(mode)
        try:
            for _ in range(10):
                thread.step(1e-3)
        finally:
            set_mode(0x1f80)
        return thread.state_hash


def test_a_mode_that_a_plug_in_sets_does_not_matter(plug_in):
    wanted = state(plug_in.set_mode, 0x1f80)
    for name, mode in MODES.items():
        assert state(plug_in.set_mode, mode) == wanted, name


def test_the_mode_is_the_hosts_afterwards_and_in_its_callbacks(plug_in):
    seen = []
    with vb.Context(log=lambda level, text: seen.append(plug_in.get_mode())) as context:
        plug_in.set_mode(MODES["upward"])
        try:
            with pytest.raises(vb.OutOfRangeError):
                vb.Thread(context=context, length=-1.0)
            after = plug_in.get_mode()
        finally:
            plug_in.set_mode(0x1f80)
    assert seen == [MODES["upward"]] and after == MODES["upward"]
