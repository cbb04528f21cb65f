/* The inside of a visual, shared by the files of lib/visual. Nobody looks into it, and it changes nothing of what it shows.
 *
 * config.c says what a visual may be; visual.c makes, ends and shows it, and keeps the list of what it shows; update.c writes a
 * frame: a part for each body. Tubes, wires and jaws are lofts (loft.c): sections moved along a line. spline.c and thread.c make
 * the line of a thread, tools.c those of needles, graspers and capsules; patch.c makes curved patches of a drain's triangles,
 * drain.c a wall of them. Numbers are double until they are put into a vertex: renderers want floats, and a conversion
 * rounds to the same bits everywhere. */
#ifndef VBSS_VISUAL_VISUAL_H
#define VBSS_VISUAL_VISUAL_H

#include <vblast_ss/visual.h>

#include "base/linear.h"
#include "base/slot.h"
#include "scene/api/inspect.h"

/* Sides of a section; points of one, where a seam or creases double some. */
enum { VISUAL_MAX_SIDES = 64, VISUAL_MAX_SECTION_POINTS = VISUAL_MAX_SIDES + 8 };
#define VISUAL_PI 3.14159265358979323846

typedef struct visual_vertex {
    float position[3], normal[3], texture[2], material[3], value;
} visual_vertex;

typedef struct visual_decal {
    float part, kind, material[3], radius;
} visual_decal;

/* In the order of the view. */
typedef struct visual_part {
    uint32_t kind, source, body, first_vertex, vertex_count, first_triangle, triangle_count,
        reserved;
} visual_part;

/* How the first section of a thread's tube was turned in the last frame. */
typedef struct visual_tube_start {
    const vbss_thread *thread;
    vec3 tangent, normal;
} visual_tube_start;

/* One frame. Counts go on beyond what there is room for: then the frame is thrown away. */
typedef struct visual_frame {
    visual_vertex *vertices;
    uint32_t (*triangles)[3];
    visual_part *parts;
    visual_decal *decals;
    visual_tube_start *tube_starts;
    uint32_t vertex_count, triangle_count, part_count, decal_count, tube_start_count;
} visual_frame;

typedef struct visual_source {
    uint32_t number; /* 0: the place is free */
    scene_handle_type type;
    const void *handle;
} visual_source;

typedef struct visual_object {
    vbss_context *context;
    vbss_visual_config config;
    vec3 origin;
    visual_source *sources;
    uint32_t last_source;
    visual_frame frames[2];
    uint32_t front; /* of the two, the one that is shown */
    uint64_t generation, updates;

    /* room for an update: nothing here outlives it */
    vec3 *node_vectors;         /* second derivatives at a thread's nodes; normals at a drain's */
    double *elimination_ratios; /* of elimination */
} visual_object;

/* ---- config.c: the caller's over the defaults, every number checked */
vbss_result vbss_visual_read_config(vbss_context *context, const vbss_visual_config *config,
                                    vbss_visual_config *own);

/* ---- putting things into a frame */

typedef struct visual_point {
    vec3 position, normal; /* in the world; unit */
    double texture[2];
    vec3 material;
    double value;
} visual_point;

/* What is beyond any scene is drawn at its edge. */
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
/* A part begins, with what comes from here on; it ends where the next one begins. */
void vbss_visual_begin_part(const visual_object *v, visual_frame *f, vbss_visual_kind kind,
                            uint32_t source, uint32_t body);
/* On the part that was begun last. */
void vbss_visual_add_decal(const visual_object *v, visual_frame *f, vbss_spot_kind kind,
                           vec3 material, double radius);
/* Nothing is shown of what does not fit. */
bool vbss_visual_fits(const visual_object *v, const visual_frame *f);

/* ---- loft.c: a section, in shares of a ring's radius, counter-clockwise seen against the way of the line */
typedef struct visual_section {
    uint32_t count;
    double position[VISUAL_MAX_SECTION_POINTS][2], normal[VISUAL_MAX_SECTION_POINTS][2],
        perimeter_fraction[VISUAL_MAX_SECTION_POINTS];
    bool joins_next[VISUAL_MAX_SECTION_POINTS]; /* with the next point */
    uint32_t dome_rings;                        /* rings of a quarter of a circle as fine as this */
} visual_section;
/* Round, as fine as the tolerance asks at that radius. */
void vbss_visual_round_section(const visual_object *v, double radius, visual_section *section);
/* Of a jaw: half round, and flat toward the other one. */
void vbss_visual_jaw_section(const visual_object *v, double radius, visual_section *section);

/* A place on the line, and the section there. */
typedef struct visual_ring {
    vec3 centre, tangent,
        normal; /* unit; the section's first axis is the normal, the second tangent x normal */
    double radius;
    double radial, axial; /* of the surface's normal, across the line and along it */
    double arc_length, value;
} visual_ring;

typedef struct visual_loft {
    const visual_object *v;
    visual_frame *frame;
    const visual_section *section;
    uint32_t previous;                   /* first vertex of the ring before */
    bool has_previous, previous_is_pole; /* there is one; it is a single point */
} visual_loft;
visual_loft vbss_visual_begin_loft(const visual_object *v, visual_frame *f,
                                   const visual_section *section);
void vbss_visual_add_ring(visual_loft *loft, const visual_ring *ring);
/* A single point, where the surface begins or ends. */
void vbss_visual_add_pole(visual_loft *loft, const visual_ring *ring);
/* Half a ball before the ring that comes next, or behind the last one. */
void vbss_visual_add_dome(visual_loft *loft, const visual_ring *ring, bool at_start);
/* A capsule: rings at both ends of its axis, and domes. `normal` is across the axis. */
typedef struct visual_capsule {
    vec3 start, end, tangent, normal;
    double radius, end_radius, value;
} visual_capsule;
void vbss_visual_add_capsule(const visual_object *v, visual_frame *f, const visual_section *section,
                             const visual_capsule *capsule);
/* Chords of a circle of that curvature that keep the tolerance: how long they may be. */
double vbss_visual_max_chord(double curvature, double tolerance);

/* ---- spline.c: the natural cubic spline through nodes, with rest lengths as its parameter */
/* Second derivatives at the nodes, by elimination; `ratios` is room for as many numbers. */
void vbss_visual_solve_spline(const vec3 *x, const double *lengths, uint32_t node_count,
                              vec3 *second_derivatives, double *ratios);
/* Of a segment, at that share of its length: place, and derivative by length. At 0 and 1 the place is the node, to the bit. */
typedef struct visual_segment {
    vec3 start, end, start_second_derivative, end_second_derivative;
    double length;
} visual_segment;
vec3 vbss_visual_segment_point(const visual_segment *s, double fraction);
vec3 vbss_visual_segment_derivative(const visual_segment *s, double fraction);

/* ---- thread.c */
void vbss_visual_draw_thread(visual_object *v, visual_frame *f, const vbss_thread *thread);
/* The normal of a frame at the next place of a line, turned as little as can be about it. */
vec3 vbss_visual_transport_normal(vec3 from, vec3 tangent, vec3 normal, vec3 to,
                                  vec3 tangent_there);

/* ---- tools.c */
void vbss_visual_draw_needle(const visual_object *v, visual_frame *f, const vbss_needle *needle);
void vbss_visual_draw_grasper(const visual_object *v, visual_frame *f, const scene_grasper_info *g);
void vbss_visual_draw_rigid(const visual_object *v, visual_frame *f, const vbss_scene *scene,
                            const scene_body_info *body);

/* ---- patch.c: a curved patch over a triangle */
/* A side: its curve's inner points, the middle of its normals. */
typedef struct visual_edge {
    vec3 corner[2], control[2], normal[2], middle_normal;
} visual_edge;
visual_edge vbss_visual_make_edge(const vec3 x[2], const vec3 normals[2]);
vec3 vbss_visual_edge_point(const visual_edge *edge, double fraction, vec3 *normal);
/* No chord is farther from its part of the curve than this divided by the square of the number of parts. */
double vbss_visual_edge_chord_error(const visual_edge *edge);
typedef struct visual_patch {
    visual_edge edges[3]; /* from corner k to the next one */
    vec3 centre;
} visual_patch;
visual_patch vbss_visual_make_patch(const visual_edge edges[3]);
vec3 vbss_visual_patch_point(const visual_patch *patch, const double weights[3], vec3 *normal);

/* ---- drain.c */
void vbss_visual_draw_drain(visual_object *v, visual_frame *f, const scene_drain_info *d);

#endif
