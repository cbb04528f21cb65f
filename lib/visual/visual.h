/* Internal interface of visuals, shared by the files of lib/visual. A visual only reads the bodies
 * that it draws.
 *
 * config.c has the configuration and visual.c the public object with its list of sources. update.c
 * writes a frame, with one part per body. Threads, needles, graspers and capsules are lofts
 * (loft.c): sections moved along a line. The line of a thread comes from spline.c and thread.c,
 * those of rigid bodies from tools.c. patch.c makes curved patches from the triangles of a drain,
 * and drain.c makes a wall from the patches.
 *
 * Units are SI, and points are in world coordinates unless the comment says otherwise. All numbers
 * are double up to the vertex. Renderers want floats there, and a conversion rounds to the same
 * bits on every machine. */
#ifndef VBSS_VISUAL_VISUAL_H
#define VBSS_VISUAL_VISUAL_H

#include <vblast_ss/visual.h>

#include "base/linear.h"
#include "base/pi.h"
#include "base/slot.h"
#include "scene/api/inspect.h"

/* Sides of a section; points of one, where a seam or creases double some. Capacities, chosen. */
enum { VISUAL_MAX_SIDES = 64, VISUAL_MAX_SECTION_POINTS = VISUAL_MAX_SIDES + 8 };

/* The next three structs have the layout of the public views. */

typedef struct visual_vertex {
    float position[3], normal[3], texture[2], material[3], value;
} visual_vertex;

typedef struct visual_decal {
    float part, kind, material[3], radius;
} visual_decal;

typedef struct visual_part {
    uint32_t kind, source, body, first_vertex, vertex_count, first_triangle, triangle_count,
        reserved;
} visual_part;

/* Orientation of the first section of a thread's tube. The next frame starts from it. */
typedef struct visual_tube_start {
    const vbss_thread *thread;
    vec3 tangent, normal;
} visual_tube_start;

/* One frame. Items beyond a capacity are counted but not stored, and the frame is then
 * discarded. */
typedef struct visual_frame {
    visual_vertex *vertices;
    uint32_t (*triangles)[3];
    visual_part *parts;
    visual_decal *decals;
    visual_tube_start *tube_starts;
    uint32_t vertex_count, triangle_count, part_count, decal_count, tube_start_count;
} visual_frame;

/* A scene or body that the visual shows. */
typedef struct visual_source {
    uint32_t number; /* as reported to the host; 0: the entry is free */
    scene_handle_type type;
    const void *handle;
} visual_source;

typedef struct visual_object {
    vbss_context *context;
    vbss_visual_config config;
    vec3 origin;
    visual_source *sources;
    uint32_t last_source; /* largest number given so far */
    visual_frame frames[2];
    uint32_t front; /* index of the frame that hosts see */
    uint64_t generation, updates;

    /* Scratch, used within one update only. */
    vec3 *node_vectors; /* per node: second derivatives of a thread, or normals of a drain */
    double *elimination_ratios; /* per node: ratios of the elimination in spline.c */
} visual_object;

/* ---- config.c */

/* Reads a configuration of the host; NULL: the defaults. Returns VBSS_OK, VBSS_ERROR_STRUCT_SIZE,
 * VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_visual_read_config(vbss_context *context, const vbss_visual_config *config,
                                    vbss_visual_config *own);

/* ---- vertices and triangles */

/* A vertex before it is converted to floats. */
typedef struct visual_point {
    vec3 position, normal; /* m; unit */
    double texture[2];
    vec3 material;
    double value;
} visual_point;

/* Clamps, so that the conversion cannot overflow. */
static inline float visual_to_float(double x)
{
    return (float)vbss_min(vbss_max(x, -1e30), 1e30);
}

static inline void visual_store(float out[3], vec3 v)
{
    out[0] = visual_to_float(v.x);
    out[1] = visual_to_float(v.y);
    out[2] = visual_to_float(v.z);
}

/* Stores vertex number `index` if there is room for it. */
static inline void visual_set_vertex(const visual_object *v, visual_frame *f, uint32_t index,
                                     const visual_point *p)
{
    if (index < v->config.vertex_capacity) {
        visual_vertex *out = &f->vertices[index];
        visual_store(out->position, vec3_sub(p->position, v->origin));
        visual_store(out->normal, p->normal);
        out->texture[0] = visual_to_float(p->texture[0]);
        out->texture[1] = visual_to_float(p->texture[1]);
        visual_store(out->material, p->material);
        out->value = visual_to_float(p->value);
    }
}

/* Adds a triangle of three vertices, counter-clockwise seen from outside. */
static inline void visual_add_triangle(const visual_object *v, visual_frame *f, uint32_t a,
                                       uint32_t b, uint32_t c)
{
    if (f->triangle_count < v->config.triangle_capacity) {
        uint32_t *out = f->triangles[f->triangle_count];
        out[0] = a;
        out[1] = b;
        out[2] = c;
    }
    f->triangle_count++;
}

/* ---- visual.c */
extern const vbss_kind vbss_visual_kind_of_slot;

/* ---- update.c */

/* Begins a part. All vertices and triangles belong to it until the next part begins. */
void vbss_visual_begin_part(const visual_object *v, visual_frame *f, vbss_visual_kind kind,
                            uint32_t source, uint32_t body);
/* Adds a decal to the current part. `material` is a position at rest, m; `radius` is in m. */
void vbss_visual_add_decal(const visual_object *v, visual_frame *f, vbss_spot_kind kind,
                           vec3 material, double radius);
/* Whether the frame is within all capacities so far. */
bool vbss_visual_fits(const visual_object *v, const visual_frame *f);

/* ---- loft.c */

/* A section of a loft, for a ring of radius 1. The axes are those of a ring: its normal, then
 * tangent x normal. The points run counter-clockwise seen against the tangent. */
typedef struct visual_section {
    uint32_t count;
    double position[VISUAL_MAX_SECTION_POINTS][2], normal[VISUAL_MAX_SECTION_POINTS][2],
        perimeter_fraction[VISUAL_MAX_SECTION_POINTS];
    bool joins_next[VISUAL_MAX_SECTION_POINTS]; /* the surface continues to the next point */
    uint32_t dome_rings;                        /* rings of a dome of the same fineness */
} visual_section;

/* Makes a circular section that is as fine as tube_tolerance requires at this radius, m. */
void vbss_visual_round_section(const visual_object *v, double radius, visual_section *section);
/* Makes the section of a jaw: a semicircle with a flat side toward the other jaw. */
void vbss_visual_jaw_section(const visual_object *v, double radius, visual_section *section);

/* A position on the line, and the section there. */
typedef struct visual_ring {
    vec3 centre, tangent, normal; /* m; unit; unit, across the tangent: first axis of the section */
    double radius;                /* m */
    double radial, axial;         /* components of the surface's normal across and along the line */
    double arc_length, value;     /* m; value of the vertices */
} visual_ring;

/* A surface under construction, ring by ring. */
typedef struct visual_loft {
    const visual_object *v;
    visual_frame *frame;
    const visual_section *section;
    uint32_t previous;                   /* first vertex of the previous ring or pole */
    bool has_previous, previous_is_pole; /* a pole is a single vertex */
} visual_loft;

visual_loft vbss_visual_begin_loft(const visual_object *v, visual_frame *f,
                                   const visual_section *section);
/* Adds a ring and connects it to the previous one. */
void vbss_visual_add_ring(visual_loft *loft, const visual_ring *ring);
/* Adds a single vertex, at which the surface begins or ends. */
void vbss_visual_add_pole(visual_loft *loft, const visual_ring *ring);
/* Adds a hemisphere: before `ring` at the start of the line, or after it at the end. */
void vbss_visual_add_dome(visual_loft *loft, const visual_ring *ring, bool at_start);

/* A capsule, which may taper. */
typedef struct visual_capsule {
    vec3 start, end, tangent, normal; /* m; along the axis, unit; across it, unit */
    double radius, end_radius, value; /* m; value of the vertices */
} visual_capsule;

void vbss_visual_add_capsule(const visual_object *v, visual_frame *f, const visual_section *section,
                             const visual_capsule *capsule);
/* Length of a chord that deviates from a circle of this curvature (1/m) by the tolerance, m. */
double vbss_visual_max_chord(double curvature, double tolerance);

/* ---- spline.c: the natural cubic spline through the nodes of a thread */

/* Computes the second derivatives at the nodes, 1/m. The parameter is the rest length: `lengths`
 * has one per segment, m. `ratios` is scratch, one per node. */
void vbss_visual_solve_spline(const vec3 *x, const double *lengths, uint32_t node_count,
                              vec3 *second_derivatives, double *ratios);

typedef struct visual_segment {
    vec3 start, end, start_second_derivative, end_second_derivative; /* m; 1/m */
    double length;                                                   /* at rest, m */
} visual_segment;

/* Point of the spline at a fraction of the segment. At 0 and 1 it is the node, to the bit. */
vec3 vbss_visual_segment_point(const visual_segment *s, double fraction);
/* Derivative of the point with respect to the rest length. */
vec3 vbss_visual_segment_derivative(const visual_segment *s, double fraction);

/* ---- thread.c */

void vbss_visual_draw_thread(visual_object *v, visual_frame *f, const vbss_thread *thread);
/* Transports the normal of a rotation-minimising frame from one point of a line to another.
 * Tangents and normals are unit vectors. */
vec3 vbss_visual_transport_normal(vec3 from, vec3 tangent, vec3 normal, vec3 to,
                                  vec3 tangent_there);

/* ---- tools.c */

void vbss_visual_draw_needle(const visual_object *v, visual_frame *f, const vbss_needle *needle);
void vbss_visual_draw_grasper(const visual_object *v, visual_frame *f, const scene_grasper_info *g);
void vbss_visual_draw_rigid(const visual_object *v, visual_frame *f, const vbss_scene *scene,
                            const scene_body_info *body);

/* ---- patch.c: curved patches over triangles */

/* An edge of a patch: a cubic Bezier curve with end points (corners) and control points, m, and
 * quadratic normals with a control normal in the middle, unit. */
typedef struct visual_edge {
    vec3 corner[2], control[2], normal[2], middle_normal;
} visual_edge;

visual_edge vbss_visual_make_edge(const vec3 x[2], const vec3 normals[2]);
/* Point and unit normal at a fraction of the edge. */
vec3 vbss_visual_edge_point(const visual_edge *edge, double fraction, vec3 *normal);
/* Bound of the chord error, m: with n equal divisions, no chord is farther from the curve than this
 * divided by n^2. */
double vbss_visual_edge_chord_error(const visual_edge *edge);

typedef struct visual_patch {
    visual_edge edges[3]; /* edge k runs from corner k to the next one */
    vec3 centre;          /* inner control point, m */
} visual_patch;

visual_patch vbss_visual_make_patch(const visual_edge edges[3]);
/* Point and unit normal at barycentric coordinates. */
vec3 vbss_visual_patch_point(const visual_patch *patch, const double weights[3], vec3 *normal);

/* ---- drain.c */

void vbss_visual_draw_drain(visual_object *v, visual_frame *f, const scene_drain_info *d);

#endif
