/* Gridgather's C interface: the only face of the library.
 *
 * Order of calls: gg_scene_create, any gg_scene_add_... and gg_scene_set_..., then gg_render_start as often as wanted
 * (the scene is frozen by the first), gg_render_... while a render runs, gg_render_destroy, gg_scene_destroy.
 *
 * Conventions. Lengths in metres, Z up, right-handed. Matrices are 3x4, row-major, object to world. Colours are
 * scene-linear Rec.709. Power in watts, radiance in W/(m2 sr), as Cycles reads and writes them. Arrays are
 * C-contiguous, are read during the call and copied: the caller keeps them. Strings are UTF-8; a null string reads as
 * "". Structs are plain data; a struct that is all zero but for the fields named as required is valid.
 *
 * Errors. Every function that can fail returns a gg_status and changes nothing when it fails; gg_last_error() then
 * has a sentence about it. No function throws, prints or ends the process. A scene or render belongs to one calling
 * thread at a time; gg_render_cancel and gg_render_poll may be called from any thread.
 */
#ifndef GRIDGATHER_H
#define GRIDGATHER_H

#include <stdint.h>

#if defined(_WIN32)
#define GG_API __declspec(dllexport)
#else
#define GG_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define GG_INTERFACE_VERSION 6
#define GG_NONE 0xFFFFFFFFu /* no image, no material */

typedef enum gg_status {
    GG_OK = 0,
    GG_CANCELLED = 1,        /* gg_render_cancel was called */
    GG_INVALID_ARGUMENT = 2, /* null pointer, bad size, unknown id, number out of range */
    GG_WRONG_STATE = 3,      /* call out of order: adding to a frozen scene, reading an unfinished render */
    GG_INVALID_SCENE = 4,    /* nothing can be rendered: no camera, ... */
    GG_OUT_OF_MEMORY = 5,
    GG_INTERNAL_ERROR = 6, /* a bug of the library */
    GG_IO_ERROR = 7        /* a file cannot be written */
} gg_status;

typedef struct gg_scene gg_scene;
typedef struct gg_render gg_render;

/* GG_INTERFACE_VERSION of the library: a caller built for another must not go on. */
GG_API uint32_t gg_interface_version(void);
/* "0.1.0 (Embree 3.13.5, OpenImageIO 2.4.7)": for bug reports. Static. */
GG_API const char* gg_version(void);
/* 1 when this processor has the instructions that the library was built for; nothing else may be called when 0. */
GG_API int gg_processor_supported(void);
/* About the last failed call of this thread; valid until its next failing call. Never null. */
GG_API const char* gg_last_error(void);

/* ---- scene: description ---- */

GG_API gg_status gg_scene_create(gg_scene** scene);
GG_API void gg_scene_destroy(gg_scene* scene); /* null is fine; renders of it must be destroyed before */

typedef enum gg_color_space { GG_COLOR_SRGB = 0, GG_COLOR_LINEAR = 1 } gg_color_space;
typedef enum gg_extension {
    GG_EXTENSION_REPEAT = 0,
    GG_EXTENSION_EXTEND = 1,
    GG_EXTENSION_CLIP = 2,
    GG_EXTENSION_MIRROR = 3
} gg_extension;
typedef enum gg_filter_mode { GG_FILTER_LINEAR = 0, GG_FILTER_CLOSEST = 1 } gg_filter_mode;

/* An image: a file (path) or, when path is null, pixels. A file that cannot be read becomes a message and reads as
 * magenta, like Cycles. */
typedef struct gg_image {
    const char* name;       /* shown in messages */
    const char* path;       /* absolute, or null */
    const float* pixels;    /* (height, width, 4) RGBA, bottom row first; values in `color_space` */
    uint32_t width, height; /* of pixels, >= 1 */
    int32_t color_space;    /* gg_color_space, of file or pixels */
    int32_t extension;      /* gg_extension, outside of [0,1] */
    int32_t filter_mode;    /* gg_filter_mode */
} gg_image;

GG_API gg_status gg_scene_add_image(gg_scene* scene, const gg_image* image, uint32_t* image_id);

/* A colour: `factor` alone, or factor times the image's colour at uv_map applied to the surface's texture coordinates.
 */
typedef struct gg_color_input {
    float factor[3]; /* >= 0, finite */
    uint32_t image;  /* image id or GG_NONE */
    float uv_map[6]; /* 2x3 row-major: u' = m0 u + m1 v + m2, v' = m3 u + m4 v + m5; all zero reads as identity */
} gg_color_input;

/* Diffuse reflector and emitter, both sides alike. */
typedef struct gg_material {
    const char* name;
    gg_color_input reflectance; /* clamped to [0, 0.99] where used */
    gg_color_input emission;    /* radiance, W/(m2 sr) */
} gg_material;

GG_API gg_status gg_scene_add_material(gg_scene* scene, const gg_material* material, uint32_t* material_id);

/* Triangles in Blender's layout: corners are Blender's loops. Triangles that use a vertex twice, have no area, or a
 * coordinate that is not finite are dropped with a message. */
typedef struct gg_mesh {
    const char* name;
    uint32_t vertex_count;
    const float* positions; /* (vertex_count, 3) */
    uint32_t triangle_count;
    const uint32_t* triangle_vertices; /* (triangle_count, 3) < vertex_count */
    const uint32_t* triangle_corners;  /* (triangle_count, 3) < corner_count; null when corner_count is 0 */
    const uint32_t* triangle_slots;    /* (triangle_count) material slot; null: all 0 */
    uint32_t corner_count;             /* 0: flat shading, no texture coordinates */
    const float* corner_normals;       /* (corner_count, 3) shading normals, or null: flat */
    const float* corner_uvs;           /* (corner_count, 2), or null: (0, 0) */
} gg_mesh;

GG_API gg_status gg_scene_add_mesh(gg_scene* scene, const gg_mesh* mesh, uint32_t* mesh_id);

enum { /* gg_instances.flags: what kind of ray does not see the instance */
       GG_HIDDEN_FROM_CAMERA = 1,
       GG_HIDDEN_FROM_LIGHT = 2 /* neither receives senders' rays, nor casts shadows, nor sends light */
};

/* `count` placed meshes. Instances with the same material slots share one list of materials. */
typedef struct gg_instances {
    uint32_t count;
    const uint32_t* meshes;     /* (count) mesh ids */
    const float* matrices;      /* (count, 3, 4) */
    const uint64_t* stable_ids; /* (count) same thing, same id in every frame and session; distinct; null: index */
    const uint32_t* flags;      /* (count) or null: all 0 */
    const char* const* names;   /* (count), shown in messages; null: mesh names */
    uint32_t slot_count;        /* material slots of every instance in this call */
    const uint32_t*
        materials; /* (slot_count) material ids or GG_NONE (grey 0.8); a slot beyond the end reads the last */
} gg_instances;

GG_API gg_status gg_scene_add_instances(gg_scene* scene, const gg_instances* instances);

typedef enum gg_light_type { GG_LIGHT_POINT = 0, GG_LIGHT_SPOT = 1, GG_LIGHT_SUN = 2, GG_LIGHT_AREA = 3 } gg_light_type;
typedef enum gg_area_shape { GG_AREA_RECTANGLE = 0, GG_AREA_ELLIPSE = 1 } gg_area_shape;

/* A lamp. Shines along its -Z axis (spot, sun, area). The matrix may scale area lights, as in Blender. */
typedef struct gg_light {
    const char* name;
    int32_t type; /* gg_light_type */
    float matrix[12];
    float power[3];       /* W times colour; sun: irradiance [W/m2] times colour on a surface that faces it */
    float radius;         /* m, point and spot, >= 0 */
    int32_t soft_falloff; /* point and spot; 1: a disk of that radius that faces every receiver, 0: a sphere */
    float size_x, size_y; /* m, area: full widths along the lamp's X and Y */
    int32_t shape;        /* gg_area_shape */
    float spot_angle;     /* rad, full cone, (0, pi] */
    float spot_blend;     /* 0..1 */
    float angle;          /* rad, sun's full angular diameter, [0, pi] */
    uint64_t stable_id;
} gg_light;

GG_API gg_status gg_scene_add_light(gg_scene* scene, const gg_light* light);

/* The world's uniform radiance, W/(m2 sr). */
GG_API gg_status gg_scene_set_world(gg_scene* scene, const float radiance[3]);

/* Something that the caller could not convert: goes into the list that gg_render_message reads. */
GG_API gg_status gg_scene_add_message(gg_scene* scene, const char* object, const char* text);

/* ---- render ---- */

typedef enum gg_camera_type { GG_CAMERA_PERSPECTIVE = 0, GG_CAMERA_ORTHOGRAPHIC = 1 } gg_camera_type;

/* Looks along its -Z axis. The window is what the full picture covers: in the plane at distance 1 (perspective), or in
 * metres (orthographic), as x_left, x_right, y_bottom, y_top in camera space. */
typedef struct gg_camera {
    int32_t type;     /* gg_camera_type */
    float matrix[12]; /* camera to world; its scale is ignored */
    float window[4];
    float clip_start, clip_end; /* m along the view direction, 0 <= start < end */
} gg_camera;

/* GATHER: final gather; SOLUTION: the interpolated radiosity solution; FULL: every sender anew at every point, slow. */
typedef enum gg_method { GG_METHOD_GATHER = 0, GG_METHOD_SOLUTION = 1, GG_METHOD_FULL = 2 } gg_method;

/* Where sites of the final gather stand: on surfaces where their triangles are larger than cells of the grid over the
 * picture (FREE_SPACE: where the solution's elements are as fine as these) and at the grid's vertices elsewhere, or at
 * the grid's alone. */
typedef enum gg_sites { GG_SITES_SURFACES_AND_GRID = 0, GG_SITES_GRID = 1 } gg_sites;

/* From where sites of the final gather look around: from visible surfaces, or as published, from points in free space
 * with counted hits and an error bound for each sender by itself. */
typedef enum gg_receivers { GG_RECEIVERS_VISIBLE = 0, GG_RECEIVERS_FREE_SPACE = 1 } gg_receivers;

/* Layers of the gather's grid: cells keep their shape, or even steps of 1/depth as published. */
typedef enum gg_depth_law { GG_DEPTH_LOGARITHMIC = 0, GG_DEPTH_RECIPROCAL = 1 } gg_depth_law;

/* Passes besides "Combined" that a render keeps if asked to; all have one value a pixel, of all points in it at which
 * light was gathered. SOLUTION gathers nothing: 0. */
typedef enum gg_pass {
    GG_PASS_VISIBILITY_SAMPLES = 1,  /* "Visibility Samples": rays to senders, the sky and what is near */
    GG_PASS_FORM_FACTOR_SAMPLES = 2, /* "Form Factor Samples": form factors worked out */
    GG_PASS_RESAMPLED_SENDERS = 4,   /* "Resampled Senders": looked at anew, mean over the pixel's points */
    GG_PASS_CELL_LINES = 8,          /* "Cell Lines": 1 where the pixel to the right or above lies in another cell */
    GG_PASS_SURFACE_SITES = 16,      /* "Surface Sites": share of its light from sites on surfaces; the rest: the grid's */
    /* 0 without a display, and but for the final gather: */
    GG_PASS_THRESHOLD_ELEVATION = 32,  /* "Threshold Elevation": factor by which patterns hide errors, 1..10 */
    GG_PASS_ADAPTATION_LUMINANCE = 64, /* "Adaptation Luminance": that an eye is used to which looks there, cd/m2 */
    GG_PASS_SITE_THRESHOLD = 128       /* "Site Threshold": error of radiosity that one sender may have, W/m2 */
} gg_pass;

/* Curves that pixels go through before all else: channel c of a pixel becomes
 * x = (pixel - black[c]) / (white[c] - black[c]), and then what its curve has at x. */
typedef struct gg_curves {
    const float* values;             /* 3 * size: of red, green, blue, at even steps from range[0] to range[1] */
    uint32_t size;                   /* 2..65536 */
    float range[2];                  /* finite, the first one less */
    float slopes[6];                 /* beyond the range, red's below and above, green's, blue's; finite */
    float black[3], white[3];        /* finite */
} gg_curves;

/* How a picture is shown and looked at: errors that nobody sees there are left. */
typedef struct gg_display {
    const char* config;      /* path of an OpenColorIO configuration; "": sRGB with white at 1 */
    const char* device;      /* of the configuration: display, view and look; "": no look */
    const char* view;
    const char* look;
    float exposure;          /* stops, -64..64 */
    float gamma;             /* 0: 1; 0.01..100 */
    float white;             /* of the display, cd/m2; 0: 100; 1e-3..1e6 */
    float black;             /* the same, added to everything, 0..1e6 */
    float pixels_per_degree; /* of the visual field; 0: 40; 1..1e4 */
    const gg_curves* curves; /* null: none */
} gg_display;

/* What the display gets for scene-linear pixels, 3 * count values that are replaced, 0..1. Fails if the configuration
 * cannot be read, or has no such display, view or look. */
GG_API gg_status gg_display_encode(const gg_display* display, float* pixels, uint64_t count);

/* A render's numbers. Required: width, height, method. */
typedef struct gg_settings {
    int32_t method;           /* gg_method */
    uint32_t width, height;   /* of the full picture, 1..65536 */
    uint32_t crop[4];         /* x, y, width, height in pixels from the lower left; all zero: everything */
    float quality;            /* error of an element's radiosity as a share of the reference white; 0: 0.02; 0.001..1 */
    uint32_t samples;         /* coverage samples a pixel, 1..256; 0: 16 */
    float filter_width;       /* as Cycles' setting, pixels; 0: 1.5 */
    int32_t filter_type;      /* 0 Blackman-Harris, 1 Gauss, 2 box */
    float exposure;           /* factor on every pixel, 0: 1 */
    int32_t film_transparent; /* 1: the world behind is alpha 0 */
    int32_t threads;          /* 0: all cores */
    uint32_t passes;          /* gg_pass, added up */
    int32_t sites;            /* gg_sites */
    int32_t receivers;        /* gg_receivers */
    int32_t depth_law;        /* gg_depth_law */
    float cell_size;          /* of the gather's grid, pixels of a picture whose shorter side has 350, but never less than
                               * 4 pixels of this one; 0: 20; 4..200 */
    float threshold;          /* error that one sender may have, share of the local radiosity; 0: 0.03; 1e-4..1 */
    uint32_t gather_samples;  /* visibility rays from a point, about; 0: 512; 16..4096 */
    const gg_display* display; /* null: `threshold` counts. Otherwise errors are judged as they are shown, and renders
                                * go on as with sRGB, with a message, where its configuration cannot be used */
    float noticeable;          /* error that one sender may have, in just noticeable differences; 0: 0.25; 0.01..100 */
    int32_t use_masking;       /* 1: larger ones where patterns hide them */
} gg_settings;

/* Copies what it needs, validates, starts the work on the library's own threads and returns at once. Lighting that an
 * earlier render of this scene solved for the same quality is reused. */
GG_API gg_status gg_render_start(gg_scene* scene, const gg_camera* camera, const gg_settings* settings,
                                 gg_render** render);

/* Writes all that gg_render_start would take into a file, as long as the scene is not frozen: what a render does can
 * then be looked at without the caller. Images with a path stay where they are. */
GG_API gg_status gg_scene_capture(gg_scene* scene, const gg_camera* camera, const gg_settings* settings,
                                  const char* path);

typedef struct gg_progress {
    int32_t finished; /* 1: the result, a failure or a cancel is final */
    int32_t status;   /* gg_status of the render when finished */
    float fraction;   /* 0..1 */
    uint32_t finished_tiles, tiles;
    uint64_t memory, peak_memory; /* bytes of the library's own data */
    char stage[64];
} gg_progress;

GG_API gg_status gg_render_poll(gg_render* render, gg_progress* progress);
/* Waits until finished, at most `seconds`. */
GG_API gg_status gg_render_wait(gg_render* render, float seconds);
GG_API gg_status gg_render_cancel(gg_render* render);
/* What went wrong, when poll says finished with a status that is not GG_OK. Valid until destroy. Never null. */
GG_API const char* gg_render_error(gg_render* render);
/* Cancels, waits for the threads and frees. Null is fine. */
GG_API void gg_render_destroy(gg_render* render);

/* A finished tile in pixels from the lower left of the crop. */
typedef struct gg_tile {
    uint32_t x, y, width, height;
} gg_tile;

/* The next finished tile in order of finishing; *found 0 when there is none (now). */
GG_API gg_status gg_render_next_tile(gg_render* render, gg_tile* tile, int32_t* found);
/* Copies a rectangle of a pass, bottom row first: "Combined" (height, width, 4), scene-linear, premultiplied; any other
 * that the render keeps (height, width). Pixels of unfinished tiles are 0. */
GG_API gg_status gg_render_read(gg_render* render, const char* pass, const gg_tile* rectangle, float* values);

/* Statistics of a finished render as a JSON object: {"stages": {name: seconds}, "counts": {name: number},
 * "memory": {name: bytes}}. Valid until destroy. */
GG_API gg_status gg_render_statistics(gg_render* render, const char** json);

/* Recoverable problems, one per (text, object), found so far. */
typedef struct gg_message {
    char object[128];
    char text[256];
    uint32_t count; /* how often */
} gg_message;

GG_API gg_status gg_render_message(gg_render* render, uint32_t index, gg_message* message, int32_t* found);

#ifdef __cplusplus
}
#endif

#endif
