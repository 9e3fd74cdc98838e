"""A page for each case of `ancf stability`, from docs/results/stability.json and the sources of the study."""

import json
import re
from pathlib import Path

FIELDS = ("name", "parameter", "unit", "reference", "right")
CASE = re.compile(r"\bCase\s*\{(.*?)\btrials\b", re.S)
STRING = r'"((?:[^"\\]|\\.)*)"'


def rust_text(literal: str) -> str:
    """Value of a string of Rust: a backslash at a line's end takes the spaces that follow with it."""
    joined = re.sub(r"\\\n\s*", "", literal)
    return joined.replace('\\"', '"').replace("\\\\", "\\")


def derivations(study: Path) -> dict[str, dict[str, str]]:
    """Texts of each case, as the study's sources have them, with their file."""
    found = {}
    for file in sorted(study.glob("*.rs")):
        for body in CASE.findall(file.read_text(encoding="utf-8")):
            texts = {field: rust_text(match[1]) for field in FIELDS if (match := re.search(rf"\b{field}:\s*{STRING}", body, re.S))}
            if "name" in texts:
                found[texts["name"]] = texts | {"file": file.name}
    return found


def number(value: float) -> str:
    """A number as it can be read."""
    mantissa, _, exponent = f"{value:.2g}".partition("e")
    return f"{mantissa}·10{str(int(exponent)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}" if exponent else mantissa


def sentence(text: str) -> str:
    return text[:1].upper() + text[1:].rstrip(".") + "."


def case_page(name: str, case: dict, texts: dict[str, str]) -> str:
    """Markdown of a case."""
    counts = case["counts"]
    lines = [f"# {name}", "", f"Swept: {case['parameter']}. Unit of the error: {case['unit']}.", "",
             f"**Reference.** {sentence(case['reference'])}", "",
             f"**Right.** {sentence(texts['right'])}", ""]
    lines += ["| verdict | rows | values of the parameter |", "|---|---|---|"]
    for verdict in ("right", "right with warning", "refused", "WRONG"):
        values = ", ".join(map(number, case["values"].get(verdict, []))) or "–"
        lines.append(f"| {verdict} | {counts[verdict]} | {values} |")
    lines += ["", f"{counts['~']} rows have a bound of more than a hundredth of what is measured: they show little." if counts["~"] else
              "Every bound is below a hundredth of what is measured.", ""]
    nearest = case.get("nearest")
    if nearest:
        lines += [f"The error nearest to its bound: {number(nearest['error'])} of {number(nearest['bound'])} {case['unit']} "
                  f"({nearest['variant']}, at {number(nearest['value'])}).", ""]
    lines += [f"`ancf stability` writes every row of it into `out/stability.html`. Its source is `study/src/stability/{texts['file']}`. [All cases](../stability.md)."]
    return "\n".join(lines) + "\n"


def case_pages(root: Path) -> dict[str, str]:
    """Pages of all cases by name."""
    results = json.loads((root / "docs/results/stability.json").read_text(encoding="utf-8"))
    texts = derivations(root / "study/src/stability")
    for name in results["cases"]:
        if not texts.get(name, {}).get("right"):
            raise SystemExit(f"docs/results/stability.json has the case {name}, study/src/stability/ has none with `right` of that name; "
                             "run `ancf stability`, then python3 docs/numbers.py --take stability out")
    return {name: case_page(name, case, texts[name]) for name, case in results["cases"].items()}
