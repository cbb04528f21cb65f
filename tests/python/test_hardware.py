"""Real hardware, with the stand-ins of the C tests in place of the vendors' libraries."""
import os
import pathlib
import time

import pytest

import vblast_ss as vb

STAND_INS = pathlib.Path(os.environ.get("VBSS_BUILD", "build/default")) / "tests" / "stand_ins"
HD, DAQ = str(STAND_INS / "libstand_in_openhaptics.so"), str(STAND_INS / "libstand_in_nidaqmx.so")
there = pytest.mark.skipif(not os.path.exists(HD) or not os.path.exists(DAQ), reason="no stand-ins are built")


def test_missing_libraries_are_reported(context):
    with pytest.raises(vb.DeviceError, match="no library /nowhere/hd"):
        vb.Openhaptics(context, library="/nowhere/hd")
    with pytest.raises(vb.DeviceError, match="no library /nowhere/daq"):
        vb.Nidaqmx(context, library="/nowhere/daq")
    with pytest.raises(TypeError, match="no setting 'nam'"):
        vb.Nidaqmx(context, nam="x")
    assert context.statistics.objects_alive == 0


@there
def test_a_device_reads_an_arm_and_a_handle(context):
    with vb.Openhaptics(context, library=HD, device_count=2) as arms, \
            vb.Nidaqmx(context, library=DAQ, own_thread=0) as lines:
        assert arms.identity(1) == ("Touch (stand-in)", "stand-in 2")
        lines.poll(0.0)
        with vb.Device(arms.arm(0), lines.handle(0)) as device:
            end = time.monotonic() + 5.0
            while arms.status().ticks == 0 and time.monotonic() < end:
                time.sleep(1e-3)
            lines.poll(0.1)
            found = device.read(0.1)
            assert found.status == vb.DeviceStatus.READY and abs(found.jaw_raw) < 0.01
            for now in (0.1, 0.101):  # a force rises from the first write on
                out = device.write_coupled(now, {"position": (found.position[0] + 1e-3, *found.position[1:]),
                                                 "stiffness": 100.0, "force": (0.0, 0.05, 0.0)})
            assert out.force[:2] == pytest.approx((0.1, 0.05))
        assert arms.status(1).state == vb.HapticsState.RUNNING and arms.status().errors == 0
        assert lines.status.cycles == 2 and lines.status.state == vb.HapticsState.RUNNING
        assert "ticks" in repr(arms) and "rounds" in repr(lines)


@there
def test_devices_of_the_driver_are_listed():
    assert vb.nidaqmx_devices(DAQ) == [("Dev1", "USB-6008"), ("Dev2", "USB-6009")]
