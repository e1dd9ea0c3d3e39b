"""The page of a comparison, report.html: one file with its pictures inside, made of results.json.

Every figure stands in a <data> element whose `value` says where in results.json it comes from, so that a test can
compute each again.
"""
import base64
import html

STYLE = """body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0;font-size:13px}td,th{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:right}
td:first-child,th:first-child{text-align:left}th{border-bottom:2px solid #888}img{max-width:100%}.best{font-weight:bold}
code{background:#f3f3f3;padding:.1em .3em;overflow-wrap:anywhere}.same{color:#777}caption{text-align:left;color:#555}"""
LEVEL = 0.05


def figure(value, key, digits=".3f"):
    if value is None:
        return "–"
    return f'<data value="{html.escape(key)}">{value:{digits}}</data>'


def metric_text(cell, name, index):
    estimate = cell["metrics"].get(name)
    if estimate is None:
        return "–"
    text = figure(estimate["mean"], f"cells/{index}/metrics/{name}/mean")
    if estimate["ci95"] is not None:
        text += " ± " + figure(estimate["ci95"], f"cells/{index}/metrics/{name}/ci95")
    return text


def best_of(cells, name, more):
    means = {cell["method"]: cell["metrics"][name]["mean"] for _, cell in cells if name in cell["metrics"]}
    if not means:
        return set()
    best = max(means.values()) if more else min(means.values())
    return {method for method, mean in means.items() if mean == best}


def table_of_scene(results, scene):
    cells = [(i, cell) for i, cell in enumerate(results["cells"]) if cell["parameters"]["scene"] == scene]
    lines = ["<table><caption>Mean over runs ± half width of its 95 % interval (Student's t); bold: the best mean."
             "</caption><tr><th></th>" + "".join(f"<th>{html.escape(cell['method'])}</th>" for _, cell in cells) + "</tr>"]
    for name, column in results["columns"].items():
        best = best_of(cells, name, column["better"] == "more") if column["tested"] else set()
        unit = "" if column["unit"] == "1" else f" [{column['unit']}]"
        row = "".join(f'<td class="{"best" if cell["method"] in best else ""}">{metric_text(cell, name, i)}</td>'
                      for i, cell in cells)
        lines.append(f"<tr><td>{name}{unit}</td>{row}</tr>")
    shares = "".join("<td>" + figure(cell["nees_in_bounds"], f"cells/{i}/nees_in_bounds") + "</td>" for i, cell in cells)
    lines.append(f"<tr><td>share of scans with NEES in bounds</td>{shares}</tr></table>")
    return "\n".join(lines)


def verdict(test, column):
    if test["p_holm"] is None or test["p_holm"] >= LEVEL:
        return '<span class="same">no difference shown</span>'
    first_less = test["difference"] < 0
    better = test["first"] if first_less == (column["better"] == "less") else test["second"]
    return f"{html.escape(better)} is better"


def tests_of_scene(results, scene):
    lines = ["<table><caption>First minus second on the same seeds.</caption><tr><th></th><th>first</th><th>second</th>"
             "<th>runs</th><th>difference</th><th>effect</th><th>t</th><th>p</th><th>p, corrected</th><th></th></tr>"]
    for i, test in enumerate(results["tests"]):
        if test["scene"] != scene:
            continue
        key = f"tests/{i}/"
        difference = figure(test["difference"], key + "difference")
        if test["ci95"] is not None:
            difference += " ± " + figure(test["ci95"], key + "ci95")
        numbers = [figure(test["runs"], key + "runs", "d"), difference, figure(test["effect"], key + "effect", ".2f"),
                   figure(test["t"], key + "t", ".2f"), figure(test["p"], key + "p", ".2g"),
                   figure(test["p_holm"], key + "p_holm", ".2g"), verdict(test, results["columns"][test["metric"]])]
        cells = "".join(f"<td>{text}</td>" for text in numbers)
        lines.append(f"<tr><td>{test['metric']}</td><td>{html.escape(test['first'])}</td>"
                     f"<td>{html.escape(test['second'])}</td>{cells}</tr>")
    return "\n".join(lines + ["</table>"])


def picture(directory, scene):
    path = directory / (scene.replace("/", "_") + ".png")
    if not path.exists():
        return "<p>No picture: python3-matplotlib draws it.</p>"
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{html.escape(scene)} over time" src="data:image/png;base64,{data}">'


def heading(results):
    score = results["score"]
    inputs = "".join(f"<li><code>{html.escape(path)}</code>, digest {digest}</li>"
                     for path, digest in results["inputs"].items())
    title = f"Values of {results['parameter']}" if results["parameter"] else "Comparison of " + ", ".join(results["methods"])
    return f"""<h1>{html.escape(title)}</h1>
<p>Command: <code>{html.escape(results["command"])}</code></p>
<p>Commit {html.escape(results["commit"])}; seed {results["seed"]}, from which run k of 0 to {results["runs"] - 1} derives its own, the same
for all methods. Cut-off {score["cutoff"]:g} m, order {score["order"]:g}, truth {score["truth"]}, OSPA(2) over {score["window_s"]:g} s,
{score["switch_penalty"]:g} m a change of track in T-GOSPA. Files read:</p><ul>{inputs}</ul>
<p>Everything below is computed from <code>curves.csv</code>. Processor times are measured and differ from machine to machine: they
stand in <code>times.csv</code>.</p>"""


def meanings(results):
    rows = "".join(f"<tr><td>{name}</td><td>{column['over_scans'].replace('_', ' ')}</td><td>{html.escape(column['meaning'])}</td></tr>"
                   for name, column in results["columns"].items())
    return f"""<h2>What is measured</h2><table><tr><th></th><th>over the scans of a run</th><th></th></tr>{rows}</table>
<p>Tests are Student's t on the differences of runs with one seed; effect is their mean over their standard deviation; p is corrected
by Holm's method for all {len(results["tests"])} tests of this page, so that the chance of any false "is better" is at most {LEVEL:g}.
NEES of consistent tracks is 1; its bounds hold 95 % of the means over runs.</p>"""


def write(directory, results):
    """Writes report.html beside results.json."""
    parts = [f'<!DOCTYPE html>\n<html lang="en"><meta charset="utf-8"><title>Comparison</title><style>{STYLE}</style>',
             heading(results)]
    if results["parameter"]:
        parts += ["<h2>Over the values</h2>", picture(directory, "sweep")]
    for scene in results["scenes"]:
        parts += [f"<h2>{html.escape(scene)}</h2>", picture(directory, scene), table_of_scene(results, scene)]
        if len(results["methods"]) > 1:
            parts.append(tests_of_scene(results, scene))
    parts += [meanings(results), "</html>\n"]
    (directory / "report.html").write_text("\n".join(parts))
