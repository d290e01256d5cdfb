#!/usr/bin/env python3
"""Writes what follows from the rows of numbers (docs/architecture.md): blocks of configs/schemas, tables of docs, keywords of
the Python package. Usage: scripts/generate.py [--check] PRINT_ROWS, the program print_rows of the build's tests; --check
writes nothing, and fails where something would change."""

import json
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH = 120
# Block of a study, and the rows of which it is.
BLOCKS = {"gripper": "grip", "crawler": "crawl", "driver": "driver"}
COMMENT = {"comment": {"type": "string"}}
PLAIN_UNITS = ("Hz", "V", "A", "Ohm")  # of SI, without a sign of division: a keyword does without them
OTHER_KEYWORDS = {"mean_A"}  # mean_current, by hand
MAY_BE_NONE = {"coil_temperature_degC"}


def json_text(value, indent=0, used=0):
    """JSON with a number's rule on one line, and whatever fits."""
    line = json.dumps(value, ensure_ascii=False)
    below = list(value.values()) if isinstance(value, dict) else value if isinstance(value, list) else []
    is_rule = isinstance(value, dict) and not any(
        isinstance(each, dict) or isinstance(each, list) and any(isinstance(one, (dict, list)) for one in each)
        for each in below)
    if not below or is_rule or indent + used + len(line) <= WIDTH:
        return line
    inner = indent + 2
    if isinstance(value, list) and not any(isinstance(each, (dict, list)) for each in value):
        body = textwrap.fill(", ".join(map(json.dumps, value)), WIDTH - inner, break_long_words=False)
        return f"[\n{textwrap.indent(body, ' ' * inner)}\n{' ' * indent}]"
    names = [f"{json.dumps(key)}: " for key in value] if isinstance(value, dict) else [""] * len(value)
    lines = [" " * inner + name + json_text(each, inner, len(name) + 1) for name, each in zip(names, below)]
    begin, end = "{}" if isinstance(value, dict) else "[]"
    return f"{begin}\n" + ",\n".join(lines) + f"\n{' ' * indent}{end}"


def range_of(rule, block):
    """What a variable of a study may be that is a number of a block."""
    bounds = {key: rule[key] for key in ("minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum") if key in rule}
    return {"description": f"{rule['description'].rstrip('.')}, with the block {block}.", "$ref": "#/$defs/range",
            "properties": {"lower": bounds, "upper": bounds, "values": {"items": bounds}}}


def references(value):
    """What a schema refers to within itself."""
    if isinstance(value, dict):
        return {value["$ref"]} if "$ref" in value and len(value) == 1 else set().union(
            {value.get("$ref")}, *map(references, value.values()))
    return set().union(*map(references, value)) if isinstance(value, list) else set()


def study_schema(schema, rows):
    variables = schema["properties"]["variables"]["properties"]
    # Of the current it says more ways than a number, and poses that follow from the objectives.
    point = schema["properties"]["operating_point"]["properties"]
    for key, rule in rows["operating_point"]["properties"].items():
        if key != "cases":
            point[key] = rule
    for name in [name for name in variables if name.split("_")[0] in BLOCKS]:
        del variables[name]
    for block, name in BLOCKS.items():
        described = rows[name]
        at = schema["properties"][block]
        at["properties"] = {**COMMENT, **described["properties"]}
        # A height is needed by some shapes, which the block says itself.
        at["required"] = [key for key in described["required"] if key != "height_mm"]
        for key, rule in described["properties"].items():
            if rule.get("type") == "number" and key not in described["fixed"]:
                variables[f"{block}_{key}"] = range_of(rule, block)
    return without_unused(schema)


def with_numbers(at, *described):
    """Writes the numbers of an object into its schema, before what it has besides."""
    numbers = {key: rule for each in described for key, rule in each["properties"].items()}
    others = {key: rule for key, rule in at["properties"].items() if key not in numbers and key != "comment"}
    at["properties"] = {**COMMENT, **numbers, **others}
    required = [key for each in described for key in each["required"]]
    if required:
        at["required"] = required


def without_unused(schema):
    used = references(schema)
    if "$defs" in schema:
        schema["$defs"] = {key: rule for key, rule in schema["$defs"].items() if f"#/$defs/{key}" in used}
    return schema


def actuator_schema(schema, rows):
    sections = schema["properties"]
    for parameter in rows["parameters"]:
        # What a section says of a number in words, and whether it has a default, is the schema's own.
        at, key = sections[parameter["section"]]["properties"], parameter["key"]
        rule = {**parameter["rule"], "description": at[key]["description"]}
        if "default" not in at[key]:
            rule.pop("default", None)
        at[key] = rule
    with_numbers(sections["model"], rows["model"])
    with_numbers(sections["operating_point"], rows["operating_point"])
    with_numbers(sections["measured"], rows["measured"])
    with_numbers(sections["calibration"]["properties"]["hinge_reference"], rows["hinge_reference"])
    return without_unused(schema)


def lumped_model_schema(schema, rows):
    with_numbers(schema["properties"]["links"]["items"], rows["link"])
    joint = schema["properties"]["joints"]["items"]
    with_numbers(joint, rows["joint"], rows["rotor"])
    with_numbers(joint["properties"]["contact"]["oneOf"][1], rows["contact"])
    with_numbers(schema["$defs"]["coil"], rows["coil"])
    with_numbers(schema["$defs"]["magnet"], rows["magnet"])
    return without_unused(schema)


def sentence(text):
    return text[0].upper() + text[1:] + "."


def effect_schema(effect):
    properties = {key: {**rule, "description": sentence(rule["description"].rstrip("."))}
                  for key, rule in effect["properties"].items()}
    numbers = {"type": "object", "properties": {**COMMENT, **properties}}
    further = [key for key in effect["properties"] if key not in effect["required"]]
    if len(further) > 1:
        numbers["dependentRequired"] = {key: [other for other in further if other != key] for key in further}
    if effect["required"]:
        numbers["required"] = effect["required"]
    numbers["additionalProperties"] = False
    return {"title": effect["id"], "description": sentence(effect["description"]),
            "properties": {**COMMENT, "id": {"const": effect["id"]}, "parameters": numbers},
            "required": ["id", "parameters"] if effect["required"] else ["id"], "additionalProperties": False}


def effects_schema(_, rows):
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "effects of an actuator",
            "description": "What a model has that its stages do not say: the key \"effects\" of an actuator/1 and of a "
                           "lumped-model/1. Each id once, with all its parameters.",
            "type": "array", "maxItems": len(rows["effects"]),
            "items": {"type": "object", "oneOf": [effect_schema(each) for each in rows["effects"]]}}


def default_of(rule):
    return json.dumps(rule["default"]) if "default" in rule else None


def keyword(key, rule, required):
    """The keyword of a key with its type and default."""
    plain = next((unit for unit in PLAIN_UNITS if key.endswith("_" + unit) and "_" not in unit), None)
    name = key.removesuffix(f"_{plain}") if plain else key
    kind = "str" if "enum" in rule else "int" if rule["type"] == "integer" else "float"
    if required:
        return f"{name}: {kind}"
    usual = default_of(rule)
    if usual is None:
        return f"{name}: Optional[{kind}] = None"
    usual = str(float(usual)) if kind == "float" else usual
    return f"{name}: {kind if key not in MAY_BE_NONE else f'Optional[{kind}]'} = {usual}"


def python_keywords(text, rows):
    def signature(match):
        head, name = match.group(1), match.group(2)
        described = rows[name]
        required = [key for key in described["required"] if key != "height_mm"]
        words = [keyword(key, rule, key in required) for key, rule in described["properties"].items()
                 if key not in OTHER_KEYWORDS]
        indent = " " * len(f"def {name}(")
        body = textwrap.fill(", ".join(each.replace(" ", "\0") for each in words), WIDTH, initial_indent=indent,
                             subsequent_indent=indent, break_long_words=False).replace("\0", " ")
        return f"{head}\n{body}) -> dict[str, Any]:"
    return re.sub(r"(def (\w+)\(actuator: Actuator, [^\n#]*# rows:)\n(?:.*\n)*?.*\) -> dict\[str, Any\]:", signature, text)


def table(described):
    lines = ["| key | default | rule, meaning |", "|---|---|---|"]
    for key, rule in described["properties"].items():
        usual = "required" if key in described["required"] else default_of(rule) or ""
        if "enum" in rule:
            bounds = ""
        elif "exclusiveMinimum" in rule:
            bounds = f"> {rule['exclusiveMinimum']}, at most {rule['maximum']}; "
        else:
            bounds = f"{rule['minimum']} to {rule['maximum']}; "
        meaning = rule["description"].rstrip(".")
        lines.append(f"| `{key}` | {usual} | {bounds}{meaning[0].lower() + meaning[1:] if bounds else meaning} |")
    return "\n".join(lines)


def documented(text, rows):
    return re.sub(r"(<!-- rows: (\w+) -->\n)(?:\|.*\n)*",
                  lambda match: match.group(1) + table(rows[match.group(2)]) + "\n", text)


def main():
    *options, program = sys.argv[1:]
    rows = json.loads(subprocess.run([program], check=True, capture_output=True, text=True).stdout,
                      parse_float=lambda digits: int(float(digits)) if float(digits).is_integer() else float(digits))
    makers = {
        **{f"configs/schemas/{name}.schema.json":
           lambda text, make=make: json_text(make(json.loads(text), rows)) + "\n"
           for name, make in {"actuator": actuator_schema, "effects": effects_schema, "lumped-model": lumped_model_schema,
                              "study": study_schema}.items()},
        "docs/formats-study.md": lambda text: documented(text, rows),
        "src/python/coilwright/_systems.py": lambda text: python_keywords(text, rows),
    }
    stale = []
    for name, make in makers.items():
        path = ROOT / name
        before = path.read_text(encoding="utf-8")
        after = make(before)
        if after != before:
            stale.append(name)
            if "--check" not in options:
                path.write_text(after, encoding="utf-8")
    if stale and "--check" in options:
        sys.exit(f"{', '.join(stale)}: must follow from the rows: run scripts/generate.py {program}")


if __name__ == "__main__":
    main()
