"""Virtual environments of the peers, made from versions.txt under build/peers."""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PLACE = HERE.parents[1] / "build/peers"
INSTALL_LIMIT = 240.0  # s


def listed():
    """(peer, [package==version, ...]) of each peer."""
    lines = (HERE / "versions.txt").read_text(encoding="utf-8").splitlines()
    words = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return [(peer, packages) for peer, *packages in words]


def python_of(peer, packages):
    """The interpreter of the peer's environment, and why there is none."""
    place = PLACE / peer
    python, mark = place / "bin/python", place / "installed.txt"
    wanted = " ".join(packages)
    if python.exists() and mark.exists() and mark.read_text(encoding="utf-8") == wanted:
        return python, ""
    try:
        subprocess.run([sys.executable, "-m", "venv", "--clear", str(place)], check=True, capture_output=True, text=True)
        subprocess.run([str(python), "-m", "pip", "install", "-q", "--disable-pip-version-check", "--retries", "1",
                        "--timeout", "15", *packages], check=True, capture_output=True, text=True, timeout=INSTALL_LIMIT)
    except subprocess.TimeoutExpired:
        return None, f"no installation within {INSTALL_LIMIT:g} s"
    except (OSError, subprocess.CalledProcessError) as error:
        text = (getattr(error, "stderr", "") or str(error)).strip().splitlines()
        return None, "not installed: " + plain(text[-1] if text else "no reason given")
    mark.write_text(wanted, encoding="utf-8")
    return python, ""


def plain(text):
    """Without addresses, and short."""
    return " ".join(word for word in text.split() if "://" not in word)[:120]
