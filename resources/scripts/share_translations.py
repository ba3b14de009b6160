#!/usr/bin/env python3
"""share_translations.py [FOLDER]

Keeps one translation of one text. In viscera_*.ts, which lupdate makes, each class of the window has its own translations.
The window looks up what its class does not translate in the contexts of names_*.ts (app/window/style/language.cpp). This script
  - removes what has no words and is the same in every language: "%1 ml", "Ctrl+K", "stress.csv";
  - removes from viscera_*.ts what names_*.ts translates to the same, or what is not translated yet and stands there;
  - moves what two classes translate to the same into the context "viscera::app" of names_*.ts.
It changes all four languages alike, and prints how many texts it removed. FOLDER is resources/translations by default.
"""
import collections
import pathlib
import re
import sys

LANGUAGES = ["ca", "de", "es", "fr"]
SHARED, NUMERICAL = "viscera::app", "viscera::presentation"
CONTEXT = re.compile(r"<context>\n    <name>([^<]*)</name>\n(.*?)</context>\n", re.S)
MESSAGE = re.compile(r"    <message[^>]*>.*?</message>\n", re.S)


class Message:
    def __init__(self, context, block):
        self.context, self.block = context, block
        self.source = re.search(r"<source>(.*?)</source>", block, re.S)[1]
        self.key = (context, self.source, "".join(re.findall(r"<comment>.*?</comment>", block, re.S)))
        self.translation = re.search(r"<translation.*?(</translation>|/>)", block, re.S)[0]
        self.unfinished = 'type="unfinished"' in self.translation
        # Of a message with a number, the forms alone are compared.
        self.words = re.sub(r"\s*(</?translation[^>]*>|</?numerusform>)\s*", "|", self.translation)


def messages_of(text):
    return [Message(name, block) for name, body in CONTEXT.findall(text) for block in MESSAGE.findall(body)]


def has_words(source):
    """As hasWords in tests/gui/words.h: a text of places, numbers, units, keys or a file's name has none."""
    if re.fullmatch(r"/?[a-z]+(\.[a-z0-9]+)+", source):
        return False
    rest = re.sub(r"%n|%\d|((Ctrl|Alt|Shift)\+)+\S|\b(ml|mm|ms|min)\b", "", source)
    return re.search(r"[^\W\d_]{2,}", rest) is not None


def wordless(messages):
    """Keys of what has no words, and no translation that differs."""
    return {key for key in messages["de"] if not has_words(key[1]) and ("%" in key[1] or key[0] != NUMERICAL) and key[0] != "Lesson"
            and all(messages[l][key].unfinished or messages[l][key].words == f"|{key[1]}|" for l in LANGUAGES if key in messages[l])}


def redundant(window, names):
    """Keys of the window's messages that can go, and keys of those to keep as shared ones."""
    known = collections.defaultdict(list)  # Source -> by each language what names_*.ts say.
    for context in (SHARED, NUMERICAL):
        for key in names["de"]:
            if key[0] == context:
                known[key[1]].append([names[language][key].words for language in LANGUAGES if key in names[language]])
    by_source = collections.defaultdict(list)
    for key in window["de"]:
        if key[0].startswith("viscera::") and not key[2] and all(key in window[language] for language in LANGUAGES):
            by_source[key[1]].append(key)
    gone, shared = [], []
    for source, keys in by_source.items():
        said = {key: [window[language][key].words for language in LANGUAGES] for key in keys}
        if known[source]:
            first = known[source][0]
            gone += [key for key in keys if said[key] == first or all(window[l][key].unfinished for l in LANGUAGES)]
            continue
        finished = [key for key in keys if not any(window[language][key].unfinished for language in LANGUAGES)]
        counts = collections.Counter(tuple(said[key]) for key in finished).most_common(1)
        if counts and counts[0][1] > 1:
            same = [key for key in finished if tuple(said[key]) == counts[0][0]]
            shared.append(same[0])
            gone += same + [key for key in keys if key not in finished]
    return set(gone), shared


def without(text, gone):
    def kept(found):
        body = MESSAGE.sub(lambda m: "" if Message(found[1], m[0]).key in gone else m[0], found[2])
        return f"<context>\n    <name>{found[1]}</name>\n{body}</context>\n" if MESSAGE.search(body) else ""
    return CONTEXT.sub(kept, text)


def with_shared(text, blocks):
    if not blocks:
        return text
    head = f"<context>\n    <name>{SHARED}</name>\n"
    if head in text:
        return text.replace(head, head + "".join(blocks))
    return text.replace("</TS>", head + "".join(blocks) + "</context>\n</TS>")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1] / "translations")
    files = {kind: {language: folder / f"{kind}_{language}.ts" for language in LANGUAGES} for kind in ("viscera", "names")}
    texts = {kind: {language: file.read_text(encoding="utf-8") for language, file in by.items()} for kind, by in files.items()}
    window, names = ({language: {m.key: m for m in messages_of(text)} for language, text in texts[kind].items()}
                     for kind in ("viscera", "names"))
    gone, shared = redundant(window, names)
    gone |= wordless(window)
    shared = [key for key in shared if has_words(key[1])]
    common = wordless(names)
    for language in LANGUAGES:
        blocks = [window[language][key].block for key in shared]
        files["viscera"][language].write_text(without(texts["viscera"][language], gone), encoding="utf-8")
        files["names"][language].write_text(with_shared(without(texts["names"][language], common), blocks), encoding="utf-8")
    print(f"{len(gone) + len(common)} texts removed, {len(shared)} of them shared now")


main()
