"""Takes C sources apart into code and comments, without a parser."""
import bisect
import functools
import re
from typing import NamedTuple

TOKEN = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'", re.S)
DECORATION = re.compile(r"^[ \t]*(?:/\*+<?|//+<?|\*+(?!/))|\*+/$", re.M)
IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
SOURCES = (".c", ".h", ".cpp", ".hpp")


class Comment(NamedTuple):
    line: int  # of its first character, from 1
    last: int  # of its last character
    text: str  # without the marks of a comment; its line breaks are kept


@functools.lru_cache(maxsize=None)
def read(path):
    return path.read_text(errors="replace")


def code(text):
    """The text with comments, strings and characters blanked; every line keeps its number."""
    return TOKEN.sub(lambda token: re.sub(r"[^\n]", " ", token.group()), text)


def comments(text):
    found, lines = [], Lines(text)
    for token in TOKEN.finditer(text):
        if token.group()[0] == "/":
            first = lines.number(token.start())
            found.append(Comment(first, first + token.group().count("\n"), DECORATION.sub(" ", token.group())))
    return found


class Lines:
    """Line numbers of positions in a text."""
    def __init__(self, text):
        self.starts = [0] + [match.end() for match in re.finditer("\n", text)]

    def number(self, position):
        return bisect.bisect_right(self.starts, position)


def sources(folder, suffixes=SOURCES):
    return sorted(path for path in folder.rglob("*") if path.suffix in suffixes and path.is_file())


def words(name):
    """The words of an identifier or a file name, in lower case: parts between underscores, hyphens and dots."""
    return re.split(r"[_\-.]+", name.lower())
