"""Films a throw of the scripted hands, or a grasp by a policy that learn_grasp.py has learned, as an MP4.

    python3 -m pip install gymnasium moviepy      # and stable-baselines3 for --grasp
    python3 bindings/python/examples/film_throw.py FOLDER [--seed 0] [--grasp grasp-0.zip]

The pictures are drawn by numpy, one for each action: 100 a simulated second for a throw, 50 for a grasp. Seeds from 1000000 on are
those that no training has used."""
import argparse
import pathlib
import sys

try:
    import gymnasium
    import moviepy  # noqa: F401  RecordVideo writes with it
except ImportError as missing:
    sys.exit(f"{missing}. This example needs: python3 -m pip install gymnasium moviepy")

from vblast_ss.environment import ScriptedThrow


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--grasp", type=pathlib.Path, metavar="POLICY")
    chosen = parser.parse_args()
    if chosen.grasp:
        import stable_baselines3
        from learn_grasp import GraspTail
        model = stable_baselines3.PPO.load(chosen.grasp, device="cpu")
        name, aim, environment = "learned-grasp", "held", GraspTail(render_mode="rgb_array")

        def policy(shown):
            return model.predict(shown, deterministic=True)[0]
    else:
        name, aim, policy = "scripted-throw", "tied", ScriptedThrow()
        environment = gymnasium.make("vblast_ss/Throw-v0", render_mode="rgb_array")
    environment = gymnasium.wrappers.RecordVideo(environment, str(chosen.folder), name_prefix=f"{name}-{chosen.seed}", disable_logger=True)
    shown, info = environment.reset(seed=chosen.seed)
    over = False
    while not over:
        shown, _, terminated, truncated, info = environment.step(policy(shown))
        over = terminated or truncated
    environment.close()
    print(f"{name}, seed {chosen.seed}: {aim if info[aim] else 'not ' + aim} after {info['time']:.2f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
