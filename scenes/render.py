"""Render a scene in Blender's background mode: a 32-bit OpenEXR, a PNG as Blender shows it, and the times it took.

scenes/render builds the project first and then calls this. See --help.
"""
import argparse
import json
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scene_files as files


def parse(arguments):
    parser = argparse.ArgumentParser(prog="scenes/render", description=__doc__.splitlines()[0])
    parser.add_argument("scene", choices=files.scene_names())
    parser.add_argument("--engine", default="GRIDGATHER", help="GRIDGATHER or CYCLES")
    parser.add_argument("--percent", type=int, default=100, help="size of the picture, of the scene's own")
    parser.add_argument("--preset", help="scene.gridgather.preset: DRAFT, PREVIEW, FINAL or PAPER")
    parser.add_argument("--method", help="scene.gridgather.method")
    parser.add_argument("--quality", type=float, help="scene.gridgather.quality")
    parser.add_argument("--samples", type=int, help="samples a pixel")
    parser.add_argument("--threads", type=int, help="number of threads (default: all)")
    parser.add_argument("--out", type=Path, default=files.BUILD / "renders", help="folder of the pictures")
    return parser.parse_args(arguments)


def output_stem(options):
    """Path of the products without their suffix; it names every option that changes the picture."""
    parts = [options.scene, options.engine, options.preset, options.method]
    parts += [f"q{options.quality}" if options.quality else None, f"s{options.samples}" if options.samples else None]
    parts += [f"{options.percent}pc" if options.percent != 100 else None]
    return options.out.absolute() / "-".join(str(part).lower() for part in parts if part)


def render(options):
    """Render; returns {"exr", "png": path, "whole": seconds, "render": seconds, "statistics": {view layer: table}}."""
    stem = output_stem(options)
    stem.parent.mkdir(parents=True, exist_ok=True)
    products = {kind: stem.with_name(f"{stem.name}.{kind}") for kind in ("exr", "png", "json")}
    for product in products.values():
        product.unlink(missing_ok=True)
    wishes = {key: getattr(options, key) for key in ("engine", "percent", "preset", "method", "quality", "samples",
                                                     "threads")}
    wishes.update(exr=str(products["exr"]), png=str(products["png"]), json=str(products["json"]))
    arguments = ["--addons", "gridgather"] if options.engine == "GRIDGATHER" else []
    arguments += [files.scene_file(options.scene), "--python", files.SCENES / "render_scene.py", "--",
                  json.dumps(wishes)]
    start = time.monotonic()
    files.run_blender(arguments, {"BLENDER_USER_SCRIPTS": str(files.BUILD / "scripts")})
    whole = time.monotonic() - start
    for product in products.values():
        if not product.exists():
            raise files.SceneError(f"Blender ended without writing {product}")
    return {"whole": whole, **json.loads(products["json"].read_text()),
            "exr": str(products["exr"]), "png": str(products["png"])}


def flat(table, prefix=""):
    """(dotted name, value) for every leaf of nested dictionaries."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def report(result):
    for layer, table in result["statistics"].items():
        print(f"{layer}:")
        for name, value in flat(table):
            print(f"  {name:36} {value:>14,.3f}" if isinstance(value, float) else f"  {name:36} {value!s:>14}")
    print(f"{'render':38} {result['render']:14.2f} s\n{'whole process':38} {result['whole']:14.2f} s")
    print(f"{result['exr']}\n{result['png']}")


if __name__ == "__main__":
    try:
        report(render(parse(sys.argv[1:])))
    except files.SceneError as error:
        sys.exit(str(error))
