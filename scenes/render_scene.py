"""The part of scenes/render that runs in Blender: blender -b SCENE.blend --python render_scene.py -- JSON

JSON holds the wishes (engine, percent, size, threads, the settings of the engine by their names; null: as the scene has
it) and the paths to write: exr, png, json (seconds of the render, of all processors' work for it, the peak memory in
bytes, the statistics) and, if passes of the gather are wished for, layers: an OpenEXR with all of them.
"""
import json
import resource
import sys
import time

import bpy


def set_up(scene, wishes):
    scene.render.engine = wishes["engine"]
    scene.render.resolution_percentage = wishes["percent"]
    if wishes["size"]:
        scene.render.resolution_x, scene.render.resolution_y = map(int, wishes["size"].split("x"))
    if wishes["threads"]:
        scene.render.threads_mode, scene.render.threads = "FIXED", wishes["threads"]
    if wishes["engine"] == "CYCLES":
        scene.cycles.use_denoising = False  # not every Blender is built with the denoiser
    settings = scene.gridgather if wishes["engine"] == "GRIDGATHER" else scene.cycles
    for name in ("preset", "method", "quality", "threshold", "noticeable", "use_masking", "gather_samples", "cell_size",
                 "samples"):
        if wishes[name] is not None:
            if not hasattr(settings, name):
                raise ValueError(f"{wishes['engine']} has no setting {name!r}")
            setattr(settings, name, wishes[name])
    if wishes["noticeable"] is not None:
        settings.use_perception = True


def write(scene, path, file_format, depth, mode="RGB"):
    """Save the finished picture; formats for display go through the scene's view transform."""
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth, settings.color_mode = file_format, depth, mode
    bpy.data.images["Render Result"].save_render(path, scene=scene)


def main():
    wishes = json.loads(sys.argv[sys.argv.index("--") + 1])
    scene = bpy.context.scene
    set_up(scene, wishes)
    for name in wishes["passes"]:
        setattr(scene.view_layers[0].gridgather, f"use_{name}", True)
    if wishes["passes"]:
        scene.render.filepath, scene.render.use_file_extension = wishes["layers"], False
        scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    start, work = time.monotonic(), time.process_time()
    bpy.ops.render.render(write_still=bool(wishes["passes"]))  # raises when the engine reports an error
    seconds, work = time.monotonic() - start, time.process_time() - work
    write(scene, wishes["exr"], "OPEN_EXR", "32")
    write(scene, wishes["png"], "PNG", "8")
    statistics = json.loads(getattr(scene, "gridgather_statistics", "") or "{}")
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    with open(wishes["json"], "w") as file:
        json.dump({"render": seconds, "work": work, "peak": peak, "statistics": statistics}, file)


main()
