"""Learns to grasp the thread's tail by PPO, the first part of a throw.

    python3 -m pip install gymnasium stable-baselines3      # with torch; its build for processors alone is enough
    python3 bindings/python/examples/learn_grasp.py [--seeds 0 1 2] [--steps 4000] [--episodes 30] [--keep FOLDER]

The tool W begins beside a tail that swings. An action is W's velocity for 20 ms; its jaws are always closing, so they hold the tail
once it is within reach. An episode lasts at most a second. The reward is a point for each 5 mm that W comes nearer to the tail, 10 for
the grasp, and -0.02 for each action.

For each seed a policy is trained and then judged, without its random part, on episodes whose seeds no training has used. Random actions, no
motion, and hands that go straight to the tail are judged on the same ones. The exit status is 0 if each return is above those of random
actions and of no motion by three standard errors. --keep stores the policies."""
import argparse
import math
import pathlib
import sys
import time

import numpy as np

try:
    import gymnasium
    import stable_baselines3
except ImportError as missing:
    sys.exit(f"{missing}. This example needs: python3 -m pip install gymnasium stable-baselines3")

from vblast_ss.environment import FIELDS, GRIP, W, ThrowEnvironment

HELD_OUT = 1_000_000
"""From this seed on, episodes are for judging."""
SCATTER = 4e-3  # of where W begins, m


class GraspTail(gymnasium.Env):
    """Take the tail. Observations: from W to the tail, cm; the tail's velocity, dm/s; the tail's direction away from its end; the
    share of the time that has passed."""
    metadata = ThrowEnvironment.metadata

    def __init__(self, render_mode=None):
        self.throw = ThrowEnvironment(time_limit=1.0, control=20, render_mode=render_mode)
        self.metadata, self.render_mode = self.throw.metadata, render_mode
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (3,), np.float32)
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (10,), np.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        seen, info = self.throw.reset(seed=int(self.np_random.integers(HELD_OUT)) if seed is None or seed < HELD_OUT else seed,
                                      options={"scatter": SCATTER, **(options or {})})
        self._tail = seen[FIELDS["tail"]]
        self._distance = self._away(seen)
        return self._shown(seen), info

    def step(self, action):
        wanted = np.zeros(8)
        wanted[W], wanted[GRIP] = action, 1.0
        seen, _, failed, truncated, info = self.throw.step(wanted)
        shown, held, distance = self._shown(seen), bool(seen[FIELDS["holds"]]), self._away(seen)
        reward = (self._distance - distance) / 5e-3 + 10.0 * held - 0.02
        self._distance = distance
        return shown, reward, held or failed, truncated and not held, {**info, "held": held}

    @staticmethod
    def _away(seen):
        return math.dist(seen[FIELDS["w"]], seen[FIELDS["tail"]])

    def _shown(self, seen):
        tail, line = seen[FIELDS["tail"]], seen[FIELDS["thread"]].reshape(-1, 3)
        velocity, self._tail = (tail - self._tail) / 0.02, tail
        along = line[1] - line[0]
        return np.concatenate(((tail - seen[FIELDS["w"]]) / 1e-2, velocity / 0.1, along / np.linalg.norm(along),
                               (seen[FIELDS["time"]],))).astype(np.float32)

    def render(self):
        return self.throw.render()

    def close(self):
        self.throw.close()


def straight(shown):
    """To the tail, at 40 mm/s: what the scripted hands do in this part, without their care."""
    way = shown[:3] * 1e-2
    distance = np.linalg.norm(way)
    return 0.2 * way / distance if distance > 0.0 else 0.0 * way


def judge(environment, policy, episodes):
    """Returns of the held-out episodes, and how many of them ended with a grasp."""
    returns, held = [], 0
    for number in range(episodes):
        shown, _ = environment.reset(seed=HELD_OUT + number)
        total, over = 0.0, False
        while not over:
            shown, reward, terminated, truncated, info = environment.step(policy(shown))
            total, over = total + reward, terminated or truncated
        returns.append(total)
        held += info["held"]
    return np.array(returns), held


def train(seed, steps):
    environment = GraspTail()
    model = stable_baselines3.PPO("MlpPolicy", environment, n_steps=256, batch_size=64, gamma=0.98, learning_rate=1e-3, seed=seed,
                                  policy_kwargs={"log_std_init": -1.0}, device="cpu")
    model.learn(steps)
    environment.close()
    return model


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2])
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--episodes", type=int, default=30)
    parser.add_argument("--keep", type=pathlib.Path)
    chosen = parser.parse_args()
    environment = GraspTail()
    random = np.random.default_rng(0)
    print("policy            return, mean +- standard error   grasps        training")

    def row(name, found, wall=""):
        returns, held = found
        error = returns.std(ddof=1) / math.sqrt(len(returns))
        print(f"{name:17} {returns.mean():8.3f} +- {error:.3f}                {held:4} of {len(returns):4}  {wall}", flush=True)
        return returns.mean(), error

    lower = {"random actions": row("random", judge(environment, lambda shown: random.uniform(-1.0, 1.0, 3), chosen.episodes)),
             "no motion": row("no motion", judge(environment, lambda shown: np.zeros(3), chosen.episodes))}
    row("straight", judge(environment, straight, chosen.episodes))
    good = True
    for seed in chosen.seeds:
        begun = time.monotonic()
        model = train(seed, chosen.steps)
        wall = f"{chosen.steps} steps in {time.monotonic() - begun:.0f} s"
        mean, error = row(f"PPO, seed {seed}", judge(environment, lambda shown: model.predict(shown, deterministic=True)[0],
                                                     chosen.episodes), wall)
        for name, (other, other_error) in lower.items():
            above = (mean - other) / math.hypot(error, other_error)
            print(f"    {above:.1f} standard errors above {name}", flush=True)
            good = good and above >= 3.0
        if chosen.keep:
            model.save(chosen.keep / f"grasp-{seed}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
