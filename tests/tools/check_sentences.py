#!/usr/bin/env python3
"""check_sentences.py: every error sentence of the readers, writers and commands has one voice: it begins with a capital
letter, a name or an option, ends with a full stop, and says after a semicolon what to do."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CALL = re.compile(r"\b(?:throw Error|Error|require|failOnDisk|fail|refuse|complain)\s*\(")
LITERALS = re.compile(r'"(?:[^"\\]|\\.)*"(?:\s*"(?:[^"\\]|\\.)*")*')


def arguments(text, start):
    """The text from after a bracket to the one that closes it."""
    depth, at = 1, start
    while depth and at < len(text):
        string = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'').match(text, at)
        if string:
            at = string.end()
            continue
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return text[start:at - 1]


def sentences(text):
    for call in CALL.finditer(text):
        found = ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', run))
                 for run in LITERALS.findall(arguments(text, call.end()))]
        sentence = max(found, key=len, default="")
        if " " in sentence:  # a word alone is passed on to a sentence
            yield text[:call.start()].count("\n") + 1, sentence.replace('\\"', '"')


def wrong(sentence):
    if not re.match(r'[A-Z{"-]', sentence):
        return "does not begin like a sentence"
    passes_on = re.search(r"\{\}\.?$", sentence)  # what ends it says what to do
    if not sentence.endswith(".") and not passes_on:
        return "has no full stop"
    if ";" not in sentence and not passes_on:
        return "does not say after a semicolon what to do"
    return None


def main():
    rooms = ["core/io", "core/io/dicom", "core/io/headers", "core/io/meshes", "core/io/scanners", "app/batch",
             "app/cli", "app/document", "app/window", "app/workspace"]
    files = [*(file for room in rooms for file in ROOT.glob(room + "/*.cpp")),
             ROOT / "core/base/error_text.cpp"]
    faults, count = [], 0
    for file in sorted(files):
        for line, sentence in sentences(file.read_text(encoding="utf-8")):
            count += 1
            if reason := wrong(sentence):
                faults.append(f"{file.relative_to(ROOT)}:{line}: {reason}: {sentence}")
    print("\n".join(faults) if faults else f"{count} sentences are of one voice")
    return 1 if faults or count < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
