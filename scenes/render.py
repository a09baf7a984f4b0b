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

# from the exported arrays to converged light
SOLVE_STAGES = ("build scene", "textures", "trace: build", "clusters", "refine", "gather", "faces", "interpolate")
# from converged light to the picture
GATHER_STAGES = ("visible points", "classification", "shading")


def parse(arguments):
    parser = argparse.ArgumentParser(prog="scenes/render", description=__doc__.splitlines()[0])
    parser.add_argument("scene", choices=files.all_scene_names())
    parser.add_argument("--engine", default="GRIDGATHER", help="GRIDGATHER or CYCLES")
    parser.add_argument("--percent", type=int, default=100, help="size of the picture, of the scene's own")
    parser.add_argument("--size", help="the picture's own size in pixels instead of the scene's: WIDTHxHEIGHT")
    parser.add_argument("--preset", help="scene.gridgather.preset: DRAFT, PREVIEW, FINAL or PAPER")
    parser.add_argument("--method", help="scene.gridgather.method")
    parser.add_argument("--quality", type=float, help="scene.gridgather.quality")
    parser.add_argument("--threshold", type=float, help="scene.gridgather.threshold")
    parser.add_argument("--noticeable", type=float, help="scene.gridgather.noticeable, with use_perception")
    parser.add_argument("--no-masking", dest="use_masking", action="store_false", default=None,
                        help="leave scene.gridgather.use_masking out")
    parser.add_argument("--gather-samples", type=int, help="scene.gridgather.gather_samples")
    parser.add_argument("--cell-size", type=float, help="scene.gridgather.cell_size")
    parser.add_argument("--samples", type=int, help="samples a pixel")
    parser.add_argument("--passes", nargs="+", default=[], metavar="PASS",
                        help="of the gather, as visibility_samples: into a multi-layer OpenEXR besides")
    parser.add_argument("--threads", type=int, help="number of threads (default: all)")
    parser.add_argument("--out", type=Path, default=files.BUILD / "renders", help="folder of the pictures")
    return parser.parse_args(arguments)


def output_stem(options):
    """Path of the products without their suffix; it names every option that changes the picture."""
    parts = [options.scene, options.engine, options.preset, options.method]
    parts += [f"{letter}{value}" for letter, value in (("q", options.quality), ("t", options.threshold),
                                                       ("j", options.noticeable), ("g", options.gather_samples),
                                                       ("c", options.cell_size), ("s", options.samples)) if value]
    parts += ["unmasked" if options.use_masking is False else None, options.size]
    parts += [f"{options.percent}pc" if options.percent != 100 else None]
    return options.out.absolute() / "-".join(str(part).lower() for part in parts if part)


def render(options):
    """Render a scene of scene_files; returns what render_file returns."""
    return render_file(files.scene_file(options.scene), output_stem(options), options)


def render_file(blend, stem, options):
    """Render a .blend file; the products' paths are `stem` and a suffix.

    Returns {"exr", "png", with passes "layers": path, "whole", "render", "work": seconds, "peak": bytes,
    "statistics": {view layer: table}}.
    """
    stem.parent.mkdir(parents=True, exist_ok=True)
    products = {kind: stem.with_name(f"{stem.name}.{kind}") for kind in ("exr", "png", "json")}
    if options.passes:
        products["layers"] = stem.with_name(f"{stem.name}-passes.exr")
    for product in products.values():
        product.unlink(missing_ok=True)
    wishes = {key: value for key, value in vars(options).items() if key not in ("scene", "out")}
    wishes.update({kind: str(product) for kind, product in products.items()})
    arguments = ["--addons", "gridgather"] if options.engine == "GRIDGATHER" else []
    arguments += [blend, "--python", files.SCENES / "render_scene.py", "--", json.dumps(wishes)]
    start = time.monotonic()
    files.run_blender(arguments, {"BLENDER_USER_SCRIPTS": str(files.BUILD / "scripts")})
    whole = time.monotonic() - start
    for product in products.values():
        if not product.exists():
            raise files.SceneError(f"Blender ended without writing {product}")
    return {"whole": whole, **json.loads(products["json"].read_text()),
            **{kind: str(product) for kind, product in products.items() if kind != "json"}}


def flat(table, prefix=""):
    """(dotted name, value) for every leaf of nested dictionaries."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def stages(result):
    """{stage: seconds} of a render's only view layer; empty for other engines."""
    return next(iter(result["statistics"].values()), {}).get("stages", {})


def counts(result):
    """{what: how many} of a render's only view layer; empty for other engines."""
    return next(iter(result["statistics"].values()), {}).get("counts", {})


def solve_seconds(result):
    return sum(seconds for stage, seconds in stages(result).items() if stage in SOLVE_STAGES)


def gather_seconds(result):
    return sum(seconds for stage, seconds in stages(result).items() if stage in GATHER_STAGES)


def report(result):
    for layer, table in result["statistics"].items():
        print(f"{layer}:")
        for name, value in flat(table):
            print(f"  {name:36} {value:>14,.3f}" if isinstance(value, float) else f"  {name:36} {value!s:>14}")
    print(f"{'render':38} {result['render']:14.2f} s\n{'whole process':38} {result['whole']:14.2f} s")
    print(f"{'peak memory':38} {result['peak'] / 1e6:14.0f} MB")
    print(f"{result['exr']}\n{result['png']}")


if __name__ == "__main__":
    try:
        report(render(parse(sys.argv[1:])))
    except files.SceneError as error:
        sys.exit(str(error))
