"""All figures of a gallery on sheets, to be looked at: python3 contact.py OUT [COLUMNS ROWS] writes OUT/contact-1.png, ..."""
import html, json, pathlib, subprocess, sys

out = pathlib.Path(sys.argv[1]).resolve()
columns, rows = map(int, sys.argv[2:4]) if len(sys.argv) > 3 else (3, 4)
WIDE, HIGH = 640, 520  # px of a cell

cells = []
for entry in json.loads((out / "gallery.json").read_text())["entries"]:
    title = html.escape(f"{entry['id']}: {entry['title']} ({entry['verdict_words']})")
    for figure in entry["figures"]:
        why = figure.get("failure")
        for file in figure["files"]:
            picture = out / "figures" / (file["name"] + (".png" if file["raster"] else ".svg"))
            body = f'<img src="{picture.as_uri()}">' if picture.exists() else f"missing: {html.escape(file.get('missing', ''))}"
            cells.append(f"<div><p>{title}</p>{body}</div>")
        if figure.get("table"):
            lines = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>"
                            for row in [figure["table"]["head"], *figure["table"]["rows"]])
            cells.append(f"<div><p>{title}</p><table>{lines}</table></div>")
        if why:
            cells.append(f"<div><p>{title}</p>{html.escape(why)}</div>")

style = f"""body {{ margin: 0; display: grid; grid-template-columns: repeat({columns}, {WIDE}px); grid-auto-rows: {HIGH}px; font: 13px sans-serif }}
div {{ overflow: hidden; border: 1px solid #ccc; padding: 4px; box-sizing: border-box }} p {{ margin: 0 0 4px; font-weight: bold }}
img {{ max-width: 100%; max-height: {HIGH - 40}px }} td {{ border: 1px solid #ccc; padding: 1px 4px; font-size: 11px }}"""
for n, first in enumerate(range(0, len(cells), columns * rows), 1):
    page = out / f"contact-{n}.html"
    page.write_text(f"<meta charset=utf-8><style>{style}</style>" + "".join(cells[first:first + columns * rows]))
    sheet = out / f"contact-{n}.png"
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--virtual-time-budget=8000",
                    f"--window-size={columns * WIDE},{rows * HIGH}", f"--screenshot={sheet}", page.as_uri()], check=True, capture_output=True)
    page.unlink()
    print(sheet)
