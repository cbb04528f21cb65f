"""Lives of contexts and objects: leaks, logs, forks, threads."""
import concurrent.futures
import gc
import multiprocessing
import os
import pathlib
import subprocess
import sys
import threading

import pytest

import vblast_ss as vb
from vblast_ss._library import HEADER_VERSION, lib
from conftest import BINDING


def resident():
    """Bytes of memory of this process."""
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not pathlib.Path("/proc/self/statm").exists(), reason="no /proc")
def test_nothing_is_lost_when_many_are_made():
    def one(i):
        with vb.Context(log=lambda level, text: None) as context:
            scene = vb.Scene(context, node_capacity=128, contact_capacity=64, candidate_capacity=512)
            scene.add(vb.Thread(context, segment_count=50))
            scene.add(vb.Grasper(context))
            mock = vb.Mock(context, measure=lambda t: {"position": (t, 0, 0)})
            device = vb.Device(mock)
            device.read(0.001)
            scene.step()
            kept = scene.thread(1).positions
            with pytest.raises(vb.OutOfRangeError):
                vb.Thread(context, length=-1.0)
            scene.save()
        return kept

    for i in range(30):
        one(i)
    gc.collect()
    before = resident()
    for i in range(300):
        one(i)
    gc.collect()
    assert resident() - before < 8e6  # one context of these takes more than 3 MB


def test_objects_that_are_dropped_are_destroyed(context):
    for _ in range(50):
        vb.Thread(context, segment_count=10)
        vb.KnotDetector(context, point_capacity=32)
        vb.Output(context)
        scene = vb.Scene(context, node_capacity=64)
        scene.add(vb.Thread(context, segment_count=10))
        del scene
    assert context.statistics.objects_alive == 0


def test_an_object_that_is_dropped_inside_a_callback_goes_after_it(context):
    thread = [vb.Thread(context, segment_count=10)]

    def measure(time):
        thread.clear()
        return {"position": (time, 0, 0)}

    device = vb.Device(vb.Mock(context, measure=measure))
    device.read(0.001)
    device.read(0.002)
    assert context.statistics.objects_alive == 2  # device and mock


def test_dropping_waits_for_no_thread(context):
    """While another thread is inside the context; the object goes with a later call."""
    inside, go_on = threading.Event(), threading.Event()

    def measure(time):
        inside.set()
        go_on.wait(60)
        return {"position": (time, 0, 0)}

    thread = vb.Thread(context, segment_count=10)
    device = vb.Device(vb.Mock(context, measure=measure))
    worker = threading.Thread(target=device.read, args=(0.001,))
    worker.start()
    assert inside.wait(60)
    del thread
    go_on.set()
    worker.join()
    device.statistics
    assert context.statistics.objects_alive == 2


def test_closing_a_context_closes_what_is_in_it():
    context = vb.Context()
    thread = vb.Thread(context)
    assert "1 objects" in repr(context)
    context.close()
    context.close()
    assert thread.closed and repr(context) == "<Context, closed>"
    for use in (thread.step, lambda: thread.positions, lambda: context.statistics, thread.save):
        with pytest.raises(vb.InvalidHandleError, match="closed"):
            use()
    thread.close()


def test_the_log_is_heard():
    heard = []
    with vb.Context(log=lambda level, text: heard.append((level, text)), log_level="info") as context:
        with pytest.raises(vb.OutOfRangeError):
            vb.Thread(context, length=-1.0)
        thread = vb.Thread(context)
        thread.save()
        scene = vb.Scene(context)
        assert scene.holes == []
    errors = [text for level, text in heard if level is vb.LogLevel.ERROR]
    assert len(errors) == 1 and "length" in errors[0]


def test_what_a_log_function_raises_reaches_the_caller():
    def shout(level, text):
        raise LookupError(text)
    with vb.Context(log=shout, log_level="error") as context:
        with pytest.raises(LookupError) as caught:
            vb.Thread(context, length=-1.0)
        assert isinstance(caught.value.__cause__, vb.OutOfRangeError)
        vb.Thread(context).step()


def run_scene(seed):
    """A thread that falls on a floor; the hash after each step."""
    with vb.Context() as context:
        scene = vb.Scene(context, floor=True, mode="offline", node_capacity=128)
        thread = vb.Thread(context, segment_count=40, start=(0, 5e-4, 0), direction=(1.0, 0.0, 0.1 * seed))
        scene.add(thread)
        hashes = []
        for _ in range(60):
            scene.step()
            hashes.append(scene.state_hash)
        return hashes


def test_contexts_in_threads_give_the_same_for_one_worker_and_two():
    wanted = [run_scene(seed) for seed in range(4)]
    for workers in (1, 2):
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            assert list(pool.map(run_scene, range(4))) == wanted
    assert len({hashes[-1] for hashes in wanted}) == 4


def test_contexts_do_not_wait_for_each_other(context):
    inside, go_on = threading.Event(), threading.Event()

    def measure(time):
        inside.set()
        go_on.wait(60)
        return {"position": (time, 0, 0)}

    device = vb.Device(vb.Mock(context, measure=measure))
    worker = threading.Thread(target=device.read, args=(0.001,))
    worker.start()
    assert inside.wait(60)
    with vb.Context() as other:
        vb.Thread(other, segment_count=10).step()
        assert worker.is_alive()
    go_on.set()
    worker.join()


def test_threads_that_share_a_context_wait_for_each_other(context):
    thread = vb.Thread(context, segment_count=200)
    failures = []

    def work():
        try:
            for _ in range(50):
                thread.step()
                assert len(thread.positions) == 201
        except Exception as error:
            failures.append(error)

    workers = [threading.Thread(target=work) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert failures == [] and thread.statistics.steps == 200


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_context_goes_on_in_a_forked_child(context):
    thread = vb.Thread(context, segment_count=20)
    thread.step()
    kept = thread.positions
    pipe, into = multiprocessing.get_context("fork").Pipe()

    def child():
        for _ in range(10):
            thread.step()
        into.send((thread.state_hash, float(kept[0][1]) <= 0.0))
        thread.close()
        context.close()
        into.send("closed")

    process = multiprocessing.get_context("fork").Process(target=child)
    process.start()
    assert pipe.poll(60)
    found, fine = pipe.recv()
    assert pipe.poll(60) and pipe.recv() == "closed"
    process.join()
    for _ in range(10):
        thread.step()
    assert process.exitcode == 0 and fine and thread.state_hash == found


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_context_that_was_forked_inside_a_call_refuses_in_the_child(context):
    inside, go_on = threading.Event(), threading.Event()

    def measure(time):
        inside.set()
        go_on.wait(60)
        return {"position": (time, 0, 0)}

    device = vb.Device(vb.Mock(context, measure=measure))
    worker = threading.Thread(target=device.read, args=(0.001,))
    worker.start()
    assert inside.wait(60)
    child = os.fork()
    if child == 0:  # no pytest here
        try:
            context.statistics
        except vb.InvalidHandleError as error:
            os._exit(3 if "forked" in str(error) and "fork" in repr(context) else 4)
        finally:
            os._exit(5)
    go_on.set()
    worker.join()
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 3
    assert device.statistics.reads == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_forked_child_leaves_devices_alone():
    script = ("import os, sys, vblast_ss as vb\n"
              "class Arm:\n"
              "    def read(self, now): return {'position': (0, 0, 0), 'time': now}\n"
              "    def close(self): print('closed by', 'parent' if os.getpid() == parent else 'child', flush=True)\n"
              "parent = os.getpid()\n"
              "device = vb.Device(Arm())\n"
              "child = os.fork()\n"
              "if child:\n"
              "    os.waitpid(child, 0)\n"
              "else:\n"
              "    del device\n")
    done = subprocess.run([sys.executable, "-B", "-c", script], env={**os.environ, "PYTHONPATH": str(BINDING)},
                          capture_output=True, text=True, timeout=60)
    assert done.stderr == "" and done.stdout == "closed by parent\n"


def test_an_interpreter_that_ends_closes_adapters_first():
    script = ("import vblast_ss as vb\n"
              "class Arm:\n"
              "    def read(self, now): return {'position': (0, 0, 0), 'time': now}\n"
              "    def write(self, now, output): print('force', output.force[0])\n"
              "    def close(self): print('closed')\n"
              "device = vb.Device(Arm())\n"
              "device.read(0.001)\n")
    done = subprocess.run([sys.executable, "-B", "-c", script], env={**os.environ, "PYTHONPATH": str(BINDING)},
                          capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and done.stderr == ""
    assert done.stdout.splitlines()[-2:] == ["force 0.0", "closed"]


def test_the_library_and_its_headers_have_one_version():
    number = lib.vbss_version()
    assert number == HEADER_VERSION
    assert vb.version().startswith(f"{number // 10000}.{number // 100 % 100}.{number % 100}")
