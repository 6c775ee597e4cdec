"""What the sources can say in a ``ClonerError``: every text its message and hint can be, with places for values."""

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
PLACE = "\N{WHITE SQUARE}"


def sentences(path):
    """Return the texts of all errors that a source file raises, as (line, text); values are `PLACE`."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    found = []
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "ClonerError":
            around = [f for f in functions if f.lineno <= call.lineno <= f.end_lineno]
            for argument in call.args[:2]:
                found += [(call.lineno, text) for text in texts_of(argument, tree, around)]
    return found


def texts_of(node, tree, around, depth=0):
    """Return every text that an expression can be, as far as its own file says."""
    if depth > 6:
        return []
    if isinstance(node, ast.Constant):
        return [node.value] if isinstance(node.value, str) and node.value else []
    if isinstance(node, ast.IfExp):
        return [one for part in (node.body, node.orelse) for one in texts_of(part, tree, around, depth + 1)]
    if isinstance(node, ast.JoinedStr):
        return ["".join(part.value if isinstance(part, ast.Constant) else PLACE for part in node.values)]
    if isinstance(node, ast.Name):
        return [one for value in values_of(node.id, tree, around) for one in texts_of(value, tree, around, depth + 1)]
    if isinstance(node, ast.Call):
        return returned(node, tree, depth)
    return []


def values_of(name, tree, around):
    """Return the expressions that a name is bound to, in the function around or else in the file."""
    for scope in (*around[::-1], tree):
        own = scope.body if scope is tree else list(ast.walk(scope))
        bound = [(node.targets if isinstance(node, ast.Assign) else [node.target], node.value)
                 for node in own if isinstance(node, ast.Assign | ast.AnnAssign)]  # fmt: skip
        found = [value for targets, value in bound if any(getattr(one, "id", "") == name for one in targets)]
        if found:
            return found
    return []


def returned(call, tree, depth):
    """Return the texts that a call of a function of the same file can give; a table's functions are all tried."""
    named = {node.id for node in ast.walk(call.func) if isinstance(node, ast.Name)}
    if isinstance(call.func, ast.Call | ast.Subscript) or "checks" in named:
        named |= {f.name for f in ast.walk(tree) if isinstance(f, ast.FunctionDef) and f.name.startswith("_trouble")}
    found = []
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef) and function.name in named:
            for node in ast.walk(function):
                if isinstance(node, ast.Return) and node.value is not None:
                    found += texts_of(node.value, tree, [function], depth + 1)
    return found
