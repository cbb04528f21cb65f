"""Words: the field's terms, retired words, odd sentences, lines that know the baseline."""
import collections
import io
import re
import tokenize
from typing import NamedTuple

import c_text
import public_headers
from figures import Section

# ---- terms of the field

# A term is written with spaces; in the text its words may be joined by _, -, a blank, a line break or nothing.
# Alternatives are separated by |. Endings may follow: "constraint" finds "constraints".
TERMS = [  # what an engineer looks for first
    "line search", "warm start", "broad phase", "narrow phase", "ccd|time of impact|toi|continuous collision", "substep",
    "rollback|roll back", "checkpoint", "budget", "time slice", "kinematic", "dedup|duplicate",
    "constraint", "jacobian|jac", "sparse|sparsity", "aabb|bounding box|bvh|bounding volume",
    "schur", "active set",
]
OTHER_TERMS = [  # without a limit
    "newton", "residual", "converge", "linearis", "snapshot", "penetrat", "truncat", "prescribed", "static condensation",
    "minimum degree|min degree", "symbolic", "remesh", "refine", "coarsen", "debounce", "dispatch", "merit function",
    "suspend", "slip direction|slip dir",
]
FEWEST_HITS = 5  # of each term, wanted


def term_pattern(term, joint):
    forms = [form.replace(" ", joint) for form in term.split("|")]
    # Abbreviations stand alone; other terms may have an ending.
    forms = [form + r"(?![a-z])" if len(form) <= 4 else form for form in forms]
    return re.compile(r"(?<![a-z])(?:" + "|".join(forms) + ")", re.I)


def camel_apart(text):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", text)


def terms(tree):
    section = Section("terms", "Terms of the field in lib/", ["hits", "identifiers", "comments", "file names"])
    paths = c_text.sources(tree / "lib")
    codes = camel_apart("\n".join(c_text.code(c_text.read(path)) for path in paths))
    remarks = camel_apart("\n".join(c.text for path in paths for c in c_text.comments(c_text.read(path))))
    names = "\n".join("/".join(path.relative_to(tree / "lib").parts) for path in paths)
    rare = []
    for term in TERMS + OTHER_TERMS:
        name = term.split("|")[0]
        hits = [len(term_pattern(term, joint).findall(text))
                for joint, text in ((r"_?", codes), (r"[\s_-]*", remarks), (r"[_-]?", names))]
        section.add(name, sum(hits), *hits)
        if term in TERMS and sum(hits) < FEWEST_HITS:
            rare.append(f"{name} is found {sum(hits)} times in lib/, wanted are {FEWEST_HITS}")
    section.measure("rare terms", len(rare), rare)
    return section


# ---- retired words

COLUMNS = ["lib", "tests", "bench", "examples"]


def glossary_rows(text):
    """Word -> what to use instead, from the table | retired | use | of the glossary."""
    table = re.search(r"^\| *retired *\| *use *\|\n\|[-| ]+\|\n((?:\|.*\|\n?)+)", text, re.M)
    found = {}
    for row in table.group(1).splitlines() if table else []:
        retired, use = (cell.strip() for cell in row.strip().strip("|").split("|"))
        for word in retired.split(","):
            found[word.strip()] = use
    return found


def forms(word):
    """A word and its regular forms in -s, -ed and -ing."""
    stem = word[:-1] if word.endswith("e") else word
    return {word, word + "s", stem + "ed", stem + "ing"}


def retired_forms(text):
    return {form: (word, use) for word, use in glossary_rows(text).items() for form in forms(word)}


def retired_in(name, retired):
    """The retired forms in a name. A stand-in is a standard term, whatever `stand` alone is."""
    words = c_text.words(name)
    stand_ins = {word for word, after in zip(words, words[1:]) if word == "stand" and after in ("in", "ins")}
    return (set(words) & set(retired)) - stand_ins


class PublicNames:
    """Names that hosts use: with the library's prefix, and fields of public structs, these only where a field stands."""
    FIELD = re.compile(r"(?:\.|->|\boffsetof\s*\(\s*\w+\s*,|\bFIELD\s*\()\s*$")

    def __init__(self, tree):
        include = tree / "include"
        text = "\n".join(c_text.code(c_text.read(path)) for path in public_headers.headers(include))
        names = set(c_text.IDENTIFIER.findall(text))
        self.prefixed = {name for name in names if name.lower().startswith("vbss_")}
        self.fields = {field for fields in public_headers.structs(include)[0].values() for field, _, _ in fields}

    def has(self, name, before):
        return name in self.prefixed or (name in self.fields and bool(self.FIELD.search(before)))


def private_identifiers(path, public):
    text = c_text.code(c_text.read(path)) if path.suffix in c_text.SOURCES else python_names(c_text.read(path))
    for match in c_text.IDENTIFIER.finditer(text):
        if not public.has(match.group(), text[max(0, match.start() - 80):match.start()]):
            yield match.group()


def python_names(text):
    """The names and operators of a Python source; comments and strings are left out."""
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    return " ".join(token.string for token in tokens if token.type in (tokenize.NAME, tokenize.OP))


def count_retired(tree, folder, retired, public):
    """Counts a word of hits in identifiers and of file names; findings, one for an identifier of a file."""
    identifiers, names, findings = collections.Counter(), collections.Counter(), []
    for path in sorted(p for p in (tree / folder).rglob("*") if p.is_file() and "__pycache__" not in p.parts):
        where = path.relative_to(tree)
        for word in retired_in(path.name, retired):
            names[retired[word][0]] += 1
            findings.append(f"{where}: the file name has '{word}'; use {retired[word][1]}")
        if path.suffix not in (*c_text.SOURCES, ".py"):
            continue
        for name, count in collections.Counter(private_identifiers(path, public)).items():
            for word in retired_in(name, retired):
                identifiers[retired[word][0]] += count
                findings.append(f"{where}: {name} has '{word}'; use {retired[word][1]}")
    return identifiers, names, findings


def retired(tree, glossary):
    columns = [column for folder in COLUMNS for column in (folder, "files")]
    section = Section("retired", "Retired words in identifiers, and in file names (files)", columns,
                      "Words of docs/reference/glossary.md with their endings -s, -ed, -ing; names of the public interface are left out.")
    table = retired_forms(glossary)
    public = PublicNames(tree)
    counts = {folder: count_retired(tree, folder, table, public) for folder in COLUMNS}
    for word in glossary_rows(glossary):
        section.add(word, *(counter[word] for folder in COLUMNS for counter in counts[folder][:2]))
    section.add("all words", *(sum(counter.values()) for folder in COLUMNS for counter in counts[folder][:2]))
    total = sum(counter.total() for folder in COLUMNS for counter in counts[folder][:2])
    section.measure("retired words", total, [line for folder in COLUMNS for line in counts[folder][2]])
    return section


# ---- odd patterns in comments

START = r"(?:\A\s*|[.;:]\s+)"
CLAUSE = r"(?:\A\s*|[.;:,(]\s*|\b(?:of|by|with|to|for|from|than|as|in|on|at|and|or|but|that|only|all|nor|not)\s+)"
VERB = (r"(?:is|are|was|were|it|they|he|we|has|have|had|does|do|did|can|cannot|may|might|must|would|will|shall|should|"
        r"nobody|no|[a-z]{2,}s)\b")
ODD = {name: re.compile(pattern, re.I) for name, pattern in {
    "headless 'of ...'": START + r"of\s(?!course\b)",
    "headless 'the same'": START + r"(?:and\s|or\s)?the\ssame(?:\s(?:of|for|with|in|on|as|by|at|to|from|when|where)\b|"
                           r"\s*(?:[.;:,]|\Z))|\bthe\ssame\sof\b",
    "free relative 'what ...'": CLAUSE + r"what\s+" + VERB,
    "free relative 'who ...'": START + r"(?:who|whom)\s+" + VERB + r"|\b(?:by|to|for|of|than|and|or|but)\s+who\s+" + VERB,
    "'is told'": r"\b(?:is|are|was|were|be|been|being|not|have|has)\s+told\b|,\s+told\b|\buntold\b",
    "'lest', 'anew', 'aslant'": r"\b(?:lest|anew|aslant)\b",
    "'the begin'": r"\b(?:the|a|its|their|each|every|this|that|of|from|at)\s+begin\b",
    "'comes to'": r"\b(?:come|comes|came|coming)\s+to\b",
    "'goes on with'": r"\b(?:go|goes|went|going|gone)\s+on\b",
    "'stands in'": r"\b(?:stands?|stood)\s+"
                   r"(?:in|on|at|for|by|behind|before|beside|between|there|here|above|below|still|one)\b",
    "'nobody', 'somebody'": r"\b(?:nobody|somebody|anybody|everybody|no\sone|whoever|ordered\sby\snobody)\b",
    "'is none', 'is no ...'": r"(?<!there\s)\b(?:is|are|was|were)\s+(?:none\b|no\s(?!longer|more|such|less|other)[a-z]+)",
    "'so many'": r"\bso\s(?:many|much|often)\b(?!\s+(?:that|as)\b)",
    "'a hair'": r"\ba\shair\b",
}.items()}
WORD = re.compile(r"[A-Za-z][A-Za-z']*")


class Oddity(NamedTuple):
    folder: str
    where: str  # file:line
    pattern: str
    text: str


def oddities(tree):
    for path in c_text.sources(tree / "lib"):
        where = path.relative_to(tree)
        folder = "/".join(where.parts[1:-1])
        for comment in c_text.comments(c_text.read(path)):
            for name, pattern in ODD.items():
                for match in pattern.finditer(comment.text):
                    begin = match.end() - len(match.group().lstrip())
                    line = comment.line + comment.text.count("\n", 0, begin)
                    text = " ".join(comment.text[begin:begin + 70].split())
                    yield Oddity(folder, f"{where}:{line}", name, text)


def comment_words(tree):
    """Folder -> words in its comments."""
    found = collections.Counter()
    for path in c_text.sources(tree / "lib"):
        folder = "/".join(path.relative_to(tree / "lib").parts[:-1])
        found[folder] += sum(len(WORD.findall(comment.text)) for comment in c_text.comments(c_text.read(path)))
    return found


def odd(tree):
    section = Section("odd", "Odd patterns in comments of lib/", ["per 1000 words", "hits", "words"])
    found, words = list(oddities(tree)), comment_words(tree)
    total = words.total() or 1
    section.add("lib", 1000.0 * len(found) / total, len(found), words.total())
    by_folder = collections.Counter(oddity.folder for oddity in found)
    for folder in sorted(words):
        section.add(folder, 1000.0 * by_folder[folder] / (words[folder] or 1), by_folder[folder], words[folder])
    by_pattern = collections.Counter(oddity.pattern for oddity in found)
    for name in ODD:
        section.add(name, 1000.0 * by_pattern[name] / total, by_pattern[name], None)
    section.measure("odd patterns per 1000 words", 1000.0 * len(found) / total,
                    (f"{oddity.where}: {oddity.pattern}: {oddity.text}" for oddity in found))
    return section


# ---- the baseline

BASELINE = re.compile(r"paper|VBSS_METHOD_", re.I)


def is_baseline(parts):
    """Whether a file below lib/ belongs to the baseline."""
    return parts[0] == "baseline"


def knows_baseline(line, public):
    """'' | 'public': only by names of the public interface | 'private'. A field of a public struct may stand anywhere: tables of
    ranges and of records name it."""
    if not BASELINE.search(line):
        return ""
    rest = c_text.IDENTIFIER.sub(
        lambda name: "" if name.group() in public.fields or public.has(name.group(), line[:name.start()]) else name.group(), line)
    return "private" if BASELINE.search(rest) else "public"


def baseline(tree):
    section = Section("baseline", "Lines of lib/ outside the baseline's files that know the baseline",
                      ["lines", "with public names only"])
    public, findings = PublicNames(tree), []
    counts = collections.defaultdict(collections.Counter)
    for path in c_text.sources(tree / "lib"):
        where = path.relative_to(tree)
        if is_baseline(where.parts[1:]):
            continue
        for number, line in enumerate(c_text.read(path).splitlines(), 1):
            kind = knows_baseline(line, public)
            counts["/".join(where.parts[1:-1])][kind] += 1
            if kind == "private":
                findings.append(f"{where}:{number}: {line.strip()}")
    section.add("lib", *(sum(count[kind] for count in counts.values()) for kind in ("private", "public")))
    section.add("files", len({finding.partition(":")[0] for finding in findings}), None)
    for folder in sorted(counts):
        section.add(folder, counts[folder]["private"], counts[folder]["public"])
    section.measure("lines that know the baseline", len(findings), findings)
    return section
