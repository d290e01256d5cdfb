#!/usr/bin/env python3
"""Checks that no two places of include/ and src/ define a class, struct, union or enum of the same qualified name.

Two such types in one program break the one-definition rule: a translation unit may run the destructor or the comparison
of the other one's type, and no compiler or linker says so. Types in anonymous namespaces and inside functions cannot
meet and are left out; declarations without a body are no definitions.
"""

import collections
import dataclasses
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

TOKEN = re.compile(
    r"""
    (?P<skip> \s+ | //(?:[^\n\\]|\\.|\\\n)*                       # white space, line comments
      | /\*.*?\*/                                                 # block comments
      | (?m:^)[ \t]*\#(?:[^\n\\]|\\\n|\\.)*                       # preprocessor lines with their continuations
      | (?<![A-Za-z0-9_])(?:u8|u|U|L)?R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)"   # raw strings
      | (?<=[0-9A-Fa-f])'(?=[0-9A-Fa-f])                          # digit separators
      | '(?:[^'\\\n]|\\.)*' )
  | (?P<text> "(?:[^"\\\n]|\\.)*" )
  | (?P<token> [A-Za-z_]\w* | [0-9][\w.]* | :: | -> | <=> | <= | >= | == | \[\[ | \]\] | . )
    """,
    re.VERBOSE | re.DOTALL,
)
CLOSING = {"(": ")", "{": "}", "[": "]", "[[": "]]"}
TYPE_KEYS = {"class", "struct", "union", "enum"}


@dataclasses.dataclass
class Token:
    text: str
    line: int


@dataclasses.dataclass
class Scope:
    kind: str  # "namespace", "type" or "other": a function body, an initialiser
    name: str = ""  # with "::"; empty for one that is transparent (extern "C")
    hidden: bool = False  # in an anonymous namespace or in a function


def tokens_of(text: str) -> list[Token]:
    found, line = [], 1
    for match in TOKEN.finditer(text):
        if match.lastgroup == "token":
            found.append(Token(match["token"], line))
        elif match["text"] is not None:
            found.append(Token('""', line))
        line += match[0].count("\n")
    return found


class Scanner:
    """Finds the definitions of one file, by the nesting of its braces."""

    def __init__(self, text: str):
        self.tokens = tokens_of(text)
        self.at = 0
        self.scopes: list[Scope] = []
        self.found: list[tuple[str, int]] = []

    def peek(self, offset: int = 0) -> str:
        place = self.at + offset
        return self.tokens[place].text if 0 <= place < len(self.tokens) else ""

    def skip_balanced(self) -> None:
        """From an opening bracket to behind the one that closes it."""
        opening, closing, depth = self.peek(), CLOSING[self.peek()], 0
        while self.at < len(self.tokens):
            depth += (self.peek() == opening) - (self.peek() == closing)
            self.at += 1
            if depth == 0:
                return

    def angle_text(self) -> str:
        """From "<" to behind the ">" that closes it; its text."""
        first, depth = self.at, 0
        while self.at < len(self.tokens):
            if self.peek() in CLOSING:
                self.skip_balanced()
                continue
            depth += (self.peek() == "<") - (self.peek() == ">")
            self.at += 1
            if depth == 0:
                break
        return " ".join(token.text for token in self.tokens[first : self.at])

    def skip_attributes(self) -> None:
        while self.peek() == "[[" or (self.peek() in ("alignas", "__attribute__") and self.peek(1) == "("):
            self.at += 0 if self.peek() == "[[" else 1
            self.skip_balanced()

    def qualified_name(self) -> str:
        """A::B<C>, as far as it goes; template arguments belong to the name of a specialisation."""
        parts = []
        while re.match(r"[A-Za-z_]", self.peek()) and self.peek() not in ("final", "inline"):
            part = self.peek()
            self.at += 1
            if self.peek() == "<":
                part += self.angle_text()
            parts.append(part)
            if self.peek() != "::":
                break
            self.at += 1
            if self.peek() == "inline":  # namespace a::inline b
                self.at += 1
        return "::".join(parts)

    def is_hidden(self) -> bool:
        return bool(self.scopes) and self.scopes[-1].hidden

    def enter(self, scope: Scope) -> None:
        scope.hidden = scope.hidden or self.is_hidden()
        self.scopes.append(scope)
        self.at += 1  # the brace

    def namespace(self) -> None:
        self.at += 1
        self.skip_attributes()
        name = self.qualified_name()
        self.skip_attributes()
        if self.peek() == "{":
            self.enter(Scope("namespace", name, hidden=not name))

    def type(self) -> None:
        line, is_enum = self.tokens[self.at].line, self.peek() == "enum"
        self.at += 1
        if is_enum and self.peek() in ("class", "struct"):
            self.at += 1
        self.skip_attributes()
        name = self.qualified_name()
        if self.peek() == "final":
            self.at += 1
        if self.peek() == ":" and (name or is_enum):  # bases, or the type under an enumeration
            while self.peek() not in ("{", ";", ""):
                self.at += 1
        if self.peek() != "{":
            return  # a declaration, or a type named in passing
        if name and not self.is_hidden():
            self.found.append(("::".join([s.name for s in self.scopes if s.name] + [name]), line))
        self.enter(Scope("type", name or f"(unnamed, line {line})"))

    def scan(self) -> list[tuple[str, int]]:
        while self.at < len(self.tokens):
            token, before = self.peek(), self.peek(-1)
            if token == "template" and self.peek(1) == "<":
                self.at += 1
                self.angle_text()
            elif token == "namespace" and before != "using":
                self.namespace()
            elif token in TYPE_KEYS:
                self.type()
            elif token == "{" and before == '""' and self.peek(-2) == "extern":
                self.enter(Scope("namespace"))
            elif token == "{":
                self.enter(Scope("other", hidden=True))
            else:
                if token == "}" and self.scopes:
                    self.scopes.pop()
                self.at += 1
        return self.found


def duplicates(files: dict[str, str]) -> list[str]:
    places = collections.defaultdict(list)
    for path, text in files.items():
        for name, line in Scanner(text).scan():
            places[name].append(f"{path}:{line}")
    return [f"{name} is defined in {', '.join(where)}" for name, where in sorted(places.items()) if len(where) > 1]


# Each sample: files, and the names that are defined twice in them.
SAMPLES = [
    ({"a.hpp": "namespace a::b { struct Twin { int x; }; }", "b.cpp": "namespace a { namespace b {\nclass Twin final {};\n} }"},
     ["a::b::Twin is defined in a.hpp:1, b.cpp:2"]),
    ({"a.hpp": "namespace a { enum class Twin : int { x }; }", "b.hpp": "namespace a { struct [[nodiscard]] Twin : Base<int> {}; }"},
     ["a::Twin is defined in a.hpp:1, b.hpp:1"]),
    ({"a.hpp": "struct Outer { struct Twin; class Twin2 {}; };", "b.cpp": "struct Outer::Twin {};", "c.cpp": "struct Outer::Twin {};"},
     ["Outer::Twin is defined in b.cpp:1, c.cpp:1"]),
    ({"a.hpp": "template <class T, template <class> class U = X> struct Twin {};", "b.hpp": "template <typename T> class Twin {};"},
     ["Twin is defined in a.hpp:1, b.hpp:1"]),
    ({"a.hpp": 'extern "C" { struct Twin { int x; }; }', "b.cpp": "struct Twin\n{\n};"}, ["Twin is defined in a.hpp:1, b.cpp:1"]),
    ({"a.hpp": "namespace a { int f() { return 1; } const auto text = R\"x(})x\"; auto c = '{'; int n = 1'000; // {\n"
               "#define OPEN {\n/* { */ struct Twin {}; }", "b.hpp": "namespace a { struct Twin {}; }"},
     ["a::Twin is defined in a.hpp:3, b.hpp:1"]),
    # What must not be taken for a duplicate:
    ({"a.cpp": "namespace a { namespace { struct Own { struct Inner {}; }; } }", "b.cpp": "namespace a { namespace { struct Own {}; } }"}, []),
    ({"a.hpp": "namespace a { struct Known; class Known; enum class Known2 : int; }", "b.hpp": "namespace a { struct Known {}; enum class Known2 : int {}; }"}, []),
    ({"a.hpp": "struct A { struct Part {}; };", "b.hpp": "struct B { struct Part {}; }; namespace n { struct A {}; }"}, []),
    ({"a.hpp": "template <class T> struct S {}; template <> struct S<int> {};", "b.hpp": "template <class T> struct S<T*> {};"}, []),
    ({"a.cpp": "void f() { struct Local {}; }", "b.cpp": "void g() { struct Local {}; auto h = [] { class Local {}; }; }"}, []),
    ({"a.cpp": "struct tm now() { return {}; } struct tm later = {}; using namespace n; namespace m = n::o;", "b.cpp": "struct tm then() { return {}; }"}, []),
    ({"a.hpp": "struct { int x; } one; enum { p }; friend class F;", "b.hpp": "struct { int x; } two; enum { q };"}, []),
]


def self_check() -> list[str]:
    return [f"sample {i + 1}: found {duplicates(files)}, expected {expected}"
            for i, (files, expected) in enumerate(SAMPLES) if duplicates(files) != expected]


def main() -> int:
    faults = self_check()
    if faults:
        print("the check itself is wrong:\n" + "\n".join(faults))
        return 1
    files = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
             for folder in ("include", "src") for path in sorted((ROOT / folder).rglob("*.?pp"))}
    faults = duplicates(files)
    count = sum(len(Scanner(text).scan()) for text in files.values())
    print("\n".join(faults) if faults else f"{count} types in {len(files)} files, each defined once")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
