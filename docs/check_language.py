"""Counts patterns of English that is not idiomatic, per 1000 words.

    check_language.py [--limit N] [--file-limit N] [--list] [FILE ...]
    check_language.py --self-test

Without files it reads README.md, CONTRIBUTING.md, all pages below docs/ but those of the notebook, and the comments of the public
headers. It prints a row for each file (words, patterns, patterns per 1000 words, and the kinds) and one for all. --list prints
each match with its line. The exit status is 1 if the mean of all files is above --limit, or one file of more than 300 words
above --file-limit.

The count is crude on purpose: it finds habits, it does not judge a sentence. Code, formulas and link targets are not read.
"""
import argparse
import collections
import pathlib
import re
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
MAX_SENTENCE = 40  # words
SHORT_FILE = 300   # words; one pattern would be more than 3 per 1000 there

BE = r"(?:is|are|was|were|has|have|had|does|do|did|can|could|would|will|may|might|must|should|cannot)"
FINITE = (BE + r"|it|they|we|he|one|nobody|this|that|the|a|an|no|remains?|comes?|goes|came|went|lies|lay|touches|moves|hits|begins?|"
          r"takes?|makes?|holds?|misses|follows|happens|happened|leads?|costs?|hangs|flies|falls|counts?|stays?|needs?|wants?|"
          r"gives?|reaches|depends|says?|says|passes|contact|contacts|hands?|threads?|tools?")
# An indirect question is plain English after these words: "shows what a scene costs".
ASKING = (r"(?:shows?|showing|describes?|explains?|says?|decides?|defines?|determines?|states?|check|checks|sees?|knows?|know|find|"
          r"finds|about|exactly|just|or|and|lists?|measures?|limits?|learn|understand|ask|asks|choose|chooses|wonder|matter|out)")

PATTERNS = {
    # "what is held", "of what the law says", "What misses the law": the field has a noun for it.
    "free relative": [
        rf"(?<!\w)(?<![?])What (?:{FINITE})\b(?=[^.?!]*[.!:])",
        rf"\b(?!{ASKING}\b)[a-z]+,? what (?:{FINITE})\b",
        r"[,;:(] ?what (?:is|are|was|were|has|had|it|they|a|the)\b",
        r"(?:^|[.;:,(] )[Ww]ho (?!is |are |was |were )[a-z]+s\b(?=[^?]*?[.!;])",
        r"\bthat which\b",
    ],
    # "is told" for reported, "tells" of a function or a number
    "told": [r"\btold\b", r"\b(?:tells?|telling) (?:of|that|which|what|whether|how|where|it|them|so|nothing|the|a|for|their|its)\b"],
    # a sentence whose subject is in another one
    "the same": [r"\bthe same (?:of|but|for what|with what|is so|goes|holds of)\b", r"[:;] the same[.,;]", r"(?:^|[.] )The same[,:.]",
                 r"(?:^|[.] )The same (?:again|of|with|for|by|after)\b", r"\bso (?:is|are|do|does|did|was|were) (?:the|that|it|they)\b(?=[^?]*[.])",
                 r"\b(?:all|everything|nothing) else (?:of|about) it\b"],
    "archaic": [r"\b[Ll]est\b", r"\b[Aa]new\b", r"\b[Aa]slant\b", r"\b(?:the|each|a|its|their) begin\b", r"\bhitherto\b", r"\bthereof\b",
                r"\bwhereof\b", r"\bas ever\b", r"\bby turns\b", r"\btheir fill\b",
                r"\b(?:but|[Bb]ut) for\b", r"\bbeyond hope\b", r"\ba hair\b"],
    # German verbs: "stands in" for is in, "goes on with" for continues, "comes to" for results in
    "german verb": [r"\bgo(?:es|ne)? on (?:with|to|at|as|from|not)\b", r"\b(?:comes?|came) (?:of it|to what|to rest by)\b",
                    r"\b(?:stands?|stood) (?:in|beside|under|below|there|here|at|where|still on|with)\b", r"\bcame of (?:it|this)\b",
                    r"\b(?:is|are|was|were|be) (?:gone|come|become)\b", r"\b(?:is|are|was|were) (?:let|left) (?:be|off)\b", r"\bgo(?:es)? by\b",
                    r"\btakes? along\b", r"\bmade good\b", r"\blook(?:s|ed)? at\b", r"\b(?:is|are) to be had\b", r"\bwhat is the more\b",
                    r"\bby so (?:much|many)\b", r"\bso many times\b", r"\b(?:draws?|drew) shut\b", r"\b(?:gets?|got) on\b"],
    # personified physics
    "personified": [r"\b[Nn]obody\b", r"\b[Ss]omebody\b", r"\b[Ww]hoever\b", r"\b(?:is|are|be|been|was|were) asked\b", r"\bknows? (?:of|no|nothing)\b",
                    r"\bbeliev(?:es?|ed|ing)\b", r"\bgains? by it\b", r"\blikes to\b", r"\bwishes\b", r"\bof its own accord\b",
                    r"\b(?:force|wall|thread|node|contact|row|body|needle|hole|friction|drain|guard|law)s? (?:knows?|wants?|thinks?|asks?|says?)\b"],
    # words of the glossary's retired list that are no ordinary words of a text
    "retired": [],
}
ORDINARY = {"doubles", "look", "way", "stand", "arrive", "pace", "most", "least", "settle", "aim", "calm", "spot", "recall", "news", "spent",
            "tell", "told", "nobody", "whoever"}  # ordinary words, or counted above

VERBS = set("""is are was were be been am has have had does do did can could will would shall should may might must cannot
let lets see use read run set add call take make give keep pass choose compare note begin become becomes put cut say show shows
go get hold build copy write create step start end ends create divide lower raise turn prefer avoid remove replace begin stay open
came went took made gave held lay fell rose ran saw stood kept left found lost met sent spent told felt drew grew knew
need want expect allow depend differ remain come move follow lie cost reach agree fail change bring count touch rest bear apply
contain include describe compute form store return point belong appear exist grow vary act work measure lead carry help define
compile draw list report store replace load reset print
select install type open close press pull push check try repeat leave wait link enable disable consist correspond equal""".split())


def patterns():
    glossary = next(SOURCE.glob("docs/**/glossary.md"), None)
    words = []
    if glossary:
        table = glossary.read_text().split("## Retired words")[-1]
        for row in re.findall(r"^\| ([a-z, ]+) \|", table, re.MULTILINE):
            words += [word.strip() for word in row.split(",")]
    retired = [rf"\b{word}\b" for word in words if word not in ORDINARY | {"retired"}]
    return {kind: [re.compile(p, re.MULTILINE) for p in (retired if kind == "retired" else list_)] for kind, list_ in PATTERNS.items()}


def blank(match):
    return "\n" * match.group(0).count("\n")


def prose_of_markdown(text):
    """Paragraphs as (line, text, is_sentence): code is one word, links are their text; table cells and headings are no sentences."""
    text = re.sub(r"\A---\n.*?\n---\n", blank, text, flags=re.DOTALL)
    text = re.sub(r"^ *(```|~~~).*?^ *\1", blank, text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"<!--.*?-->", blank, text, flags=re.DOTALL)
    text = re.sub(r"!\[([^\]]*)\]\([^)]*\)", r"", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`\n]*`", "X", text)
    text = re.sub(r"\$\$.*?\$\$", blank, text, flags=re.DOTALL)
    text = re.sub(r"\$[^$\n]+\$", "X", text)
    paragraphs, current, start = [], [], 0

    def flush():
        if current:
            paragraphs.append((start, " ".join(current), True))
            current.clear()

    for number, line in enumerate(text.split("\n"), 1):
        bare = line.strip()
        if not bare or line.startswith("    "):
            flush()
            continue
        if bare.startswith(("#", "|", ">", ":::")):
            flush()
            if not re.fullmatch(r"[|:\- ]+", bare):
                for cell in bare.lstrip("#> ").split("|"):
                    if cell.strip():
                        paragraphs.append((number, cell.strip(), False))
            continue
        item = re.match(r"(?:[-*+]|\d+\.) +", bare)
        if item:
            flush()
            bare = bare[item.end():]
        if not current:
            start = number
        current.append(bare)
    flush()
    return paragraphs


def prose_of_comments(text):
    """The comments of a header, one paragraph each; members may be described by a noun, so these are no sentences to be judged."""
    paragraphs = []
    for match in re.finditer(r"/\*.*?\*/|//[^\n]*", text, re.DOTALL):
        body = re.sub(r"^[ /*!<]+|\*/$|^ *\* ?", "", match.group(0), flags=re.MULTILINE)
        body = re.sub(r"`[^`\n]*`|\b\w+_\w+(?:\(\))?", "X", body)
        line = text.count("\n", 0, match.start()) + 1
        for paragraph in re.split(r"\n[ *]*\n|\n[ *]*(?=- )|;|(?=[@\\]param|[@\\]return)", body):
            judged = False if re.match(r"[@\\]return", paragraph) else None  # a list of results
            paragraph = re.sub(r"[@\\](?:param(?:\[\w+\])? +\w+|\w+)", "", paragraph)
            paragraphs.append((line, " ".join(paragraph.split()), judged))
    return paragraphs


def sentences(text):
    text = re.sub(r"^\*\*[^*]+[.:]\*\*[.:]? ", "", text)  # a label
    text = re.sub(r"\b(e\.g|i\.e|cf|vs|etc|al|Fig|Sect|no|approx)\.", lambda m: m.group(0)[:-1], text)
    return [s for s in re.split(r"(?<=[.!?])[\")*]* +(?=[\"(*]*[A-Z0-9`])", text) if s]


def has_verb(sentence):
    words = re.findall(r"[A-Za-z']+", sentence)
    return any(w.lower() in VERBS or re.search(r"(?:[^s]s|ed|'s|'re)$", w.lower()) for w in words)


def count(paragraphs, known):
    """Words, and matches as (line, kind, text)."""
    words, found = 0, []
    for line, text, judged in paragraphs:
        words += len(re.findall(r"[A-Za-z][\w'-]*", text))
        for kind, list_ in known.items():
            taken = []
            for pattern in list_:
                for match in pattern.finditer(text):
                    if all(match.end() <= a or match.start() >= b for a, b in taken):
                        taken.append(match.span())
                        found.append((line, kind, match.group(0)))
        if judged is False:
            continue
        for sentence in sentences(text):
            length = len(re.findall(r"[A-Za-z][\w'-]*", sentence))
            if length > MAX_SENTENCE:
                found.append((line, "long", f"{length} words: {sentence[:60]}"))
            if judged and length >= 4 and re.search(r"[.!]\W*$", sentence) and not has_verb(sentence):
                found.append((line, "no verb", sentence[:60]))
    return words, found


def read(path):
    text = path.read_text().split("\n## Retired words")[0]  # the glossary's list of them is no use of them
    return prose_of_comments(text) if path.suffix in (".h", ".hpp", ".c") else prose_of_markdown(text)


CANARY = """
# What is held

What is not done by then waits. Who detaches that has a pin. It takes off what is held.
The destroyed handle is told. The row goes on with it anew, lest nobody does what the law says.
Of a thread alone, with no contact. The guide shows what a scene costs. `what is held` is code.

| the same of what is far | a number |

This sentence has a subject and a verb and then goes past the limit because it collects one clause after another, and another, and
yet another one, until no reader can remember how it began or where in all of this the verb was that it began with.
"""
CANARY_COUNT = {"free relative": 5, "told": 1, "german verb": 1, "archaic": 2, "personified": 2, "no verb": 1, "the same": 1, "long": 1}


def self_test():
    _, found = count(prose_of_markdown(CANARY), patterns())
    counted = dict(collections.Counter(kind for _, kind, _ in found))
    if counted != CANARY_COUNT:
        for match in found:
            print(*match)
        sys.exit(f"check_language: self test: FAIL\n  counted {counted}\n  wanted  {CANARY_COUNT}")
    clean = "# Contact\n\nThe solver eliminates the interior nodes. Work left over is deferred to the next call.\n"
    if count(prose_of_markdown(clean), patterns())[1]:
        sys.exit("check_language: self test: FAIL: a plain text has patterns")
    print("check_language: self test: pass")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--limit", type=float)
    parser.add_argument("--file-limit", type=float)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    files = options.files or [
        *(SOURCE / name for name in ("README.md", "CONTRIBUTING.md") if (SOURCE / name).exists()),
        *(page for page in sorted((SOURCE / "docs").rglob("*.md")) if "notebook" not in page.relative_to(SOURCE).parts),
        *sorted((SOURCE / "include").rglob("*.h*"))]
    known, all_words, all_found, bad = patterns(), 0, [], []
    for path in files:
        words, found = count(read(path), known)
        all_words += words
        all_found += found
        rate = 1000 * len(found) / max(words, 1)
        kinds = ", ".join(f"{kind} {n}" for kind, n in collections.Counter(kind for _, kind, _ in found).most_common())
        resolved = path.resolve()
        name = resolved.relative_to(SOURCE) if resolved.is_relative_to(SOURCE) else path
        print(f"{str(name):44} {words:6} words {len(found):4} patterns {rate:5.1f} per 1000  {kinds}")
        if options.list:
            for line, kind, text in found:
                print(f"    {name}:{line}: {kind}: {text}")
        if options.file_limit is not None and words > SHORT_FILE and rate > options.file_limit:
            bad.append(f"{name}: {rate:.1f} per 1000 words")
    rate = 1000 * len(all_found) / max(all_words, 1)
    kinds = ", ".join(f"{kind} {n}" for kind, n in collections.Counter(kind for _, kind, _ in all_found).most_common())
    print(f"{'all':44} {all_words:6} words {len(all_found):4} patterns {rate:5.1f} per 1000  {kinds}")
    if options.limit is not None and rate > options.limit:
        bad.append(f"all: {rate:.1f} per 1000 words")
    if bad or not all_words:
        sys.exit("check_language: FAIL: above the limit\n  " + "\n  ".join(bad))


if __name__ == "__main__":
    main()
