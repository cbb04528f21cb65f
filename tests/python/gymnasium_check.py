"""Gymnasium's own checker, vector environments and videos, with the real gymnasium. test_gymnasium.py runs it."""
import pathlib
import sys

import gymnasium
import numpy as np
from gymnasium.utils.env_checker import check_env

import vblast_ss.suturing  # noqa: F401  registers both environments

NAMES = ("vblast_ss/Throw-v0", "vblast_ss/Suture-v0")


def check_made() -> None:
    for name in NAMES:
        environment = gymnasium.make(name, time_limit=0.05)
        check_env(environment.unwrapped, skip_render_check=False)
        environment.close()


def check_pictures() -> None:
    for name in NAMES:
        environment = gymnasium.make(name, time_limit=0.05, render_mode="rgb_array")
        environment.reset(seed=1)
        first = environment.render()
        assert first.shape == (360, 480, 3) and first.dtype == np.uint8
        assert len(np.unique(first.reshape(-1, 3), axis=0)) > 20  # shades of several bodies
        assert (environment.render() == first).all()
        environment.step(np.ones(environment.action_space.shape))
        assert (environment.render() != first).any()
        assert environment.metadata["render_fps"] == 100
        environment.close()


def check_vectors() -> None:
    found = []
    for mode, how in (("sync", {}), ("async", {"shared_memory": True, "context": "spawn"})):
        environments = gymnasium.make_vec(NAMES[0], num_envs=2, vectorization_mode=mode, vector_kwargs=how, time_limit=0.05)
        seen = [environments.reset(seed=3)[0]]
        for _ in range(3):
            seen.append(environments.step(np.full(environments.action_space.shape, 0.5))[0])
        found.append(np.array(seen))
        environments.close()
    assert (found[0] == found[1]).all() and (found[0][:, 0] != found[0][:, 1]).any()


def check_video(folder: str) -> None:
    environment = gymnasium.wrappers.RecordVideo(gymnasium.make(NAMES[0], time_limit=0.03, render_mode="rgb_array"), folder)
    environment.reset(seed=1)
    over = False
    while not over:
        _, _, terminated, truncated, _ = environment.step(np.zeros(8))
        over = terminated or truncated
    environment.close()
    videos = list(pathlib.Path(folder).glob("*.mp4"))
    assert len(videos) == 1 and videos[0].stat().st_size > 1000


if __name__ == "__main__":
    check_made()
    check_pictures()
    check_vectors()
    check_video(sys.argv[1])
    print("gymnasium", gymnasium.__version__, "accepts both environments")
