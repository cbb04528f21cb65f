"""Learns the scripted hands' throw from their episodes by behaviour cloning, with numpy alone.

    python3 bindings/python/examples/clone_throw.py [--demonstrations 20] [--corrections 18] [--episodes 15] [--work FOLDER]

A small network learns the action that the scripted hands take for an observation. It sees one observation and remembers nothing, while the
hands keep a phase. After the demonstrations it may drive episodes itself in which the hands only say what they would do
(dataset aggregation, Ross et al. 2011): --corrections of them, in three rounds. Clones before and after these rounds are judged on
episodes whose seeds no training has used, beside the scripted hands and random ones.

--work keeps episodes as they come, so a run that was stopped is continued.

With the numbers above, no clone has tied a throw (docs/guides/learning-environments.md)."""
import argparse
import pathlib
import sys
import time

import numpy as np

from vblast_ss.environment import FIELDS, GRIP, RandomHands, ScriptedThrow, ThrowEnvironment, run

HELD_OUT = 1_000_000
"""From this seed on, episodes are for judging."""
ROUNDS = 3
HIDDEN = (128, 128)


def features(seen):
    """What the network sees, from one observation or rows of them."""
    seen = np.atleast_2d(seen)
    part = {name: seen[:, place] if isinstance(place, slice) else seen[:, place, None] for name, place in FIELDS.items()}
    line = part["thread"][:, :30]  # the tail
    w, c, tail, angle = part["w"], part["c"], part["tail"], part["angle"]
    return np.hstack((part["time"], w, c, w - tail, c - w, angle, np.sin(angle), np.cos(angle), part["holds"],
                      np.minimum(part["pull_w"], 0.3), np.minimum(part["pull_c"], 0.3), part["free"], part["on_w"] > 0, part["on_w"],
                      line))


class Network:
    """Layers with tanh between them, trained by Adam on squared errors."""

    def __init__(self, inputs, outputs, seed=0):
        self.random = np.random.default_rng(seed)
        sizes = (inputs, *HIDDEN, outputs)
        self.weights = [self.random.normal(0.0, 1.0 / np.sqrt(a), (a, b)) for a, b in zip(sizes, sizes[1:])]
        self.biases = [np.zeros(b) for b in sizes[1:]]
        self.mean, self.scale = np.zeros(inputs), np.ones(inputs)

    def forward(self, x):
        layers = [x]
        for number, (weight, bias) in enumerate(zip(self.weights, self.biases)):
            x = x @ weight + bias
            if number < len(self.weights) - 1:
                x = np.tanh(x)
            layers.append(x)
        return layers

    def __call__(self, seen):
        action = np.clip(self.forward((features(seen) - self.mean) / self.scale)[-1][0], -1.0, 1.0)
        action[GRIP] = 1.0 if action[GRIP] > 0.0 else -1.0
        return action

    def fit(self, seen, actions, epochs=60, batch=256, rate=1e-3):
        inputs = features(seen)
        self.mean, self.scale = inputs.mean(axis=0), inputs.std(axis=0) + 1e-9
        inputs = (inputs - self.mean) / self.scale
        parameters = self.weights + self.biases
        first, second, count = [np.zeros_like(p) for p in parameters], [np.zeros_like(p) for p in parameters], 0
        for epoch in range(epochs):
            order, loss = self.random.permutation(len(inputs)), 0.0
            now = rate * 0.5 * (1.0 + np.cos(np.pi * epoch / epochs))
            for begin in range(0, len(order), batch):
                chosen = order[begin:begin + batch]
                layers = self.forward(inputs[chosen])
                error = layers[-1] - actions[chosen]
                loss += float((error ** 2).sum())
                error = 2.0 * error / len(chosen)
                weights, biases = [], []
                for number in reversed(range(len(self.weights))):
                    weights.insert(0, layers[number].T @ error)
                    biases.insert(0, error.sum(axis=0))
                    error = (error @ self.weights[number].T) * (1.0 - layers[number] ** 2)
                count += 1
                for parameter, gradient, m, v in zip(parameters, weights + biases, first, second):
                    m += 0.1 * (gradient - m)
                    v += 0.001 * (gradient ** 2 - v)
                    parameter -= now * (m / (1.0 - 0.9 ** count)) / (np.sqrt(v / (1.0 - 0.999 ** count)) + 1e-8)
        return loss / len(inputs)


def episode(seed, driver=None):
    """Observations of an episode and what the scripted hands do about each; `driver`: who acts, if not they."""
    hands, seen, wanted = ScriptedThrow(), [], []
    with ThrowEnvironment() as environment:
        observation, info = environment.reset(seed=seed)
        over = False
        while not over:
            seen.append(observation)
            wanted.append(hands(observation))
            observation, _, terminated, truncated, info = environment.step(wanted[-1] if driver is None else driver(observation))
            over = terminated or truncated
    return np.array(seen), np.array(wanted), info["tied"]


def kept(path, make):
    """An episode out of a file, which is made if it is not there."""
    if not path.exists():
        seen, wanted, tied = make()
        np.savez(path, seen=seen, wanted=wanted, tied=tied)
    stored = np.load(path)
    return stored["seen"], stored["wanted"], bool(stored["tied"])


def judge(name, make_policy, episodes):
    begun = time.monotonic()
    with ThrowEnvironment() as environment:
        outcomes = [run(environment, make_policy(number), seed=HELD_OUT + number) for number in range(episodes)]
    returns = np.array([outcome.total_reward for outcome in outcomes])
    print(f"{name:28} tied {sum(outcome.tied for outcome in outcomes):3} of {episodes}   return {returns.mean():7.2f} +- "
          f"{returns.std(ddof=1) / np.sqrt(episodes):.2f}   {sum(outcome.error != '' for outcome in outcomes)} failed simulations   "
          f"({time.monotonic() - begun:.0f} s)", flush=True)


def train(episodes, seed=0):
    begun = time.monotonic()
    seen, wanted = (np.concatenate([one[part] for one in episodes]) for part in (0, 1))
    network = Network(features(seen[0]).shape[1], 8, seed)
    loss = network.fit(seen, wanted)
    print(f"trained on {len(episodes)} episodes, {len(seen)} actions, in {time.monotonic() - begun:.0f} s; squared error {loss:.4f}", flush=True)
    return network


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--demonstrations", type=int, default=20)
    parser.add_argument("--corrections", type=int, default=18)
    parser.add_argument("--episodes", type=int, default=15)
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("clone"))
    chosen = parser.parse_args()
    chosen.work.mkdir(parents=True, exist_ok=True)
    episodes = [kept(chosen.work / f"hands-{seed}.npz", lambda: episode(seed)) for seed in range(chosen.demonstrations)]
    print(f"the scripted hands have tied {sum(tied for *_, tied in episodes)} of {len(episodes)} demonstrations", flush=True)
    clones = {"clone": train([one for one in episodes if one[2]])}
    network, seed = clones["clone"], chosen.demonstrations
    for number in range(ROUNDS if chosen.corrections else 0):
        for seed in range(seed, seed + chosen.corrections // ROUNDS):
            episodes.append(kept(chosen.work / f"corrected-{seed}.npz", lambda: episode(seed, network)))
        seed += 1
        tied = sum(one[2] for one in episodes[-(chosen.corrections // ROUNDS):])
        print(f"round {number + 1}: the clone has tied {tied} of {chosen.corrections // ROUNDS}", flush=True)
        network = clones["clone, corrected"] = train(episodes)
    judge("scripted hands", lambda number: ScriptedThrow(), chosen.episodes)
    for name, clone in clones.items():
        judge(name, lambda number: clone, chosen.episodes)
    judge("random hands", RandomHands, chosen.episodes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
