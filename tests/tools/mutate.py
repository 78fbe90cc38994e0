#!/usr/bin/env python3
"""mutate.py FILE...: which small faults in a source file does no test of it see?

Each mutant is a copy of the file with one change: a comparison, a sign, a constant, `&&` or `||`, min or max. It is
compiled by the build's own command, linked with the tests that belong to the file, and these run. What they pass has
survived: a test is missing, or the change makes no difference. The source itself is never touched.

    tests/tools/mutate.py core/surface/thinning.cpp --limit 15 --seed 1
"""
import argparse
import json
import os
import pathlib
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What is changed into what. The format of the house puts blanks around operators of two sides and none around templates,
# addresses and signs, so that they can be told apart without a parser.
SWAPS = [
    (r" <= ", (" < ", " > ")), (r" >= ", (" > ", " < ")), (r" < ", (" <= ", " >= ")), (r" > ", (" >= ", " <= ")),
    (r" == ", (" != ",)), (r" != ", (" == ",)), (r" && ", (" || ",)), (r" \|\| ", (" && ",)),
    (r" [+-] 1\b(?![.'])", ("",)), (r" \+ ", (" - ",)), (r" - ", (" + ",)), (r" \* ", (" / ",)), (r" / ", (" * ",)),
    (r" \+= ", (" -= ",)), (r" -= ", (" += ",)), (r" \*= ", (" /= ",)), (r" /= ", (" *= ",)),
    (r"(?<=[(,=?:{[] )-(?=[\w(])|(?<=[(\[{])-(?=[\w(])|(?<=return )-(?=[\w(])", ("",)), (r"(?<![\w)])!(?=[\w(])", ("",)),
    (r"\bmin\(", ("max(",)), (r"\bmax\(", ("min(",)), (r"\btrue\b", ("false",)), (r"\bfalse\b", ("true",)),
    (r"\bcontinue;", ("break;",)), (r"\bbreak;", ("continue;",)), (r"\bany_of\(", ("all_of(",)), (r"\ball_of\(", ("any_of(",)),
]
NUMBER = re.compile(r"(?<![\w.'])(\d+\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+|\d+)(f|u|ul|uz)?\b(?![.'])")


def masked(text):
    """The text with what is no code (comments, strings, directives, declarations of templates) blanked out."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group(0))
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^\s*#[^\n]*|static_assert\([^\n]*', blank,
                  text, flags=re.S | re.M)


def other_number(match):
    value, suffix = match.group(1), match.group(2) or ""
    if re.fullmatch(r"\d+", value):
        return str(int(value) + 1 if int(value) < 10 else 2 * int(value)) + suffix
    return ("1.0" if float(value) == 0 else repr(2 * float(value))) + suffix


def mutants(text):
    """All changes: (first character, last, what comes there)."""
    code, found = masked(text), []
    for pattern, others in SWAPS:
        for match in re.finditer(pattern, code):
            found += [(*match.span(), other) for other in others]
    found += [(*match.span(), other_number(match)) for match in NUMBER.finditer(code)]
    return sorted(found)


def limit_memory():
    """A mutant that never stops adding to something ends before the machine does."""
    resource.setrlimit(resource.RLIMIT_AS, (16 << 30, 16 << 30))


class Tests:
    """The tests that belong to a source file: theirs is its name, or they include its header."""

    def __init__(self, source):
        layer, stem = source.parts[0], source.stem
        every = sorted((ROOT / "tests" / layer).rglob("*_test.cpp"))
        header = f'#include "{source.with_suffix(".h")}"'
        self.files = ([f for f in every if f.name == stem + "_test.cpp"] or [f for f in every if header in f.read_text()])
        if not self.files:
            sys.exit(f"mutate: no test in tests/{layer} has the name of {source}, or includes its header")
        suites = {m for f in self.files for m in re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+)", f.read_text(), re.M)}
        # As they are, with parameters, and with types.
        self.filter = ":".join(form.format(suite) for suite in sorted(suites) for form in ("{}.*", "*/{}.*", "{}/*"))


class Build:
    """Compiles, links and runs, with the commands of a build folder of ninja's; all that is made lies in `folder`."""

    def __init__(self, build, source, tests, folder):
        self.build, self.folder = build, folder
        self.copy, self.object, self.program = folder / source.name, folder / "mutant.o", folder / "tests"
        target = f"{source.parts[0]}_tests"
        self.compiler = self.compile_command(source)
        self.linker, needed = self.link_command(target, source, tests)
        self.run(["ninja", "-C", str(build), *needed], 7200, show=True)

    def compile_command(self, source):
        entries = json.loads((self.build / "compile_commands.json").read_text())
        entry = next((e for e in entries if pathlib.Path(e["file"]) == ROOT / source), None)
        if not entry:
            sys.exit(f"mutate: {source} is not in {self.build}/compile_commands.json")
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = str(self.object)
        words[words.index("-c") + 1] = str(self.copy)
        words = [w for w in words if not w.endswith("ccache")]
        # An index beyond a vector's end is a fault that is seen; warnings are none.
        return words + ["-w", "-D_GLIBCXX_ASSERTIONS"]

    def link_command(self, target, source, tests):
        commands = subprocess.run(["ninja", "-C", str(self.build), "-t", "commands", target], capture_output=True, text=True,
                                  check=True).stdout.splitlines()
        words = max((shlex.split(part) for part in commands[-1].split("&&")), key=len)
        objects = [w for w in words if w.endswith(".o")]
        wanted = [o for o in objects if any(o.endswith(f"/{f.relative_to(ROOT / 'tests')}.o") for f in tests.files)]
        support = [o for o in objects if "/support/" in o]
        kept = {*wanted, *support} if len(wanted) == len(tests.files) else set(objects)  # else they are compiled together
        words = [w for w in words if not w.endswith(".o") or w in kept]
        words[words.index("-o") + 1] = str(self.program)
        words.insert(words.index("-o"), str(self.object))  # before the library, which then need not give its own
        libraries = [w for w in words if w.endswith(".a") and not os.path.isabs(w)]
        return words, [*kept, *libraries]

    def run(self, words, seconds, show=False):
        """The exit status; None where it took too long. The process and its children are gone in the end."""
        quiet = None if show else subprocess.DEVNULL
        process = subprocess.Popen(words, cwd=self.build, stdout=quiet, stderr=quiet, start_new_session=True,
                                   env={**os.environ, "OMP_WAIT_POLICY": "passive"}, preexec_fn=limit_memory)
        try:
            return process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()

    def has_tests(self, filter_):
        listed = subprocess.run([str(self.program), f"--gtest_filter={filter_}", "--gtest_list_tests"], capture_output=True,
                                text=True, check=True)
        return "\n  " in listed.stdout

    def try_out(self, text, filter_, seconds):
        """"not compiled", "killed", "hung" or "survived"."""
        self.copy.write_text(text)
        if self.run(self.compiler, 600) != 0 or self.run(self.linker, 600) != 0:
            return "not compiled"
        start = time.monotonic()
        status = self.run([str(self.program), f"--gtest_filter={filter_}", "--gtest_fail_fast"], seconds)
        self.seconds = time.monotonic() - start
        return {0: "survived", None: "hung"}.get(status, "killed")


def describe(source, text, mutant):
    begin, end, other = mutant
    number = text.count("\n", 0, begin) + 1
    first = text.rfind("\n", 0, begin) + 1
    line = text[first:].split("\n", 1)[0].strip()
    column = begin - first + 1 + text[begin:end].startswith(" ")
    return f"{source}:{number}:{column}: {text[begin:end].strip()!r} -> {other.strip()!r} in: {line}"


def judge(source, options):
    """Says which mutants of a file survive."""
    if not (ROOT / source).is_file():
        sys.exit(f"mutate: there is no file {source}")
    text = (ROOT / source).read_text()
    drawn = mutants(text)
    random.Random(options.seed).shuffle(drawn)
    if options.list:
        print(*(describe(source, text, m) for m in sorted(drawn[:options.limit])), sep="\n")
        return
    tests = Tests(source)
    filter_ = options.filter or tests.filter
    counts, begun = {"killed": 0, "hung": 0, "survived": 0, "not compiled": 0}, time.monotonic()
    with tempfile.TemporaryDirectory(prefix="sonoskin-mutate-") as folder:
        build = Build(options.build.resolve(), source, tests, pathlib.Path(folder))
        if build.try_out(text, filter_, 3600) != "survived" or not build.has_tests(filter_):
            sys.exit(f"mutate: the tests of {source} fail, do not build, or are none, without any change: {filter_}")
        limit = 10 + 5 * build.seconds
        for mutant in drawn:
            if sum(counts.values()) - counts["not compiled"] == options.limit:
                break
            begin, end, other = mutant
            verdict = build.try_out(text[:begin] + other + text[end:], filter_, limit)
            counts[verdict] += 1
            if verdict == "survived" or options.verbose:
                print(f"{verdict}: {describe(source, text, mutant)}", flush=True)
    print(f"{source}: " + ", ".join(f"{n} {verdict}" for verdict, n in counts.items()) +
          f", of {len(drawn)} possible, in {time.monotonic() - begun:.0f} s", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="FILE", help="a .cpp file of core, render or app, from the root")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="a configured build folder of ninja's")
    parser.add_argument("--limit", type=int, default=15, help="mutants of each file, drawn at random")
    parser.add_argument("--seed", type=int, default=1, help="which are drawn")
    parser.add_argument("--filter", help="tests to run, as --gtest_filter has them, instead of all in the file's test files")
    parser.add_argument("--list", action="store_true", help="only say which mutants would be drawn")
    parser.add_argument("--verbose", action="store_true", help="say of every mutant what became of it")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("mutate: stopped"))
    for file in options.files:
        judge(pathlib.Path(os.path.relpath(pathlib.Path(file).resolve(), ROOT)), options)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("mutate: stopped")
