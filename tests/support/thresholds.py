#!/usr/bin/env python3
"""Every threshold stands in a table of its room, with unit and reason.

A room is a folder of src/. Its table is the header tolerances.hpp in it, or limits.hpp. An entry of a table is one
constant below a comment (///) with its unit in brackets ("[length]", "[1]" where it has none) and the reason of its
value; something in src/ uses it.

Outside tables these are bare thresholds:
    exponent   a number in exponent notation: 1e-9, 0x1p-40
    fraction   a number that is no multiple of 1/2: 0.03, 1.001
    roundings  the unit roundoff: 8 * u, 16 * unit_roundoff * x; the machine epsilon
    name       a constant made of numbers, but 0 and -1: constexpr int most_rounds = 200; a default of 2 or more in a
               header: double budget = 5
    count      a whole number of 5 or more that is compared or computed with: i < 200, 100 + 20 * n, size() / 8; a power
               of two written as a shift: 1 << 20
Small whole numbers and halves are those of formulas. Other numbers that are no thresholds are listed below, each with
what it is; a line of this list that fits nothing is an error.

Usage: thresholds.py SRC. Exit 0: no bare threshold in the rooms that stay. Needs nothing but Python 3.
"""
import pathlib
import re
import sys
import tempfile

STAYS, MOVES, GOES = "stays", "moves", "goes"

# Rooms that stay have no bare threshold. Those that move are being rebuilt, those that go are written anew: theirs are
# only listed. A line is a folder of src/, or files of it, which then count as a room of their own.
ROOMS = {
    "core": STAYS,
    "math": STAYS,
    "linear_algebra": STAYS,
    "projection": STAYS,
    "flight": STAYS,
    "toi": STAYS,
    "scene": STAYS,
    "stepping": STAYS,
    "study": STAYS,
    "tunnel": STAYS,
    "audit": STAYS,
    "peers": STAYS,
    "io": STAYS,
    "report": STAYS,
    "cli": STAYS,
    "simulate": STAYS,
    "broad": STAYS,
    "queue": STAYS,
    "contact": STAYS,
    "window": STAYS,
    "impact": STAYS,
    "motion": STAYS,
    "gather": STAYS,
    "hold": STAYS,
    "heap": STAYS,
    "predict": STAYS,
    "event_driven": STAYS,
    "reference": STAYS,
    "verify": STAYS,
    "hold/guard": GOES,
    "hold/hold_component": GOES,
    "verify/bounces": GOES,
    "verify/contact_audit": GOES,
    "verify/impact_audit": GOES,
    "verify/instant_bodies": GOES,
}

# Numbers that are no thresholds: file, the text on its line, what it is.
NO_THRESHOLDS = [
    ("core/random.hpp", "std::rotl(state_[1] * 5, 7) * 9", "xoshiro256**"),
    ("core/random.hpp", "0x1.0p-53", "53 bits as a number in [0, 1)"),
    ("math/dyadic.cpp", "limb_bits = 32", "size of a limb"),
    ("math/dyadic.cpp", "mantissa_bits = 53", "format of doubles"),
    ("toi/quartic_gap.cpp", "Dyadic(0.25) * dot(a, a)", "coefficient of |a t^2 / 2|^2"),
    ("verify/pair_gap_accelerated.cpp", "0.25 * (std::max(0.0, x.curvature)", "height of an arc over its chord"),
    ("verify/plane_gap.cpp", "duration * duration / 8", "height of an arc over its chord"),
    ("audit/touch.cpp", "duration * duration / 8", "height of an arc over its chord"),
    ("scene/fill.cpp", "four_thirds_pi", "volume of a ball"),
    ("scene/sphere_grid.cpp", "mantissa_bits = 52, exponent_mask = 0x7ff", "format of doubles"),
    ("motion/numeric_cluster.cpp", "h / 6", "weights of Runge and Kutta"),
    ("motion/numeric_cluster.cpp", "forces[i])) / 6", "weights of Runge and Kutta"),
    ("stepping/cell_grid.cpp", "nowhere = 0xffffffff", "number of no cell"),
    ("stepping/cell_grid.cpp", "far_away = nowhere - 1", "number of no cell"),
    ("study/words.cpp", '" nm"', "prefixes of units"),
    ("study/words.cpp", '" ns"', "prefixes of units"),
    ("io/as_value.cpp", "dimensions = 3", "of space"),
    ("io/json_text.cpp", "first_printable = 0x20", "ASCII"),
    ("io/json_parse.cpp", "number_too_large = 406", "number of the parser's error"),
    ("io/numbers.cpp", "digit % 10", "decimal digits"),
    ("io/numbers.cpp", "digit / 10", "decimal digits"),
    ("io/numbers.cpp", "low_bits = 32", "half of 64 bits"),
    ("io/recording_bodies.cpp", "3 * sizeof(double)", "size of a vector"),
    ("io/recorded_columns.hpp", "8 * sizeof(Value)", "bits of a byte"),
    ("io/recording_columns.hpp", "lanes<10>", "numbers of a series"),
    ("io/recording_format.hpp", "recording_application_id", "name of the format"),
    ("io/recording_format.hpp", "recording_version", "version of the format"),
    ("io/scene_box.cpp", "axes = 3", "of space"),
    ("io/scene_fills.cpp", "two = 2", "ends of an interval"),
    ("io/scene_materials.cpp", "two = 2", "bodies of a contact"),
    ("io/scene_parts.cpp", "first_printable = 0x20", "ASCII"),
    ("io/syntax_error.cpp", "first_printable = 0x20", "ASCII"),
    ("cli/choices.cpp", "1.0 / 240", "default of --dt"),
    ("cli/progress.cpp", "100 * done", "per cent"),
    ("cli/tables.cpp", "100 * times", "per cent"),
    ("cli/verify_command.cpp", "100 * part", "per cent"),
]

NUMBER = re.compile(r"(?<![\w.'])(?:\.?\d(?:[eEpP][+-]|[\w.']|)*)")
SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)
SCALAR = r"(?:double|float|int|unsigned|long|char|auto|bool|Real|Number|BodyId|std::u?int\d+_t|std::size_t)"
NAMED = re.compile(r"\bconstexpr\s+(?:[\w:]+\s+)*?" + SCALAR + r"(?:\s+(?:int|long|char))*\s+(\w+(?:<\w+>)?\s*=[^;]*);")
DEFAULT = re.compile(r"^\s+" + SCALAR + r"\s+\w+\s*=\s*([\d.']+)\s*;")
ROUNDINGS = re.compile(r"\bunit_roundoff\b|[\d.']+\s*\*\s*u2?\b|\bu2?\s*\*\s*\d|numeric_limits<[^>]*>::epsilon|DBL_EPSILON")
SHIFT = re.compile(r"\b1[uUlL]*\}?\s*<<\s*\d+")
COMPUTED = r"[-+*/%]|[<>]=?|[=!]="
UNIT = re.compile(r"\[[^\]]+\]")
LEAST_WORDS = 6  # of a reason
LINES_OF_A_STATEMENT = 5


def without_comments(text):
    """The code, line by line; comments, strings and characters are blank."""
    return SKIPPED.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def value(number):
    text = number.replace("'", "").rstrip("uUlLfF") if not number.startswith("0x") else number
    try:
        return float.fromhex(text) if text.startswith("0x") else float(text)
    except ValueError:
        return None


def is_table(path):
    return path.name in ("tolerances.hpp", "limits.hpp")


def without_sizes(line):
    """Lengths of arrays, indices and arguments of templates decide nothing."""
    line = re.sub(r"std::array<[^;{}]*>", "", line)
    return re.sub(r"\[[^\[\]]*\]", "[]", line)


def counts(line):
    line = SHIFT.sub("", without_sizes(line))
    line = re.sub(r"(<<|>>)=?\s*(\w+|\([^()]*\))", "", line)
    number = r"(?<![\w.'])\d[\d']*[uUlL]*(?![\w.'])"
    found = re.findall(rf"(?:{COMPUTED})\s*({number})|({number})\s*(?:{COMPUTED})", line)
    return [n for pair in found for n in pair if n and value(n) is not None and value(n) >= 5]


def kinds(line, statement, in_header):
    """Why a line holds bare thresholds. `statement`: the line with what continues it."""
    out = []
    for number in NUMBER.findall(line):
        is_hex = number.lower().startswith("0x")
        if re.search(r"[pP]" if is_hex else r"[eE]", number):
            out.append("exponent")
        elif "." in number and not is_hex and value(number) is not None and (2 * value(number)) % 1 != 0:
            out.append("fraction")
    if ROUNDINGS.search(line):
        out.append("roundings")
    named = NAMED.search(statement)
    if named and re.search(r"(?<!if )\bconstexpr\b", line):
        for part in named.group(1).split(","):
            right = part.split("=", 1)[-1]
            numbers = [n for n in NUMBER.findall(right) if value(n) not in (0, None)]
            if numbers and not re.fullmatch(r"\s*-1\s*", right):
                out.append("name")
    default = DEFAULT.search(line) if in_header else None
    if default and (value(default.group(1)) or 0) >= 2:
        out.append("name")
    if SHIFT.search(without_sizes(line)) or counts(line):
        out.append("count")
    return out


def scan(path):
    """(line number, kind, text) of each line of a file that holds bare thresholds."""
    text = path.read_text()
    shown, code = text.split("\n"), without_comments(text).split("\n")
    for i, line in enumerate(code):
        statement = " ".join(code[i:i + LINES_OF_A_STATEMENT]).split(";")[0] + ";"
        found = kinds(line, statement, path.suffix == ".hpp")
        if found:
            yield i + 1, found[0], shown[i].strip()


def entries(path):
    """(line number, name, what is wrong or None) of each constant of a table."""
    lines = path.read_text().split("\n")
    code = without_comments(path.read_text()).split("\n")
    for i, line in enumerate(code):
        if not re.search(r"\bconstexpr\b", line):
            continue
        name = re.search(r"(\w+)(?:<\w+>)?\s*(?:=|\{)", line)
        first = i - 1 if i > 0 and re.match(r"\s*template\b", code[i - 1]) else i
        comment = []
        while first > 0 and lines[first - 1].strip().startswith("///"):
            first -= 1
            comment.append(lines[first].strip()[3:])
        comment = " ".join(reversed(comment))
        wrong = None
        if re.search(r",\s*\w+\s*=", line):
            wrong = "two constants on a line"
        elif not UNIT.search(comment):
            wrong = "has no unit in brackets in a comment above it"
        elif len(UNIT.sub("", comment).split()) < LEAST_WORDS:
            wrong = "has no reason"
        yield i + 1, name.group(1) if name else "?", wrong


def room_of(file, rooms):
    fitting = [room for room in rooms if file.startswith(room + "/") or file.startswith(room + ".")]
    return max(fitting, key=len) if fitting else None


def examine(src, rooms, no_thresholds):
    """(entries in tables by room, bare thresholds by room, errors)"""
    tables, bare, errors = {room: 0 for room in rooms}, {room: [] for room in rooms}, []
    files = sorted(p for p in src.rglob("*") if p.suffix in (".hpp", ".cpp"))
    used = {}
    for path in files:
        for word in re.findall(r"[A-Za-z_]\w*", without_comments(path.read_text())):
            used[word] = used.get(word, 0) + 1
    fits, seen = set(), set()
    for path in files:
        file = path.relative_to(src).as_posix()
        room = room_of(file, rooms)
        seen.add(room or file.split("/")[0])
        if room is None:
            continue
        if is_table(path):
            for line, name, wrong in entries(path):
                tables[room] += 1
                if wrong is None and used.get(name, 0) < 2:
                    wrong = "is used by nothing"
                if wrong and rooms[room] == STAYS:
                    errors.append(f"{file}:{line}: {name} {wrong}")
            continue
        for line, kind, text in scan(path):
            excused = [k for k, (where, part, _) in enumerate(no_thresholds) if where == file and part in text]
            fits.update(excused)
            if not excused:
                bare[room].append(f"{file}:{line}: {kind}: {text}")
    errors += [f"no room: {name} (add it to the list)" for name in sorted(seen - set(rooms))]
    errors += [f"no such room: {room} (remove it from the list)" for room in rooms if room not in seen]
    errors += [f"no such number: {where}: {part}" for k, (where, part, _) in enumerate(no_thresholds)
               if k not in fits]
    return tables, bare, errors


PLANTED = {
    "stays/exponent.cpp": "bool f(double x) { return x < 1e-9; }\n",
    "stays/binary.hpp": "inline bool f(double x) { return x < 0x1p-40; }\n",
    "stays/fraction.cpp": "double f(double x) { return 0.03 * x; }\n",
    "stays/roundings.cpp": "double f(double x) { return 8 * unit_roundoff * x; }\n",
    "stays/name.cpp": "constexpr int most_rounds =\n    8;\n",
    "stays/default.hpp": "struct Options {\n    double budget = 5;\n};\n",
    "stays/count.cpp": "void f() { for (int i = 0; i < 200; ++i) g(); }\n",
    "stays/shift.cpp": "bool f(long n) { return n < (1L << 20); }\n",
    "stays/tolerances.hpp": "/// Gap [length] of what touches: twice the rounding of a place.\n"
                            "inline constexpr double good = 1e-9;\n"
                            "/// Gap of what touches: twice the rounding of a place.\n"
                            "inline constexpr double no_unit = 1e-9;\n"
                            "/// [length]\n"
                            "inline constexpr double no_reason = 1e-9;\n"
                            "/// Gap [length] of what touches: twice the rounding of a place.\n"
                            "inline constexpr double unused = 1e-9;\n",
    "stays/fine.cpp": "// 1e-9\nconst char* text = \"1e-9\";\ndouble f(double x) { return x < good ? 0.5 * x : 4.0 / 3 * x"
                      " + no_unit + no_reason; }\nstd::array<char, 64> buffer{};\nint k = table[6 + j];\n"
                      "unsigned long h = 0x9e3779b97f4a7c15ULL >> 29;\n",
    "stays/excused.cpp": "double f() { return 1e-3; }\n",
    "goes/exponent.cpp": "bool f(double x) { return x < 1e-9; }\n",
    "new/exponent.cpp": "bool f(double x) { return x < 1e-9; }\n",
}


def control():
    """The check itself: in a small tree with planted thresholds it finds these, and nothing else."""
    with tempfile.TemporaryDirectory() as folder:
        src = pathlib.Path(folder)
        for name, text in PLANTED.items():
            (src / name).parent.mkdir(exist_ok=True)
            (src / name).write_text(text)
        excuses = [("stays/excused.cpp", "1e-3", "a unit"), ("stays/excused.cpp", "1e-4", "is not there")]
        _, bare, errors = examine(src, {"stays": STAYS, "goes": GOES, "gone": GOES}, excuses)
    found = [line.split(": ")[0].split("/")[1].split(".")[0] + " " + line.split(": ")[1] for line in bare["stays"]]
    wanted = ["binary exponent", "count count", "default name", "exponent exponent", "fraction fraction", "name name",
              "roundings roundings", "shift count"]
    assert found == wanted, f"the check itself is wrong: {found}"
    assert len(bare["goes"]) == 1, "the check itself does not list the rooms that go"
    faults = [error.split(": ", 1)[1].split()[0] for error in errors]
    assert faults == ["no_unit", "no_reason", "unused", "new", "gone", "stays/excused.cpp:"], faults


def main():
    control()
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    tables, bare, errors = examine(pathlib.Path(sys.argv[1]), ROOMS, NO_THRESHOLDS)
    print(f"{'room':28} {'':6} in tables  bare")
    for room, state in ROOMS.items():
        print(f"{room:28} {state:6} {tables[room]:9}  {len(bare[room]):4}")
    for state in (GOES, MOVES, STAYS):
        for room in (r for r in ROOMS if ROOMS[r] == state and bare[r]):
            print(f"\n{room} ({state}):")
            print("\n".join("  " + line for line in bare[room]))
    failures = sum(len(bare[room]) for room in ROOMS if ROOMS[room] == STAYS)
    for error in errors:
        print(error)
    print(f"\n{failures} bare thresholds in rooms that stay, {len(errors)} other faults")
    return 1 if failures or errors else 0


if __name__ == "__main__":
    sys.exit(main())
