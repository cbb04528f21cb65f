"""A table of figures: printed, saved, compared with a saved one, checked against limits."""
import json


class Section:
    """One subject. A row is a label and its numbers; the first number is the one that is compared.
    A measure is a number that may have a limit, with the findings that add up to it."""
    def __init__(self, name, title, columns, note=""):
        self.name, self.title, self.columns, self.note = name, title, columns, note
        self.rows, self.measures = {}, {}

    def add(self, label, *numbers):
        self.rows[label] = list(numbers)

    def measure(self, what, value, findings=()):
        self.measures[what] = (value, list(findings))


def shown(number):
    if number is None:
        return "-"
    return f"{number:.1f}" if isinstance(number, float) else str(number)


def table(header, rows):
    """Rows of (label, numbers) with columns of equal width."""
    lines = [[str(cell) for cell in header]] + [[label, *map(shown, numbers)] for label, numbers in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    text = []
    for label, *numbers in lines:
        cells = [cell.rjust(width) for cell, width in zip(numbers, widths[1:])]
        text.append("  " + "  ".join([label.ljust(widths[0]), *cells]))
    return text


def lines_of(section):
    rows = table(["", *section.columns], section.rows.items())
    return [f"== {section.title}"] + ([f"   {section.note}"] if section.note else []) + rows


def comparison(section, before, names):
    """Two columns, the first number of each row before and after; rows in today's order, then those that are gone."""
    old = before.get("sections", {}).get(section.name, {}).get("rows", {})
    labels = [*section.rows, *(label for label in old if label not in section.rows)]
    rows = [(label, [old.get(label, [None])[0], section.rows.get(label, [None])[0]]) for label in labels]
    title = f"== {section.title}: {section.columns[0]}"
    return [title] + table(["", *names], rows)


def saved(name, sections):
    """JSON with a row a line, which reads and compares well."""
    parts = []
    for section in sections:
        rows = ",\n".join(f"    {json.dumps(label)}: {json.dumps([rounded(n) for n in numbers])}"
                          for label, numbers in section.rows.items())
        parts.append(f"  {json.dumps(section.name)}: {{\n   \"columns\": {json.dumps(section.columns)},\n"
                     f"   \"rows\": {{\n{rows}\n   }}\n  }}")
    return f"{{\n \"name\": {json.dumps(name)},\n \"sections\": {{\n" + ",\n".join(parts) + "\n }\n}\n"


def rounded(number):
    return round(number, 1) if isinstance(number, float) else number


def complaints(section, limits):
    """limits: what -> the largest number that is allowed."""
    found = []
    for what, (value, findings) in section.measures.items():
        if limits.get(what) is not None and value > limits[what]:
            found += [f"{what}: {finding}" for finding in findings]
            found.append(f"{what}: {shown(value)}, allowed are {limits[what]}")
    return found
