"""Devices, adapters in Python, mocks, output stages, mappings."""
import math

import pytest

import vblast_ss as vb


class Arm(vb.Adapter):
    """An arm whose functions are noted."""
    name = "arm"

    def __init__(self):
        self.calls, self.fail, self.outputs = [], None, []

    def open(self):
        self.calls.append("open")
        if self.fail == "open":
            raise OSError("no arm")

    def close(self):
        self.calls.append("close")

    def describe(self):
        return {"signals": vb.DeviceHasBits.POSITION | vb.DeviceHasBits.JAW, "max_force": 2.0, "outputs": "force"}

    def read(self, now):
        if self.fail == "read":
            raise ZeroDivisionError("in read")
        if self.fail == "none":
            return None
        return {"time": now, "position": (now, 0.0, 0.0), "jaw": 0.5}

    def write(self, now, output):
        self.outputs.append(output)
        if self.fail == "write":
            raise KeyError("in write")

    def explain(self):
        return "nobody is there \N{EURO SIGN}"


def test_a_device_in_python_is_read_and_written(context):
    arm = Arm()
    with vb.Device(arm, context=context) as device:
        assert arm.calls == ["open"]
        found = device.read(0.001)
        assert found.position == (0.001, 0.0, 0.0) and found.jaw == pytest.approx(0.5)
        assert vb.DeviceHasBits.POSITION in found.valid and vb.DeviceHasBits.ORIENTATION not in found.valid
        out = device.write(0.001, force=(9.0, 0.0, 0.0))
        assert vb.OutputFlagBits.CLAMPED in out.flags or vb.OutputFlagBits.SLEWED in out.flags
        for i in range(2, 60):
            device.read(1e-3 * i)
            out = device.write(1e-3 * i, force=(9.0, 0.0, 0.0))
        assert 0.8 < out.force[0] <= 2.0 and arm.outputs[-1].force == out.force
        assert device.capabilities(0).max_force == 2.0 and device.capabilities().max_force == 2.0
        assert "arm" in repr(device)
    assert arm.calls == ["open", "close"] and arm.outputs[-1].force == (0.0, 0.0, 0.0)


def test_what_an_adapter_raises_reaches_the_caller(context):
    arm = Arm()
    device = vb.Device(arm, context=context)
    device.read(0.001)
    arm.fail = "read"
    with pytest.raises(ZeroDivisionError, match="in read"):
        device.read(0.002)
    assert device.statistics.failed_reads[0] == 1 and device.error(0)[1].startswith("nobody is there")
    arm.fail = "write"
    with pytest.raises(KeyError):
        device.write(0.002, force=(0.0, 0.0, 0.0))
    arm.fail = None
    device.read(0.003)
    arm.fail = "none"
    assert device.read(0.004).events & vb.DeviceEventBits.FAILED


def test_what_close_raises(context, capsys):
    class Stuck(Arm):
        def close(self):
            raise ArithmeticError("stuck")

    device = vb.Device(Stuck(), context=context)
    with pytest.raises(ArithmeticError):
        device.close()
    assert device.closed
    vb.Device(Stuck(), context=context)  # dropped: told, as nobody called for it
    assert "stuck" in capsys.readouterr().err
    vb.Thread(context).step()
    assert context.statistics.objects_alive == 0


def test_an_adapter_that_cannot_be_opened(context):
    arm = Arm()
    arm.fail = "open"
    with pytest.raises(OSError, match="no arm") as caught:
        vb.Device(arm, context=context)
    assert isinstance(caught.value.__cause__, vb.DeviceError) and "nobody" in str(caught.value.__cause__)
    with pytest.raises(TypeError, match="no adapter"):
        vb.Device(object(), context=context)
    assert context.statistics.objects_alive == 0


def test_calls_from_inside_a_callback(context):
    seen = []

    class Curious(Arm):
        def read(self, now):
            seen.append(context.statistics.objects_alive)
            with pytest.raises(vb.BusyError):
                vb.Thread(context)
            return {"position": (0, 0, 0), "time": now}

    vb.Device(Curious(), context=context).read(0.001)
    assert seen == [1]


def test_jaws_wait_for_the_handle(context):
    mock = vb.Mock(context)
    device = vb.Device(mock, jaw_takeover=1)
    opening = device.read(0.001).jaw
    device.hold_jaw(1.0 - opening)
    assert device.read(0.002).jaw == pytest.approx(1.0 - opening)


def test_a_mock_replaces_hardware(context):
    mock = vb.Mock(context, measure=lambda t: {"position": (t, 0, 0), "jaw": 1.0}, row_capacity=16,
                   capabilities={"outputs": 7, "signals": 0x1ff, "max_force": 3.0})
    device = vb.Device(mock, output={"max_force": 1.0}, calibration={"scale": 2.0, "axes": (-1, 2, 3)},
                       stop_when_lost=False)
    assert device.read(0.01).position[0] == pytest.approx(-0.02)
    device.write(0.01, force=(0.5, 0, 0))
    device.write(0.011)
    assert mock.rows.shape[1] == 9 and len(mock.rows) >= 2 and mock.statistics.open == 1
    mock.add_fault("disconnect", 0.02, 0.03)
    assert device.read(0.02).status is vb.DeviceStatus.LOST
    mock.clear_faults()
    assert device.read(0.03).status is vb.DeviceStatus.READY
    device.set_clutch(True)
    assert device.read(0.031).clutched == 1
    device.set_clutch(False)
    device.recentre((0.1, 0.0, 0.0), (1, 0, 0, 0))
    assert device.read(0.032).position[0] == pytest.approx(0.1, abs=3e-3)
    device.set_calibration(offset=(0.0, 0.5, 0.0))
    assert device.read(0.033).position[1] == pytest.approx(0.5)
    device.latch_emergency_stop()
    assert vb.OutputFlagBits.STOPPED in device.write(0.034, force=(1, 0, 0)).flags
    device.clear_emergency_stop()
    saved, wanted = device.save(), device.state_hash
    device.read(0.04)
    device.restore(saved)
    assert device.state_hash == wanted and device.output_statistics.stops == 1
    mock.clear_rows()
    assert len(mock.rows) == 0
    with pytest.raises(vb.OutOfRangeError):
        device.read(0.001)
    with pytest.raises(vb.NotFiniteError):
        device.read(math.nan)
    with pytest.raises(vb.OutOfRangeError):
        vb.Device(mock, calibration={"axes": (1, 1, 2)})
    with pytest.raises(TypeError, match="did you mean 'scale'"):
        device.set_calibration(scal=1.0)


def test_a_mock_without_a_function_gives_its_sample(context):
    mock = vb.Mock(context)
    mock.set_sample(time=1.0, position=(0.01, 0.02, 0.03))
    device = vb.Device(mock)
    assert device.read(1.0).position == (0.01, 0.02, 0.03)
    with pytest.raises(vb.IncompatibleError):
        mock.add_fault("late", 0.0, 1.0, 0.1)


def test_what_a_measure_function_raises_reaches_the_caller(context):
    mock = vb.Mock(context, measure=lambda t: 1 / 0)
    device = vb.Device(mock)
    with pytest.raises(ZeroDivisionError):
        device.read(0.001)


def test_an_output_stage_alone(context):
    output = vb.Output(context, max_force=1.0)
    for _ in range(20):
        result = output.step(1e-3, force=(5.0, 0.0, 0.0))
    assert result.force[0] <= 1.0 and output.statistics.steps == 20
    output.latch_emergency_stop()
    assert output.step(1e-3).force == (0.0, 0.0, 0.0)
    output.clear_emergency_stop()
    assert vb.OutputFlagBits.NOT_FINITE in output.step(1e-3, force=(math.nan, 0, 0)).flags
    with pytest.raises(TypeError, match="no setting 'fore'"):
        output.step(1e-3, fore=(0, 0, 0))


def test_hands_on_a_desk():
    sample = vb.map_mouse(None, (100, 0, 0), h=0.01)
    assert sample.position[0] == pytest.approx(0.01) and sample.time == pytest.approx(0.01)
    sample = vb.map_mouse(sample, (0, 0, 0), vb.MappingMouseBits.CLOSE, 0.1)
    pressed = vb.map_keyboard(sample, (0, 1, 0, 0, 0, 0, 0))
    assert pressed.position[1] == pytest.approx(sample.position[1] + 1e-3)
    moved = vb.map_gamepad({"position": (0, 0, 0), "orientation": (1, 0, 0, 0), "jaw": 1.0},
                           (1, 0, 0, 0, 0, 0), 0.25, h=0.1, pad_speed=0.2)
    assert moved.position[0] == pytest.approx(0.02) and moved.jaw == 0.25
    with pytest.raises(ValueError):
        vb.map_mouse(None, (1, 2))
