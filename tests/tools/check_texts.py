#!/usr/bin/env python3
"""check_texts.py [--list]: every text that a person reads in the window stands in the tables of app/texts in German and French,
with the same places for numbers; no entry is there that nothing uses; and no text is drawn past tr(). With --list the texts that
the sources have, a line each."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WINDOW = ["panels", "widgets", "views", "workspace", "window"]
# Elsewhere: files whose sentences and names the window shows.
SHOWN = ["app/document/view_planes.cpp", "app/document/landmarks.h", "app/document/document_state.cpp",
         "core/pipeline/parameter_use.cpp", "core/pipeline/scan_doubts.cpp", "core/pipeline/face_use.cpp"]
# What has the program's options, and names that it has for people.
OPTIONS = ["core/**/*_options.h", "app/panels/*.cpp"]
PRESETS = {"core/pipeline/presets.cpp": "Preset", "core/skin/skin_presets.cpp": "SkinPreset",
           "render/transfer_presets.cpp": "TransferPreset"}
# Tables of words that is_text() would not take for texts.
WORD_TABLES = [("app/workspace/stages.cpp", "kWords"), ("app/views/orientation_cube.cpp", "kScanner"),
               ("app/widgets/message_log.cpp", "kNames"), ("render/slice_axes.cpp", "kPatient"),
               ("core/pipeline/stage_shares.h", "StageShares")]
TRANSLATES = {"tr", "trf", "trId"}
# Calls that draw what they are given.
DRAWS = set("""Text TextUnformatted TextDisabled TextColored TextWrapped Button SmallButton Checkbox MenuItem BeginMenu Selectable
SetTooltip BulletText heading section sentenceText fact beginRow groupRows confirmLoss paneText paneTitle shadedText mainButton
switchButton wrappedTooltip faintLine InputTextWithHint BeginPopupModal add warn drawAxes cells""".split())
# Calls whose words are for the program: identities, keys, and sentences of errors, which may stay English.
SILENT = set("""Begin BeginChild BeginTable TableSetupColumn BeginPopup OpenPopup PushID beginFields beginCard noteWidget notePlace
noteRect Hasher Error require log InvisibleButton layOutPlot getenv at find value contains system press key command find_if
GetID giveUp setTitle beginPane window_ glfwCreateWindow ImGui_ImplOpenGL3_Init dlsym starts_with ends_with InputText
BeginCombo add_options json root""".split())
TOKEN = re.compile(r'R"\((?:.|\n)*?\)"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\]|\\.)+\'|//[^\n]*|/\*.*?\*/|[()\[\]{};]|#[^\n]*', re.S)
PLACE = re.compile(r"\{[^{}]*\}|%[-+#0-9.*]*[a-z]")


class Literal:
    """A string of the source, its neighbours joined to it; calls: the functions in whose brackets it stands, the innermost last,
    each with the number of the argument."""

    def __init__(self, path, line, text, calls):
        self.path, self.line, self.text, self.calls = path, line, text, calls

    def place(self):
        return f"{self.path.relative_to(ROOT)}:{self.line}: \"{self.text}\""

    def within(self, names):
        return any(name in names for name, _ in self.calls)


def literals(path):
    source = path.read_text(encoding="utf-8")
    calls, found, end = [], [], -1
    for token in TOKEN.finditer(source):
        word = token.group()
        between = source[max(end, 0):token.start()]
        if calls:
            calls[-1][1] += between.count(",")
        if word[0] in "([{":
            before = re.search(r"([A-Za-z_]\w*)\s*$", source[max(0, token.start() - 60):token.start()])
            calls.append([before.group(1) if before and word in "({" else word, 0])
        elif word[0] in ")]}":
            if calls:
                calls.pop()
        elif word[0] == '"':
            text = word[1:-1]
            if found and not between.strip() and found[-1][1] == end:
                found[-1][0].text += text
                found[-1][1] = token.end()
            else:
                line = source.count("\n", 0, token.start()) + 1
                found.append([Literal(path, line, text, [tuple(c) for c in calls]), token.end()])
        if word[0] == '"' or word[:2] not in ("//", "/*"):
            end = token.end()
    return [literal for literal, _ in found]


def has_words(text):
    return bool(re.search(r"[^\W\d_]{2}", PLACE.sub("", text.replace("\\n", " "))))


def is_text(text):
    """Whether a literal looks like something for people: it begins with a capital letter, or has a space between words."""
    bare = PLACE.sub("", text)
    if re.search(r"\.[ot]tf$", text):  # a file
        return False
    return has_words(re.sub("Sonoskin|OpenGL", "", text)) and not text.startswith("#") and bool(re.match(r"\s*[A-Z]", text) or re.search(r"\w[,:;]? +\w", bare))


def is_silent(literal):
    formula = ("Equation", 1) in literal.calls
    return formula or literal.text in NAMES or literal.within(SILENT)


def used():
    """All texts of the window, each with a literal that has it; and what is drawn past tr()."""
    texts, faults = {}, []
    for room in WINDOW:
        for path in sorted((ROOT / "app" / room).glob("*.*")):
            for literal in literals(path):
                wrapped = next((c for c in reversed(literal.calls) if c[0] in TRANSLATES), None)
                if wrapped and (wrapped[0] != "trf" or wrapped[1] == 0):
                    texts.setdefault(literal.text, literal)
                elif literal.calls and literal.calls[-1][0] in DRAWS and is_text(literal.text):
                    faults.append(f"{literal.place()}: is drawn without tr()")
                elif is_text(literal.text) and not is_silent(literal):
                    texts.setdefault(literal.text, literal)
    for name in SHOWN:
        for literal in literals(ROOT / name):
            if is_text(literal.text) and not is_silent(literal):
                texts.setdefault(literal.text, literal)
    return texts, faults


def field_name(name):
    words = re.sub(r"[A-Z]", lambda m: " " + m.group().lower(), name)
    return words[:1].upper() + words[1:]


def capitalised(name):
    return (name[:1].upper() + name[1:]).replace("-", " ")


def add_options(texts):
    """Names and help of parameters, and the names of their choices."""
    for path in sorted(p for pattern in OPTIONS for p in ROOT.glob(pattern)):
        for literal in literals(path):
            if "options.h" in path.name and "enumNames(" in line_of(path, literal.line, 3):
                if has_words(literal.text) and not re.fullmatch(r"u?int\d+|float\d+", literal.text):
                    texts.setdefault(literal.text, literal)
        for match in re.finditer(r'Field\{((?:[^{}"]|"(?:[^"\\]|\\.)*")*)\}', path.read_text(encoding="utf-8")):
            given = [""]
            for text, comma in re.findall(r'"((?:[^"\\]|\\.)*)"(\s*,)?', match.group(1)):
                given[-1] += text
                if comma:
                    given.append("")
            line = path.read_text(encoding="utf-8").count("\n", 0, match.start()) + 1
            for text in (field_name(given[0]), *given[1:3]):
                if text not in NAMES and (re.match("[A-Z].", text) and text != "EV" or " " in text or re.search("[a-z]{4}", text)):
                    texts.setdefault(text, Literal(path, line, text, []))


def line_of(path, line, before):
    return "\n".join(path.read_text(encoding="utf-8").splitlines()[max(0, line - 1 - before):line])


def add_presets(texts):
    for name, kind in PRESETS.items():
        path = ROOT / name
        for match in re.finditer(kind + r'\{\s*"([^"]*)"\s*,\s*((?:"[^"]*"\s*)*)', path.read_text(encoding="utf-8")):
            help_text = "".join(re.findall(r'"([^"]*)"', match.group(2)))
            for text in filter(None, (capitalised(match.group(1)), help_text)):
                texts.setdefault(text, Literal(path, 1, text, []))


# Looks like a text and is none.
NAMES = {"Side", "RAS", "RLAPIS", "US", "CT", "MR", "refined light", "more light", "more keys", "mouse"}


def word_tables(texts):
    """Words without a capital that stand in a table of their own."""
    for name, table in WORD_TABLES:
        path = ROOT / name
        source = path.read_text(encoding="utf-8")
        match = re.search(r"\b" + table + r"\s*(?:\{|=)([^;]*);", source)
        if not match:
            sys.exit(f"{name}: there is no table {table} any more")
        for text in re.findall(r'"((?:[^"\\]|\\.)*)"', match.group(1)):
            if has_words(text):
                texts.setdefault(text, Literal(path, source.count("\n", 0, match.start()) + 1, text, []))


def tables():
    """All entries: the three texts, and where they are."""
    for path in sorted((ROOT / "app/texts").glob("*.cpp")):
        source = path.read_text(encoding="utf-8")
        begin = source.find("const Text kTexts[]")
        if begin < 0:
            continue
        row = re.compile(r"\{" + r",".join([r'((?:\s*"(?:[^"\\]|\\.)*")+)\s*'] * 3) + r"\}")
        for match in row.finditer(source, begin):
            texts = ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', run)) for run in match.groups()]
            yield texts, f"{path.relative_to(ROOT)}:{source.count(chr(10), 0, match.start()) + 1}"


def entry_faults(texts, where):
    english, german, french = texts
    for text in (german, french):
        if not text.strip():
            yield f"{where}: no translation of \"{english}\""
        if PLACE.findall(text) != PLACE.findall(english):
            yield f"{where}: \"{text}\" has other places than \"{english}\""
        if len(text) - len(text.lstrip()) != len(english) - len(english.lstrip()):
            yield f"{where}: \"{text}\" begins otherwise than \"{english}\""
        if "..." in text or "'" in text:
            yield f"{where}: \"{text}\": it is … and ’"
    if re.search(r" [:;?!»]|« ", french):
        yield f"{where}: \"{french}\": no line may break before these marks: put U+00A0 there"


def spoken():
    """Every literal of the program: what an entry may stand for."""
    said = set()
    for layer in ("app", "core", "render"):
        for path in (ROOT / layer).rglob("*.*"):
            if path.suffix in (".h", ".cpp") and "app/texts" not in path.as_posix():
                said.update(literal.text for literal in literals(path))
    return said


def main():
    texts, faults = used()
    word_tables(texts)
    add_options(texts)
    add_presets(texts)
    if "--list" in sys.argv:
        for text, literal in texts.items():
            print(f"{literal.path.relative_to(ROOT)}\t{text}")
    there, said = {}, spoken()
    for entry, where in tables():
        if entry[0] in there:
            faults.append(f"{where}: \"{entry[0]}\" stands in {there[entry[0]]}, too")
        there[entry[0]] = where
        faults += entry_faults(entry, where)
        pieces = {piece for piece in PLACE.split(entry[0]) if len(piece) > 4}
        if entry[0] not in texts and entry[0] not in said and not pieces & said:
            faults.append(f"{where}: nothing uses \"{entry[0]}\"")
    faults += [f"{literal.place()}: is not in app/texts" for text, literal in texts.items() if text not in there]
    print("\n".join(faults) or f"{len(there)} texts in German and French, none missing and none too many")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
