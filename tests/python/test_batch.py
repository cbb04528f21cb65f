"""Batches: the same numbers for any number of workers, and errors of one scene are its own."""
import math
import threading

import pytest

import vblast_ss as vb
from vblast_ss.batch import Batch


def scene_of(bending):
    if bending is None:
        raise KeyError("no such scene")
    scene = vb.Scene(vb.Context(), floor=True, floor_height=-0.02)
    thread = vb.Thread(scene.context, segment_count=30, bending_stiffness=bending)
    thread.attach("pin", 0)
    scene.add(thread)
    return scene


ITEMS = [1e-8 * (1 + i) for i in range(5)]


def hashes(workers):
    with Batch(scene_of, ITEMS, workers=workers) as batch:
        batch.step(1e-3, 60)
        return batch.map(lambda scene: scene.state_hash)


def test_the_number_of_workers_changes_nothing():
    alone = []
    for bending in ITEMS:
        scene = scene_of(bending)
        for _ in range(60):
            scene.step(1e-3)
        alone.append(scene.state_hash)
    assert len(set(alone)) == len(ITEMS)
    for workers in (1, 2, 3, 8):
        assert hashes(workers) == alone


def test_work_is_done_by_several_threads_in_contexts_of_their_own():
    seen = set()
    meet = threading.Barrier(2)

    def work(scene):
        meet.wait(60)  # nobody gets on unless two are at work
        seen.add(threading.get_ident())
        return scene.context

    with Batch(scene_of, ITEMS[:2], workers=2) as batch:
        assert len(set(map(id, batch.map(work)))) == 2
    assert len(seen) == 2


def test_an_error_of_one_scene_is_data():
    with Batch(scene_of, [1e-8, None, 3e-8], workers=2) as batch:
        assert isinstance(batch.errors[1], KeyError) and batch.scenes[1] is None
        batch.step(1e-3, 5)

        def spoil(scene, number):
            if scene is batch.scenes[2] and number == 3:
                scene.step(math.nan)

        batch.step(1e-3, 5, before=spoil)
        assert isinstance(batch.errors[2], vb.errors.Error) and batch.errors[0] is None
        batch.step(1e-3, 5)
        assert [cost.steps for cost in batch.costs] == [15, 0, 8]
        assert batch.costs[0].seconds > 0.0
        assert batch.map(lambda scene: scene.statistics.steps) == [15, None, None]
        assert "2 ended by an error" in repr(batch)
    with pytest.raises(ValueError):
        Batch(scene_of, ITEMS, workers=0)


def test_what_is_no_error_of_a_scene_gets_out():
    def interrupt(scene):
        raise KeyboardInterrupt

    with Batch(scene_of, ITEMS[:2], workers=2) as batch, pytest.raises(KeyboardInterrupt):
        batch.map(interrupt)


def test_closing_closes_the_contexts():
    with Batch(scene_of, ITEMS[:2]) as batch:
        contexts = batch.map(lambda scene: scene.context)
        assert len(batch) == 2
    assert all(context.closed for context in contexts)
